package geminga.protocol;

import java.time.Duration;
import java.util.random.RandomGenerator;

/** The wait before the next attempt to connect: .1, .2, .4, .8, 1, 1, ... s, each up to a quarter longer, by chance. */
public final class Backoff {
    private static final long FIRST = Duration.ofMillis(100).toNanos();
    private static final long LAST = Duration.ofSeconds(1).toNanos();

    private final RandomGenerator chance;
    private long next = FIRST;

    public Backoff(RandomGenerator chance) {
        this.chance = chance;
    }

    /** Nanoseconds until the next attempt. */
    public long next() {
        long wait = next;
        next = Math.min(LAST, next * 2);
        return wait + (long) (wait / 4.0 * chance.nextDouble());
    }

    /** An attempt has succeeded: begins with the shortest wait again. */
    public void reset() {
        next = FIRST;
    }
}
