package geminga.protocol;

import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.NavigableMap;
import java.util.TreeMap;

/**
 * Which messages of a life are new: each is delivered once and in order, and what is missing between two is counted (src/client/CHANNELS.md, "Which message is new"). Remembers
 * {@link Limits#REMEMBERED_LIVES}. The caller gives the time, in nanoseconds.
 */
public final class Sequence {
    /** The sequences that were delivered of one life. */
    private static final class Heard {
        private long last;
        private long at;
        private boolean isInterrupted;
        /** The straggler that was dropped since the last delivery, if there was one. */
        private long straggler;
        private boolean hasStraggler;
        /** Runs without a gap, by their first sequence. */
        private final NavigableMap<Long, Long> ranges = new TreeMap<>(Long::compareUnsigned);

        boolean has(long sequence) {
            Map.Entry<Long, Long> below = ranges.floorEntry(sequence);
            return below != null && Long.compareUnsigned(sequence, below.getValue()) <= 0;
        }

        /** Adds a sequence that is in no range. */
        void add(long sequence) {
            Map.Entry<Long, Long> below = ranges.floorEntry(sequence);
            boolean continues = below != null && below.getValue() == sequence - 1;
            Long end = sequence == -1L ? null : ranges.remove(sequence + 1);
            ranges.put(continues ? below.getKey() : sequence, end == null ? sequence : end);
            if (ranges.size() > Limits.DELIVERED_RANGES) forgetShortest();
        }

        private void forgetShortest() {
            long first = 0;
            long length = -1L;
            for (Iterator<Map.Entry<Long, Long>> each = ranges.entrySet().iterator(); each.hasNext();) {
                Map.Entry<Long, Long> one = each.next();
                long own = one.getValue() - one.getKey();
                if (Long.compareUnsigned(own, length) >= 0) continue;
                first = one.getKey();
                length = own;
            }
            ranges.remove(first);
        }
    }

    private final Map<Long, Heard> lives = new LinkedHashMap<>(16, 0.75f, true) {
        private static final long serialVersionUID = 1;

        @Override
        protected boolean removeEldestEntry(Map.Entry<Long, Heard> eldest) {
            return size() > Limits.REMEMBERED_LIVES;
        }
    };

    /**
     * How many messages are missing before this one, or -1 where it is not new and must not be delivered.
     *
     * @param isProved whether nobody else can have sent it: over TCP, and on a sealed channel
     */
    public long take(long life, long sequence, boolean isProved, long now) {
        if (sequence == 0) return -1;
        Heard heard = lives.get(life);
        if (heard == null) {
            heard = new Heard();
            lives.put(life, heard);
            return deliver(heard, sequence, 0, now);
        }
        boolean isHigher = Long.compareUnsigned(sequence, heard.last) > 0;
        long step = sequence - heard.last;
        if (isProved) return isHigher ? deliver(heard, sequence, heard.isInterrupted ? 0 : step - 1, now) : -1;
        if (heard.has(sequence)) return -1;
        if (isHigher && heard.isInterrupted) return deliver(heard, sequence, 0, now);
        if (isHigher && Long.compareUnsigned(step, Limits.SEQUENCE_STEP) <= 0) return deliver(heard, sequence, step - 1, now);
        boolean isFollowing = heard.hasStraggler && Long.compareUnsigned(sequence, heard.straggler) > 0
                && Long.compareUnsigned(sequence - heard.straggler, Limits.SEQUENCE_STEP) <= 0;
        if (isFollowing && now - heard.at >= Limits.MUTED) return deliver(heard, sequence, 0, now);
        heard.straggler = sequence;
        heard.hasStraggler = true;
        return -1;
    }

    private static long deliver(Heard heard, long sequence, long missed, long now) {
        if (!heard.has(sequence)) heard.add(sequence);
        heard.last = sequence;
        heard.at = now;
        heard.isInterrupted = false;
        heard.hasStraggler = false;
        return missed;
    }

    /** How many messages are missing up to the last one of a life that has ended. What is not proved to be its end cannot claim more than one step. */
    public long missedAtEnd(long life, long last, boolean isProved) {
        Heard heard = lives.get(life);
        boolean isGap = heard != null && !heard.isInterrupted && Long.compareUnsigned(last, heard.last) > 0;
        if (!isGap || !isProved && Long.compareUnsigned(last - heard.last, Limits.SEQUENCE_STEP) > 0) return 0;
        return last - heard.last;
    }

    /** The channel was closed: what is sent until it is made again is not missed. */
    public void interrupt(long life) {
        Heard heard = lives.get(life);
        if (heard != null) heard.isInterrupted = true;
    }
}
