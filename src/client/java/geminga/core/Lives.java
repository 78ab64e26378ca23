package geminga.core;

import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import java.util.random.RandomGenerator;

/** Lives as text and by chance, and which message of each was delivered last. */
public final class Lives {
    private final Set<Long> fresh = new HashSet<>();
    private final Map<Long, Long> last = new LinkedHashMap<>(16, 0.75f, true) {
        private static final long serialVersionUID = 1;

        @Override
        protected boolean removeEldestEntry(Map.Entry<Long, Long> eldest) {
            return size() > Sizes.REMEMBERED_LIVES;
        }
    };

    /** A channel of that life begins, perhaps again: nothing is missed before its first message. */
    public void begin(long life) {
        fresh.add(life);
    }

    /** Its channel has ended. */
    public void end(long life) {
        fresh.remove(life);
    }

    /** Takes note of a message: how many messages of its channel are missing before it, or -1 where it is not newer than the last one of its life and must not be delivered. */
    public long accept(long life, long sequence) {
        Long before = last.get(life);
        if (before == null ? sequence == 0 : Long.compareUnsigned(sequence, before) <= 0) return -1;
        last.put(life, sequence);
        return fresh.remove(life) || before == null ? 0 : sequence - before - 1;
    }

    /** How many messages are missing before an end that names the last one. */
    public long missingBeforeEnd(long life, long sequence) {
        Long before = last.get(life);
        boolean isGap = before != null && !fresh.contains(life) && Long.compareUnsigned(sequence, before) > 0;
        return isGap ? sequence - before : 0;
    }

    /** Draws a life. */
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
