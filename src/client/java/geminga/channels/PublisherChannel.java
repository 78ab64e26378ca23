package geminga.channels;

import geminga.Change;
import geminga.Event.ConsumerEvent;
import geminga.Match;
import geminga.MessageTooLargeException;
import geminga.Mode;
import geminga.Offer;
import geminga.protocol.Addresses;
import geminga.protocol.ChannelKeys;
import geminga.protocol.Counterparts;
import geminga.protocol.Counterparts.Entry;
import geminga.protocol.Life;
import geminga.protocol.Limits;
import geminga.protocol.LineException;
import geminga.protocol.Places;
import geminga.protocol.PublisherFrames;
import geminga.protocol.Told;
import java.io.IOException;
import java.net.InetAddress;
import java.nio.channels.ClosedChannelException;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletionStage;
import java.util.function.Consumer;
import java.util.random.RandomGenerator;

/** A publisher behind the face: its statement, its consumers and its outlet. */
public final class PublisherChannel extends Stated implements Counterparts.Watcher<Outlet.Consumer>, Outlet.Owner {
    private static final List<String> FIXED = List.of("mode", "port", "address", "protocol");

    private final Counterparts<Outlet.Consumer> consumers = new Counterparts<>(this, false);
    private final Consumer<ConsumerEvent> listener;
    private final RandomGenerator chance;
    private final PublisherFrames frames;
    private final int largest;
    private final boolean isStream;
    private final Outlet outlet;
    private Offer offer;
    private Loop.Timer timer;
    private boolean isToldFull;
    private long leftOut;
    private long dropped;
    private volatile boolean isClosed;
    /** Read without the lock, so that sending without a consumer costs a comparison. */
    private volatile boolean isHeard;

    /** Opens the sockets and states the offer. With the lock. */
    public PublisherChannel(Loop loop, DaemonLink daemon, Offer offer, long life, RandomGenerator chance, Consumer<ConsumerEvent> listener) throws IOException {
        super(loop, daemon, "pub");
        this.listener = listener;
        this.chance = chance;
        frames = new PublisherFrames(life);
        frames.keys(daemon.keysOfNew());
        isStream = offer.mode() == Mode.STREAM;
        largest = offer.protocol().equals("tcp") ? Limits.TCP_MESSAGE : Limits.UDP_MESSAGE;
        Offer named = offer.attribute("channel", Life.write(life));
        outlet = open(offer);
        this.offer = named.port(outlet.port());
        outlet.keysChanged(false, false);
        isHeard = isReached();
        begin();
    }

    private Outlet open(Offer offer) throws IOException {
        InetAddress address = offer.address().isEmpty() ? null : Addresses.read(offer.address());
        if (!offer.address().isEmpty() && address == null) throw new IOException("address: this host does not know " + offer.address());
        boolean isGroup = address != null && address.isMulticastAddress();
        if (isGroup && (!isStream || !offer.protocol().equals("udp"))) throw new IllegalArgumentException("a multicast address is for otm/stream over udp");
        switch (offer.protocol()) {
            case "tcp":
                return new TcpOutlet(loop, this, frames, address, offer.port(), isStream, chance);
            case "udp":
                if (isGroup) return new MulticastOutlet(loop, this, frames, address, offer.port());
                if (isStream) return new ListenersOutlet(loop, this, frames, address, offer.port());
                return new UdpOutlet(loop, this, frames, address, offer.port(), offer.mode() == Mode.PUBSUB);
            default:
                throw new IllegalArgumentException("protocol: a publisher speaks udp or tcp, not '" + offer.protocol() + "'");
        }
    }

    public Offer offer() {
        return offer;
    }

    public long life() {
        return frames.life();
    }

    /** Sends to every consumer. Whether there was one. */
    public boolean send(byte[] payload) throws IOException {
        if (payload.length > largest) throw tooLarge(payload.length);
        if (!isHeard && !isClosed) return false;
        loop.lock.lock();
        try {
            if (isClosed) throw refusal() != null ? refusal() : new ClosedChannelException();
            if (!isHeard || !frames.isReady()) return false;
            outlet.send(payload);
            return true;
        } finally {
            loop.lock.unlock();
        }
    }

    private IOException tooLarge(int octets) {
        boolean isUdp = largest == Limits.UDP_MESSAGE;
        return new MessageTooLargeException(octets + " octets: a message over " + (isUdp ? "UDP has at most " + largest + ": offer the service with protocol=tcp" : "TCP has at most " + largest));
    }

    /** Whether there is a consumer. */
    public boolean isHeard() {
        return isHeard;
    }

    /** Whether every consumer has room for a message of this size. With the lock. */
    public boolean hasRoom(int octets) {
        return isClosed || outlet.hasRoom(octets);
    }

    /** Puts another offer in the place of this one. Completes with the answer of the daemon. With the lock. */
    public CompletionStage<Void> modify(Offer wanted) {
        Offer named = wanted.attribute("channel", Life.write(frames.life()));
        Offer next = wanted.port() == 0 ? named.port(outlet.port()) : named;
        Map<String, String> changes = next.changesFrom(offer);
        if (FIXED.stream().anyMatch(changes::containsKey)) throw new IllegalArgumentException("mode, port, address and protocol of a publisher stay: make another one");
        Offer before = offer;
        offer = next;
        return modify(changes, () -> {
            if (offer == next) offer = before;
        });
    }

    @Override
    Map<String, String> parameters() {
        return offer.parameters();
    }

    @Override
    void told(Told event) {
        if (isStream || event.isOfService() || isClosed) return;
        if (event.change() == Change.REMOVED) {
            consumers.remove(event.word(), event.reason(), loop.now());
        } else {
            try {
                Match match = event.match();
                if (event.change() == Change.ADDED) {
                    consumers.put(match, loop.now());
                } else {
                    consumers.modify(match, loop.now());
                }
            } catch (LineException wasRead) {
                throw new IllegalStateException(wasRead);
            }
        }
        changed();
    }

    @Override
    void daemonLost() {
        consumers.lost();
        changed();
    }

    @Override
    void daemonBack() {
        consumers.back(loop.now());
        changed();
    }

    @Override
    void refused() {
        consumers.closeAll("refused");
        end();
        close();
    }

    @Override
    void keys(long life, ChannelKeys keys) {
        if (life == frames.life()) keys(keys);
    }

    @Override
    void daemonKeys(boolean hasKeys) {
        if (!hasKeys) keys(ChannelKeys.NONE);
    }

    private void keys(ChannelKeys keys) {
        if (isClosed) return;
        boolean sealed = frames.seals();
        boolean tookPlain = frames.keys() == null || frames.takesPlain();
        frames.keys(keys);
        outlet.keysChanged(!sealed && frames.seals(), tookPlain && !frames.takesPlain());
        changed();
    }

    @Override
    public void opened(Entry<Outlet.Consumer> entry) {
        outlet.opened(entry);
        if (entry.channel.isThere()) arrived(entry);
    }

    @Override
    public void changed(Entry<Outlet.Consumer> entry, Match before) {
        outlet.changed(entry, before);
        if (entry.channel.isTold) tell(Change.MODIFIED, entry, "-");
    }

    @Override
    public void ending(Entry<Outlet.Consumer> entry) {
        throw new IllegalStateException("a consumer that is withdrawn is gone at once");
    }

    @Override
    public boolean hasConnection(Entry<Outlet.Consumer> entry) {
        return outlet.hasConnection(entry);
    }

    @Override
    public void closed(Entry<Outlet.Consumer> entry, String reason) {
        outlet.closed(entry);
        if (entry.channel.isTold && !isClosed) tell(Change.REMOVED, entry, reason);
        entry.channel.isTold = false;
    }

    @Override
    public void arrived(Entry<Outlet.Consumer> entry) {
        if (!entry.channel.isTold) tell(Change.ADDED, entry, "-");
        entry.channel.isTold = true;
    }

    @Override
    public void departed(Entry<Outlet.Consumer> entry, String reason) {
        if (isClosed) return;
        if (entry.channel.isTold) tell(Change.REMOVED, entry, consumers.isLost(entry) ? entry.reason() : reason);
        entry.channel.isTold = false;
        consumers.broke(entry);
    }

    @Override
    public void placesChanged(Places<?> places, int count, String holders) {
        if (isClosed) return;
        if (places.isToBeTold()) problem("all " + count + " places for " + holders + " are taken");
        if (places.isShort() == isToldFull) return;
        isToldFull = places.isShort();
        try {
            state(offer.attribute("channel.full", isToldFull ? Integer.toString(count) : "0"));
        } catch (IllegalArgumentException hasTooManyAttributes) {
            return;
        }
    }

    @Override
    public void leftOut() {
        ++leftOut;
    }

    @Override
    public void dropped() {
        ++dropped;
    }

    @Override
    public void moved(int port) {
        state(offer.port(port));
    }

    /** States what the library itself changes. */
    private void state(Offer next) {
        modify(next.changesFrom(offer), () -> { });
        offer = next;
    }

    private boolean isReached() {
        return !isClosed && frames.isReady() && outlet.hasConsumer();
    }

    @Override
    public void changed() {
        if (timer != null) timer.cancel();
        timer = null;
        isHeard = isReached();
        long deadline = isClosed ? Long.MAX_VALUE : consumers.deadline();
        if (deadline != Long.MAX_VALUE) {
            timer = loop.after(deadline - loop.now(), () -> {
                consumers.tick(loop.now());
                changed();
            });
        }
        loop.changed();
    }

    private void tell(Change change, Entry<Outlet.Consumer> entry, String reason) {
        ConsumerEvent event = new ConsumerEvent(change, entry.match(), reason);
        loop.tell(() -> listener.accept(event));
    }

    /** Withdraws the offer and sends the end to its consumers. With the lock. */
    public void end() {
        if (isClosed) return;
        isClosed = true;
        outlet.end();
        withdraw();
        changed();
    }

    /** Whether every consumer has the end. With the lock. */
    public boolean hasEnded() {
        return outlet.hasEnded();
    }

    /** Closes the sockets. With the lock. */
    public void close() {
        outlet.close();
        consumers.closeAll("");
        changed();
    }

    public boolean isClosed() {
        return isClosed;
    }

    /** The messages that were sent while there was a consumer. */
    public long sent() {
        return frames.sequence();
    }

    /** The messages that were left out, counted for each consumer. */
    public long leftOutCount() {
        return leftOut;
    }

    /** The datagrams and connections that were not believed. */
    public long droppedCount() {
        return dropped;
    }
}
