package geminga.channels;

import geminga.protocol.Limits;
import java.io.IOException;
import java.net.Inet4Address;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.NetworkInterface;
import java.net.SocketException;
import java.net.StandardProtocolFamily;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import java.nio.channels.SelectionKey;
import java.util.ArrayList;
import java.util.List;

/** A UDP socket, of both families if the host has both. All calls are made with the loop's lock. */
final class Datagrams implements Loop.Ready {
    /** The receiver of datagrams. */
    interface Reader {
        /** Takes a datagram. The buffer is void afterwards. */
        void read(InetSocketAddress from, ByteBuffer datagram);
    }

    private static final int BUFFER = 4 * 1024 * 1024;

    private final Loop loop;
    private final DatagramChannel channel;
    private final SelectionKey key;
    private final Reader reader;
    private boolean isClosed;
    private boolean isFull;

    private Datagrams(Loop loop, DatagramChannel channel, Reader reader) throws IOException {
        this.loop = loop;
        this.channel = channel;
        this.reader = reader;
        channel.setOption(StandardSocketOptions.SO_RCVBUF, BUFFER); // the system may give less
        channel.configureBlocking(false);
        key = loop.register(channel, reader == null ? 0 : SelectionKey.OP_READ, this);
    }

    /** Opens a socket at a port, 0 for any, and at an address if it is one of this host's. {@code reader} is null if nothing is to be received. */
    static Datagrams open(Loop loop, InetAddress address, int port, Reader reader) throws IOException {
        DatagramChannel channel = DatagramChannel.open();
        try {
            channel.bind(local(address, port));
            return new Datagrams(loop, channel, reader);
        } catch (IOException fault) {
            channel.close();
            throw fault;
        }
    }

    /** The port that a socket would have, 0 for any. No socket is kept open. */
    static int free(InetAddress address, int port) throws IOException {
        try (DatagramChannel channel = DatagramChannel.open()) {
            return channel.bind(local(address, port)).socket().getLocalPort();
        }
    }

    /** The address to bind to for a stated one: that address if it is one of this host's, or else all addresses. */
    static InetSocketAddress local(InetAddress address, int port) throws SocketException {
        boolean isOwn = address != null && !address.isMulticastAddress() && NetworkInterface.getByInetAddress(address) != null;
        return isOwn ? new InetSocketAddress(address, port) : new InetSocketAddress(port);
    }

    /** Opens a socket that sends to a multicast group, or one that receives it. */
    static Datagrams group(Loop loop, InetSocketAddress group, Reader reader) throws IOException {
        boolean isFour = group.getAddress() instanceof Inet4Address;
        DatagramChannel channel = DatagramChannel.open(isFour ? StandardProtocolFamily.INET : StandardProtocolFamily.INET6);
        try {
            channel.setOption(StandardSocketOptions.SO_REUSEADDR, true);
            // Bound to the group, the socket receives nothing else. A link-local group cannot be bound to for all links.
            boolean isOfALink = !isFour && (group.getAddress().isMCLinkLocal() || group.getAddress().isMCNodeLocal());
            channel.bind(reader == null || isOfALink ? new InetSocketAddress(group.getPort()) : group);
            channel.setOption(StandardSocketOptions.IP_MULTICAST_TTL, 1);
            channel.setOption(StandardSocketOptions.IP_MULTICAST_LOOP, true);
            return new Datagrams(loop, channel, reader);
        } catch (IOException fault) {
            channel.close();
            throw fault;
        }
    }

    /** The interfaces that multicasts use: all that are up and no loopback, or the loopback if there is no other. */
    static List<NetworkInterface> interfaces(InetAddress group) {
        List<NetworkInterface> others = new ArrayList<>();
        List<NetworkInterface> loopbacks = new ArrayList<>();
        try {
            for (NetworkInterface one : NetworkInterface.networkInterfaces().toList()) {
                boolean speaks = one.isUp() && one.inetAddresses().anyMatch(address -> address instanceof Inet4Address == group instanceof Inet4Address);
                if (speaks && one.isLoopback()) loopbacks.add(one);
                if (speaks && !one.isLoopback() && one.supportsMulticast()) others.add(one);
            }
        } catch (SocketException isGone) {
            return others;
        }
        if (others.isEmpty()) others.addAll(loopbacks);
        return others;
    }

    /** Joins the group on an interface. Whether that succeeded. */
    boolean join(InetAddress group, NetworkInterface via) {
        try {
            channel.join(group, via);
            return true;
        } catch (IOException | IllegalArgumentException | UnsupportedOperationException isUnable) {
            return false;
        }
    }

    /** Sends multicasts through an interface from now on. Whether that succeeded. */
    boolean via(NetworkInterface one) {
        try {
            channel.setOption(StandardSocketOptions.IP_MULTICAST_IF, one);
            return true;
        } catch (IOException isUnable) {
            return false;
        }
    }

    int port() {
        return channel.socket().getLocalPort();
    }

    /** Sends a datagram, which can be sent again. Whether the system took it. */
    boolean send(ByteBuffer datagram, InetSocketAddress to) {
        if (isClosed) return false;
        int begin = datagram.position();
        try {
            isFull = channel.send(datagram, to) == 0;
            if (isFull) loop.interest(key, SelectionKey.OP_WRITE, true);
            return !isFull;
        } catch (IOException | RuntimeException isUnreachable) { // no route, or an address of a family that this host does not have
            return false;
        } finally {
            datagram.position(begin);
        }
    }

    /** Whether the system would take another datagram. */
    boolean hasRoom() {
        return !isFull;
    }

    @Override
    public void ready(SelectionKey ready) {
        if (ready.isWritable()) {
            isFull = false;
            loop.interest(key, SelectionKey.OP_WRITE, false);
        }
        if (ready.isReadable()) receive(Limits.TURN);
    }

    /** Reads what the socket holds now, but not without end; whether it holds nothing more. */
    boolean drain() {
        return receive(Limits.TURN * Limits.TURN);
    }

    private boolean receive(int most) {
        for (int i = 0; i < most && !isClosed; ++i) {
            ByteBuffer datagram = loop.incoming.clear();
            try {
                InetSocketAddress from = (InetSocketAddress) channel.receive(datagram);
                if (from == null) return true;
                reader.read(from, datagram.flip());
            } catch (IOException isOfAnEarlierSend) {
                return false;
            }
        }
        return isClosed;
    }

    void close() {
        if (isClosed) return;
        isClosed = true;
        loop.close(channel);
    }
}
