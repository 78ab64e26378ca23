package geminga.protocol;

import java.util.Arrays;
import java.util.List;
import java.util.Set;

/** Reserved words of GCNP, and the names of attributes beside them (src/discovery/gcnp/GCNP.md, "Attributes"). */
public final class Keys {
    public static final String PREFIX = "attr.";
    private static final List<String> RESERVED = List.of(("mode id text concept representation port address protocol priority match provider where limit service name degree "
            + "reason subscription participant_name consumer distance age local used served participant peer favour prefer convert scope rank for").split(" "));
    /** Keys of a request that are names of attributes in an offer. */
    private static final List<String> OF_REQUESTS = List.of("on", "reach");
    private static final Set<String> RESERVED_SET = Set.copyOf(RESERVED);

    /** Keys of the daemon's own lines, which a client may state as attributes. */
    private static final Set<String> KEYS_OF_LINES = Set.of("why", "because", "placed", "unplaced", "hops", "reachable", "reach");

    private Keys() {}

    /** The reserved words, in the order of the specification. */
    public static List<String> reserved() {
        return RESERVED;
    }

    public static boolean isReserved(String word) {
        return RESERVED_SET.contains(word);
    }

    /** The attribute that a client's parameter states. */
    public static String stated(String key) throws LineException {
        if (key.startsWith(PREFIX)) {
            if (key.length() == PREFIX.length()) throw new LineException("the name of an attribute is missing behind attr.");
            return key.substring(PREFIX.length());
        }
        if (isReserved(key)) throw new LineException(key + " is reserved and means nothing here");
        String meant = RESERVED.stream().filter(word -> isSlip(key, word)).findFirst().orElse(null);
        if (meant == null && key.indexOf('.') >= 0 && isSlip(key.substring(0, key.indexOf('.')), "attr")) meant = PREFIX + key.substring(key.indexOf('.') + 1);
        if (meant != null) throw new LineException(key + " is no key: did you mean " + meant + "?; an attribute of this name is written attr." + key);
        return key;
    }

    /** The key under which a client states an attribute. */
    public static String stating(String attribute) {
        if (OF_REQUESTS.stream().anyMatch(key -> key.equals(attribute) || isSlip(attribute, key))) return PREFIX + attribute;
        try {
            if (!attribute.startsWith(PREFIX) && stated(attribute).equals(attribute)) return attribute;
        } catch (LineException isTakenForAKey) {
            return PREFIX + attribute;
        }
        return PREFIX + attribute;
    }

    /** The attribute that a parameter of the daemon's lines states, or null if it is a key. */
    public static String shown(String key) {
        if (key.startsWith(PREFIX)) return key.substring(PREFIX.length());
        return isReserved(key) || isKeyOfLines(key) ? null : key;
    }

    /** The key under which the daemon shows an attribute. */
    public static String showing(String attribute) {
        boolean isBare = !isReserved(attribute) && !isKeyOfLines(attribute) && !attribute.startsWith(PREFIX);
        return isBare ? attribute : PREFIX + attribute;
    }

    private static boolean isKeyOfLines(String key) {
        return KEYS_OF_LINES.contains(key);
    }

    /** Whether the two differ by one slip: a letter wrong, missing, too many, of the other case, or swapped with its neighbour. */
    static boolean isSlip(String word, String key) {
        if (word.equals(key) || Math.abs(word.length() - key.length()) > 1) return false;
        char[] a = word.toCharArray();
        char[] b = key.toCharArray();
        int same = Arrays.mismatch(a, b);
        if (a.length < b.length) return Arrays.equals(a, same, a.length, b, same + 1, b.length);
        if (a.length > b.length) return Arrays.equals(a, same + 1, a.length, b, same, b.length);
        if (Arrays.equals(a, same + 1, a.length, b, same + 1, b.length)) return true;
        return same + 1 < a.length && a[same] == b[same + 1] && a[same + 1] == b[same] && Arrays.equals(a, same + 2, a.length, b, same + 2, b.length);
    }
}
