package geminga.protocol;

import java.util.LinkedHashMap;
import java.util.Map;

/** Which messages of a life are new: each is delivered once and in order, and what is missing between two is counted. Remembers {@link Limits#REMEMBERED_LIVES}. */
public final class Sequence {
    private static final class Heard {
        private long last;
        private boolean isInterrupted;
    }

    private final Map<Long, Heard> lives = new LinkedHashMap<>(16, 0.75f, true) {
        private static final long serialVersionUID = 1;

        @Override
        protected boolean removeEldestEntry(Map.Entry<Long, Heard> eldest) {
            return size() > Limits.REMEMBERED_LIVES;
        }
    };

    /** How many messages are missing before this one, or -1 where it is not newer than the last one of its life and must not be delivered. */
    public long take(long life, long sequence) {
        Heard heard = lives.get(life);
        if (heard == null ? sequence == 0 : Long.compareUnsigned(sequence, heard.last) <= 0) return -1;
        boolean isFirst = heard == null || heard.isInterrupted;
        if (heard == null) lives.put(life, heard = new Heard());
        long missed = isFirst ? 0 : sequence - heard.last - 1;
        heard.last = sequence;
        heard.isInterrupted = false;
        return missed;
    }

    /** How many messages are missing up to the last one of a life that has ended. */
    public long missedAtEnd(long life, long last) {
        Heard heard = lives.get(life);
        boolean isGap = heard != null && !heard.isInterrupted && Long.compareUnsigned(last, heard.last) > 0;
        return isGap ? last - heard.last : 0;
    }

    /** The channel was closed: what is sent until it is made again is not missed. */
    public void interrupt(long life) {
        Heard heard = lives.get(life);
        if (heard != null) heard.isInterrupted = true;
    }
}
