package geminga.protocol;

import java.util.random.RandomGenerator;

/** Lives: 64 random bits by which both sides of a channel know each other; 0 where there is none. */
public final class Life {
    private Life() {}

    /** A new life, which is not 0. */
    public static long draw(RandomGenerator chance) {
        while (true) {
            long life = chance.nextLong();
            if (life != 0) return life;
        }
    }

    /** Sixteen lower-case hexadecimal digits. */
    public static String write(long life) {
        String digits = Long.toHexString(life);
        return "0".repeat(16 - digits.length()) + digits;
    }

    /** The life that an attribute {@code channel} states; 0 where it is not readable. */
    public static long read(String text) {
        if (text == null || text.length() != 16) return 0;
        for (int i = 0; i < 16; ++i) {
            char c = text.charAt(i);
            if (!(c >= '0' && c <= '9' || c >= 'a' && c <= 'f')) return 0;
        }
        return Long.parseUnsignedLong(text, 16);
    }
}
