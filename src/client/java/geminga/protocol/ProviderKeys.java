package geminga.protocol;

import java.util.LinkedHashMap;
import java.util.Map;

/** The keys that the daemon has told a subscriber, by the life of a provider. It tells them once, though a provider may go and come back. Remembers {@link Limits#REMEMBERED_LIVES}. */
public final class ProviderKeys {
    private final Map<Long, ChannelKeys> keys = new LinkedHashMap<>();

    /** The keys of a life, or null. */
    public ChannelKeys of(long life) {
        return keys.get(life);
    }

    public void put(long life, ChannelKeys told) {
        keys.remove(life);
        if (keys.size() == Limits.REMEMBERED_LIVES) keys.remove(keys.keySet().iterator().next());
        keys.put(life, told);
    }

    public void clear() {
        keys.clear();
    }
}
