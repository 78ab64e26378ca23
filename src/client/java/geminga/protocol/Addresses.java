package geminga.protocol;

import java.net.Inet6Address;
import java.net.InetAddress;
import java.net.UnknownHostException;

/** Numeric addresses, read without a name server and compared with their zones. */
public final class Addresses {
    private Addresses() {}

    /** The address of a numeric text; null if it is none, or its zone is no interface of this host. */
    public static InetAddress read(String text) {
        boolean isSix = text.indexOf(':') >= 0 && text.charAt(0) != '[' && isSix(text);
        if (!isSix && !isFour(text)) return null;
        try {
            return InetAddress.getByName(text);
        } catch (UnknownHostException notAnAddress) {
            return null;
        }
    }

    /** Whether the text has the form of an address, with any zone. */
    public static boolean isNumeric(String text) {
        int zone = text.indexOf('%');
        InetAddress address = zone == 0 ? null : read(zone < 0 ? text : text.substring(0, zone));
        boolean hasRightZone = zone < 0 || zone + 1 < text.length() && address instanceof Inet6Address;
        return address != null && hasRightZone && !address.isAnyLocalAddress();
    }

    /** Whether two addresses are equal, zones included. */
    public static boolean areSame(InetAddress one, InetAddress other) {
        if (!one.equals(other)) return false;
        boolean hasZone = one instanceof Inet6Address && one.isLinkLocalAddress();
        return !hasZone || ((Inet6Address) one).getScopeId() == ((Inet6Address) other).getScopeId();
    }

    private static boolean isFour(String text) {
        String[] numbers = text.split("\\.", -1);
        if (numbers.length != 4) return false;
        for (String number : numbers) {
            boolean isNumber = !number.isEmpty() && number.length() <= 3 && number.chars().allMatch(c -> c >= '0' && c <= '9');
            if (!isNumber || Integer.parseInt(number) > 255) return false;
        }
        return true;
    }

    private static boolean isSix(String text) {
        int zone = text.indexOf('%');
        String digits = zone < 0 ? text : text.substring(0, zone);
        return digits.chars().allMatch(c -> c == ':' || c == '.' || Character.digit(c, 16) >= 0 && c < 128);
    }
}
