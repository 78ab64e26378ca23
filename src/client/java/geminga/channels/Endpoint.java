package geminga.channels;

import geminga.protocol.Addresses;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.SocketAddress;
import java.net.UnixDomainSocketAddress;
import java.util.List;

/** Endpoints of daemons: {@code ADDRESS:PORT}, {@code [ADDRESS]:PORT}, {@code /PATH} or {@code unix:PATH}. */
public final class Endpoint {
    private static final String SCHEME = "unix:";

    private Endpoint() {}

    /** The addresses to try, in this order: that of the text, or the usual ones of gemingad if it is empty. */
    public static List<SocketAddress> of(String text) {
        if (text.isEmpty()) return List.of(tcp("127.0.0.1:4717"), tcp("[::1]:4717"));
        String path = text.startsWith(SCHEME) ? text.substring(SCHEME.length()) : text;
        if (text.startsWith(SCHEME) || text.startsWith("/")) {
            if (path.isEmpty() || path.indexOf('\0') >= 0) throw fault(text);
            return List.of(UnixDomainSocketAddress.of(path));
        }
        return List.of(tcp(text));
    }

    /** The endpoint as a person writes it. */
    static String text(SocketAddress address) {
        if (!(address instanceof InetSocketAddress one)) return address.toString();
        return text(one.getAddress().getHostAddress(), one.getPort());
    }

    /** An address and a port as a person writes them. */
    static String text(String address, int port) {
        return (address.indexOf(':') >= 0 ? "[" + address + "]" : address) + ":" + port;
    }

    private static SocketAddress tcp(String text) {
        int colon = text.lastIndexOf(':');
        String address = text.substring(0, Math.max(colon, 0));
        boolean hasBrackets = address.startsWith("[") && address.endsWith("]");
        if (hasBrackets) address = address.substring(1, address.length() - 1);
        InetAddress read = address.isEmpty() || address.indexOf(':') >= 0 && !hasBrackets ? null : Addresses.read(address);
        try {
            int port = Integer.parseInt(text.substring(colon + 1));
            if (read != null && port >= 1 && port <= 65535) return new InetSocketAddress(read, port);
        } catch (NumberFormatException noPort) {
            // told below
        }
        throw fault(text);
    }

    private static IllegalArgumentException fault(String text) {
        return new IllegalArgumentException("no address of a daemon: '" + text + "': write ADDRESS:PORT, [ADDRESS]:PORT, /PATH or unix:PATH");
    }
}
