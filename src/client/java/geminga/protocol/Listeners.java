package geminga.protocol;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;

/**
 * The listeners of a stream over UDP: those that said hello within the last seconds.
 *
 * @param <A> the address of a listener
 */
public final class Listeners<A> {
    /** By the time of the last hello, the oldest first. */
    private final Map<A, Long> heard = new LinkedHashMap<>();

    /** Adds a listener, or renews it. False if there is no room for one more. */
    public boolean heard(A from, long now) {
        if (heard.remove(from) == null && heard.size() == Limits.LISTENERS) {
            forget(now);
            if (heard.size() == Limits.LISTENERS) return false;
        }
        heard.put(from, now);
        return true;
    }

    public void remove(A from) {
        heard.remove(from);
    }

    /** Forgets listeners that have been silent for {@link Limits#LISTENER_SILENCE}. */
    public void forget(long now) {
        heard.values().removeIf(last -> now - last >= Limits.LISTENER_SILENCE);
    }

    public Set<A> all() {
        return heard.keySet();
    }

    /** The time at which the next one is to be forgotten. Requires that there is one. */
    public long deadline() {
        return heard.values().iterator().next() + Limits.LISTENER_SILENCE;
    }
}
