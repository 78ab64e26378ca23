package geminga.channels;

import geminga.Match;
import geminga.protocol.Counterparts.Entry;
import geminga.protocol.Frame;
import geminga.protocol.Limits;
import geminga.protocol.Places;
import geminga.protocol.PublisherFrames;
import geminga.protocol.SendQueue;
import java.io.IOException;
import java.net.InetAddress;
import java.net.StandardSocketOptions;
import java.nio.channels.SelectionKey;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.random.RandomGenerator;

/** The outlet over TCP: it listens, and a connection becomes a consumer if its hello has the life of one that the daemon has named; with {@code otm/stream}, any life. */
final class TcpOutlet implements Outlet, Loop.Ready, TcpGuest.Host {
    private static final int BACKLOG = 256;

    /** A consumer that the daemon has named. */
    private final class Expected extends Consumer {
        private final long consumer;

        Expected(long consumer) {
            this.consumer = consumer;
        }

        @Override
        boolean isThere() {
            return consumers.containsKey(consumer);
        }
    }

    private final Loop loop;
    private final Owner owner;
    private final PublisherFrames frames;
    private final RandomGenerator chance;
    private final boolean isStream;
    private final ServerSocketChannel server;
    private final SendQueue.Pool pool = new SendQueue.Pool();
    /** Connections that are no consumers yet, in the order in which they came. */
    private final Set<TcpGuest> unknown = new LinkedHashSet<>();
    private final Places<TcpGuest> unknownPlaces = new Places<>(Limits.UNKNOWN_CONNECTIONS);
    /** Those of them whose hello was accepted and whose consumer the daemon has not named yet. */
    private final Map<Long, TcpGuest> early = new LinkedHashMap<>();
    private final Map<Long, TcpGuest> consumers = new LinkedHashMap<>();
    private final Places<TcpGuest> places = new Places<>(Limits.TCP_CONSUMERS);
    /** Connections that get the frames that still wait for them. */
    private final Set<TcpGuest> leaving = new LinkedHashSet<>();
    private final Map<Long, Entry<Consumer>> expected = new LinkedHashMap<>();

    TcpOutlet(Loop loop, Owner owner, PublisherFrames frames, InetAddress address, int port, boolean isStream, RandomGenerator chance) throws IOException {
        this.loop = loop;
        this.owner = owner;
        this.frames = frames;
        this.chance = chance;
        this.isStream = isStream;
        server = ServerSocketChannel.open();
        try {
            server.setOption(StandardSocketOptions.SO_REUSEADDR, true);
            server.bind(Datagrams.local(address, port), BACKLOG);
            server.configureBlocking(false);
            loop.register(server, SelectionKey.OP_ACCEPT, this);
        } catch (IOException fault) {
            server.close();
            throw fault;
        }
    }

    @Override
    public int port() {
        return server.socket().getLocalPort();
    }

    @Override
    public void ready(SelectionKey key) {
        for (int i = 0; i < Limits.TURN; ++i) {
            try {
                SocketChannel channel = server.accept();
                if (channel == null) return;
                if (unknownPlaces.areTaken()) lookAtUnknown();
                TcpGuest guest = new TcpGuest(loop, this, frames, chance, channel, pool);
                unknown.add(guest);
                Places.Outcome<TcpGuest> outcome = unknownPlaces.take(guest, guest.host());
                TcpGuest without = outcome.isTaken() ? outcome.loser() : guest;
                if (without == null) continue;
                owner.dropped();
                leave(without, "");
            } catch (IOException fault) {
                loop.interest(key, SelectionKey.OP_ACCEPT, false); // no descriptors are left: look again soon
                loop.after(Limits.HELLO_INTERVAL, () -> loop.interest(key, SelectionKey.OP_ACCEPT, true));
                return;
            }
        }
    }

    /** Reads hellos that have come already, so that no connection loses its place for being read late. */
    private void lookAtUnknown() {
        for (TcpGuest guest : List.copyOf(unknown)) guest.look();
    }

    @Override
    public void dropped() {
        owner.dropped();
    }

    @Override
    public void changed() {
        owner.changed();
    }

    @Override
    public void introduced(TcpGuest guest) {
        long life = guest.said().life();
        if (isStream || expected.containsKey(life)) {
            admit(guest);
            return;
        }
        TcpGuest before = early.put(life, guest);
        if (before != null) leave(before, "");
    }

    /** Makes the connection a consumer's. */
    private void admit(TcpGuest guest) {
        long life = guest.said().life();
        early.remove(life, guest);
        unknown.remove(guest);
        unknownPlaces.leave(guest);
        TcpGuest before = consumers.get(life);
        if (before != null) { // a second connection takes the place of the first
            consumers.remove(life);
            places.leave(before);
            leave(before, "");
        }
        Places.Outcome<TcpGuest> outcome = places.take(guest, guest.host());
        owner.placesChanged(places, Limits.TCP_CONSUMERS, "consumers");
        if (outcome.loser() != null) {
            outcome.loser().sayFull();
            leave(outcome.loser(), "lost");
        }
        if (!outcome.isTaken()) {
            owner.dropped();
            guest.sayFull();
            leave(guest, "");
            return;
        }
        consumers.put(life, guest);
        guest.admitted();
        Entry<Consumer> entry = expected.get(life);
        if (entry != null) owner.arrived(entry);
        owner.changed();
    }

    /** It is a consumer no longer. */
    private void depart(TcpGuest guest, String reason) {
        long life = guest.said().life();
        if (!consumers.remove(life, guest)) return;
        if (places.leave(guest)) owner.placesChanged(places, Limits.TCP_CONSUMERS, "consumers");
        Entry<Consumer> entry = expected.get(life);
        if (entry != null) owner.departed(entry, reason);
        owner.changed();
    }

    /** Writes the frames that wait, and closes. A consumer that takes nothing for a while is left. */
    private void finish(TcpGuest guest) {
        consumers.remove(guest.said().life(), guest);
        places.leave(guest);
        leaving.add(guest);
        guest.finish();
    }

    @Override
    public void left(TcpGuest guest) {
        leave(guest, "lost");
    }

    private void leave(TcpGuest guest, String reason) {
        guest.close();
        if (leaving.remove(guest)) owner.changed();
        unknown.remove(guest);
        unknownPlaces.leave(guest);
        early.remove(guest.said().life(), guest);
        depart(guest, reason);
    }

    @Override
    public boolean hasConsumer() {
        return !consumers.isEmpty();
    }

    @Override
    public void send(byte[] payload) {
        SendQueue.Shared frame = new SendQueue.Shared(frames.message(payload, 0));
        for (TcpGuest guest : consumers.values()) {
            if (guest.send(frame)) continue;
            owner.leftOut();
            if (guest.isLeftOutAnew()) owner.problem("the consumer " + guest.name() + " is slow: messages to it are left out until it has taken some");
        }
        while (pool.isOver()) closeSlowest();
    }

    /** The consumer that has taken nothing for the longest time makes room for the others. */
    private void closeSlowest() {
        TcpGuest slowest = null;
        List<TcpGuest> all = new ArrayList<>(leaving);
        all.addAll(consumers.values());
        for (TcpGuest guest : all) {
            if (guest.waiting() > 0 && (slowest == null || guest.taken() - slowest.taken() < 0)) slowest = guest;
        }
        // The daemon names no consumers of a stream, so that no event can tell of it.
        if (isStream) owner.problem("the consumer " + slowest.name() + " is too slow and was closed, since more than 64 MiB waited for all consumers");
        leave(slowest, "slow");
    }

    @Override
    public boolean hasRoom(int octets) {
        return consumers.values().stream().allMatch(guest -> guest.hasRoom(octets));
    }

    @Override
    public void opened(Entry<Consumer> entry) {
        entry.channel = new Expected(entry.match().life());
        if (entry.match().life() == 0) {
            owner.problem("the consumer " + entry.match().word() + " states no channel and is not served over TCP");
            return;
        }
        expected.put(entry.match().life(), entry);
        TcpGuest guest = early.get(entry.match().life());
        if (guest != null) admit(guest);
    }

    @Override
    public void changed(Entry<Consumer> entry, Match before) {}

    @Override
    public void closed(Entry<Consumer> entry) {
        expected.remove(entry.match().life());
        TcpGuest guest = consumers.get(entry.match().life());
        if (guest != null) finish(guest);
        owner.placesChanged(places, Limits.TCP_CONSUMERS, "consumers");
    }

    @Override
    public boolean hasConnection(Entry<Consumer> entry) {
        return consumers.containsKey(entry.match().life());
    }

    @Override
    public void keysChanged(boolean beginsToSeal, boolean isStrict) {
        for (TcpGuest guest : List.copyOf(consumers.values())) {
            if (isStrict && !guest.said().isSealed()) {
                guest.askForSealed();
            } else if (beginsToSeal) {
                guest.answer(Frame.Kind.FLOOR, 0);
            }
        }
        for (TcpGuest guest : List.copyOf(unknown)) {
            if (isStrict && guest.said().life() != 0 && !guest.said().isSealed()) {
                leave(guest, ""); // it comes again
            } else {
                guest.keysChanged();
            }
        }
    }

    @Override
    public void end() {
        loop.close(server);
        for (TcpGuest guest : List.copyOf(unknown)) leave(guest, "");
        expected.clear();
        byte[] end = frames.end(0);
        for (TcpGuest guest : List.copyOf(consumers.values())) {
            if (end != null) guest.write(end);
            finish(guest);
        }
    }

    @Override
    public boolean hasEnded() {
        return consumers.isEmpty() && leaving.isEmpty();
    }

    @Override
    public void close() {
        if (server.isOpen()) loop.close(server);
        for (TcpGuest guest : List.copyOf(unknown)) leave(guest, "");
        for (TcpGuest guest : List.copyOf(consumers.values())) leave(guest, "");
        for (TcpGuest guest : List.copyOf(leaving)) leave(guest, "");
    }
}
