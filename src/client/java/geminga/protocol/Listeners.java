package geminga.protocol;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** The listeners of a stream over UDP: those that said hello within the last seconds, and share the places by address. The caller gives the time, in nanoseconds. */
public final class Listeners {
    /** One listener. */
    public static final class Listener {
        private final InetSocketAddress address;
        private final Said said = new Said();
        private long heard;

        private Listener(InetSocketAddress address) {
            this.address = address;
        }

        public InetSocketAddress address() {
            return address;
        }

        /** Its last hello. */
        public Said said() {
            return said;
        }
    }

    /** By the time of the last hello, the oldest first. */
    private final Map<InetSocketAddress, Listener> listeners = new LinkedHashMap<>();
    private final Places<Listener> places = new Places<>(Limits.LISTENERS);

    /** The listener at an address, or null. */
    public Listener at(InetSocketAddress address) {
        return listeners.get(address);
    }

    /** A newcomer: whether it has a place, and which listener lost its own for it. */
    public Places.Outcome<Listener> add(InetSocketAddress address, long now) {
        if (places.areTaken()) forget(now);
        Listener made = new Listener(address);
        Places.Outcome<Listener> outcome = places.take(made, host(address));
        if (outcome.loser() != null) listeners.remove(outcome.loser().address);
        if (outcome.isTaken()) {
            made.heard = now;
            listeners.put(address, made);
        }
        return outcome;
    }

    private static InetAddress host(InetSocketAddress address) {
        return address.getAddress();
    }

    /** A listener has said hello again. */
    public void renew(Listener listener, long now) {
        listener.heard = now;
        listeners.remove(listener.address);
        listeners.put(listener.address, listener);
    }

    public void remove(InetSocketAddress address) {
        Listener gone = listeners.remove(address);
        if (gone != null) places.leave(gone);
    }

    /** Forgets listeners that have been silent for {@link Limits#LISTENER_SILENCE}. */
    public void forget(long now) {
        List<InetSocketAddress> silent = new ArrayList<>();
        for (Listener one : listeners.values()) {
            if (now - one.heard < Limits.LISTENER_SILENCE) break;
            silent.add(one.address);
        }
        silent.forEach(this::remove);
    }

    public Collection<Listener> all() {
        return listeners.values();
    }

    public Places<Listener> places() {
        return places;
    }

    /** The time at which the next one is to be forgotten. Requires that there is one. */
    public long deadline() {
        return listeners.values().iterator().next().heard + Limits.LISTENER_SILENCE;
    }
}
