package geminga.protocol;

/**
 * How many datagrams a publisher may answer: {@link Limits#ANSWERS} at once, and as many a second. Half of them are kept for newcomers, since a listener that says hello again
 * needs no answer. The caller gives the time, in nanoseconds.
 */
public final class AnswerRate {
    private static final long EACH = 1_000_000_000L / Limits.ANSWERS;

    private long left = Limits.ANSWERS;
    private long counted;

    public AnswerRate(long now) {
        counted = now;
    }

    /** Whether one more may be answered now; with {@code isKnown}, one that is a listener already. */
    public boolean take(boolean isKnown, long now) {
        long more = (now - counted) / EACH;
        if (more > 0) {
            left = Math.min(Limits.ANSWERS, left + more);
            counted += more * EACH;
        }
        if (left <= (isKnown ? Limits.ANSWERS / 2 : 0)) return false;
        --left;
        return true;
    }
}
