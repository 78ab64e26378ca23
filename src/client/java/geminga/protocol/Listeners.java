package geminga.protocol;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;

/**
 * Who listens to a stream over UDP, and when each of them was heard last.
 *
 * @param <A> where a listener is
 */
public final class Listeners<A> {
    /** The one that has been silent for longest is the first. */
    private final Map<A, Long> heard = new LinkedHashMap<>();

    /** A hello; whether there is a place for who says it. */
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

    /** Forgets who has been silent for {@link Limits#LISTENER_SILENCE}. */
    public void forget(long now) {
        heard.values().removeIf(last -> now - last >= Limits.LISTENER_SILENCE);
    }

    public Set<A> all() {
        return heard.keySet();
    }

    /** When the next one is to be forgotten, where there is one. */
    public long deadline() {
        return heard.values().iterator().next() + Limits.LISTENER_SILENCE;
    }
}
