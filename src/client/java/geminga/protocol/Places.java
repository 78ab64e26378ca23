package geminga.protocol;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;

/**
 * A limited number of places, free for everybody until all are taken, and then shared by address (src/client/CHANNELS.md, "Places").
 *
 * @param <T> the holder of a place
 */
public final class Places<T> {
    /**
     * The lot of a newcomer.
     *
     * @param isTaken whether it has a place
     * @param loser the holder that lost its place for it, or null
     */
    public record Outcome<T>(boolean isTaken, T loser) {}

    private static final class Place {
        private final Object address;
        private final long number;
        private boolean isServed;

        Place(Object address, long number) {
            this.address = address;
            this.number = number;
        }
    }

    private final int count;
    private final Map<T, Place> places = new LinkedHashMap<>();
    /** By address, in the order in which they came. */
    private final Map<Object, Set<T>> holders = new HashMap<>();
    private long last;
    private boolean isShort;
    private boolean isTold;

    public Places(int count) {
        this.count = count;
    }

    /** A newcomer from an address. A loser has left already when this returns. */
    public Outcome<T> take(T one, Object address) {
        if (places.size() < count) {
            put(one, address);
            return new Outcome<>(true, null);
        }
        isShort = true;
        Object most = most();
        int own = holders.getOrDefault(address, Set.of()).size();
        if (own + 2 > holders.get(most).size()) return new Outcome<>(false, null);
        T loser = newestOf(most);
        remove(loser);
        put(one, address);
        return new Outcome<>(true, loser);
    }

    /** The holder has delivered something, so it loses its place later than others of its address. */
    public void serve(T one) {
        Place place = places.get(one);
        if (place != null) place.isServed = true;
    }

    /** The holder gives its place back. Whether it had one. */
    public boolean leave(T one) {
        if (!remove(one)) return false;
        if (4L * places.size() <= 3L * count) {
            isShort = false;
            isTold = false;
        }
        return true;
    }

    public boolean has(T one) {
        return places.containsKey(one);
    }

    public int size() {
        return places.size();
    }

    /** Whether all places are taken. */
    public boolean areTaken() {
        return places.size() >= count;
    }

    /** Whether a newcomer found no free place, and not more than a quarter of them has become free since. */
    public boolean isShort() {
        return isShort;
    }

    /** Whether a shortage is to be told: once, until there are places again. */
    public boolean isToBeTold() {
        boolean isNew = isShort && !isTold;
        isTold |= isShort;
        return isNew;
    }

    private void put(T one, Object address) {
        places.put(one, new Place(address, ++last));
        holders.computeIfAbsent(address, unknown -> new LinkedHashSet<>()).add(one);
    }

    private boolean remove(T one) {
        Place place = places.remove(one);
        if (place == null) return false;
        Set<T> same = holders.get(place.address);
        same.remove(one);
        if (same.isEmpty()) holders.remove(place.address);
        return true;
    }

    /** The address that holds most; of several, the one whose newest place is the newest. */
    private Object most() {
        Object most = null;
        int size = 0;
        long newest = 0;
        for (Map.Entry<Object, Set<T>> each : holders.entrySet()) {
            if (each.getValue().size() < size) continue;
            long number = 0;
            for (T one : each.getValue()) number = places.get(one).number;
            if (each.getValue().size() == size && number < newest) continue;
            most = each.getKey();
            size = each.getValue().size();
            newest = number;
        }
        return most;
    }

    /** The newest place of an address that is not served, or the newest of all. */
    private T newestOf(Object address) {
        T newest = null;
        T unserved = null;
        for (T one : holders.get(address)) {
            newest = one;
            if (!places.get(one).isServed) unserved = one;
        }
        return unserved == null ? newest : unserved;
    }
}
