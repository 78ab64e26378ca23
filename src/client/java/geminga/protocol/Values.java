package geminga.protocol;

import java.nio.charset.StandardCharsets;
import java.util.function.Predicate;

/** The values of the keys of offers and requests: checked, and written in one form. A wrong value is an {@link IllegalArgumentException}. */
final class Values {
    private Values() {}

    /** The value in its written form; empty if it takes the key back or is the default. */
    static String of(String key, String value, boolean isOffer) {
        writable(key, value);
        return switch (key) {
            case "mode" -> oneOf(key, value, "oto otm/stream otm/pubsub");
            case "id" -> Long.toString(number(key, value, 0, Statement.MAX_ID));
            case "text" -> text(key, value, 1, 255);
            case "concept" -> text(key, value, 1, 1024);
            case "representation", "on" -> text(key, value, 0, 1024);
            case "port" -> port(value);
            case "address" -> address(value);
            case "protocol" -> protocol(value, isOffer);
            case "priority" -> unless("0", Long.toString(number(key, value, Integer.MIN_VALUE, Integer.MAX_VALUE)));
            case "match" -> unless("narrower", oneOf(key, value, "exact equivalent narrower broader overlapping"));
            case "limit" -> Long.toString(number(key, value, 0, Statement.MAX_ID));
            case "convert" -> convert(value);
            case "reach" -> unless("routed", oneOf(key, value, "routed any"));
            case "provider", "favour" -> providers(key, value);
            case "where", "for" -> text(key, value, 0, 400);
            case "scope", "prefer" -> text(key, value, 0, 200);
            case "rank" -> text(key, value, 0, 64);
            default -> throw new IllegalArgumentException(key + " means nothing here");
        };
    }

    /** Throws for a control character that no line can hold. */
    static void writable(String key, String value) {
        if (!Statement.isWritable(value)) throw new IllegalArgumentException(key + ": a control character that no line can hold");
    }

    static long number(String key, String text, long least, long greatest) {
        boolean isHexadecimal = text.startsWith("0x") && text.length() > 2;
        String digits = isHexadecimal ? text.substring(2) : text;
        try {
            if (digits.startsWith("+") || isHexadecimal && digits.startsWith("-")) throw new NumberFormatException();
            long number = Long.parseLong(digits, isHexadecimal ? 16 : 10);
            if (number >= least && number <= greatest) return number;
        } catch (NumberFormatException noNumber) {
            // told below
        }
        throw new IllegalArgumentException(key + ": " + least + " to " + greatest + ", not '" + text + "'");
    }

    static String text(String key, String value, int least, int greatest) {
        int octets = value.getBytes(StandardCharsets.UTF_8).length;
        if (octets >= least && octets <= greatest) return value;
        throw new IllegalArgumentException(key + ": " + least + " to " + greatest + " octets, not " + octets);
    }

    private static String port(String value) {
        return unless("0", Long.toString(number("port", value, 0, 65535)));
    }

    private static String address(String value) {
        if (value.isEmpty() || Addresses.isNumeric(value)) return value;
        throw new IllegalArgumentException("address: a numeric IP address, not '" + value + "'");
    }

    private static String protocol(String value, boolean isOffer) {
        if (value.isEmpty()) return value;
        String[] words = value.split(",", -1);
        boolean isRight = words.length <= (isOffer ? 1 : 8);
        for (String word : words) isRight &= !word.isEmpty() && word.length() <= 32;
        if (!isRight) throw new IllegalArgumentException("protocol: " + (isOffer ? "one word" : "words with commas") + ", not '" + value + "'");
        return isOffer ? unless("udp", value) : value;
    }

    private static String convert(String value) {
        if (value.equals("yes")) return value;
        if (value.equals("no")) return "";
        long cost = number("convert", value, 0, Statement.MAX_ID);
        return cost == Statement.MAX_ID ? "yes" : unless("0", Long.toString(cost));
    }

    private static String providers(String key, String value) {
        if (value.isEmpty()) return value;
        String[] entries = value.split(",", -1);
        Predicate<String> isName = name -> !name.isEmpty() && name.getBytes(StandardCharsets.UTF_8).length <= 64;
        boolean isRight = entries.length <= 16;
        for (String entry : entries) {
            String[] names = entry.split("/", -1);
            isRight &= names.length <= 2 && isName.test(names[0]) && isName.test(names[names.length - 1]);
        }
        if (isRight) return value;
        throw new IllegalArgumentException(key + ": PARTICIPANT[/PEER], up to 16 with commas, not '" + value + "'");
    }

    private static String oneOf(String key, String value, String words) {
        for (String word : words.split(" ")) {
            if (word.equals(value)) return value;
        }
        throw new IllegalArgumentException(key + ": one of " + words + ", not '" + value + "'");
    }

    private static String unless(String usual, String value) {
        return value.equals(usual) ? "" : value;
    }
}
