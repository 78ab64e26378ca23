package geminga.channels;

import geminga.Change;
import geminga.Event.ProviderEvent;
import geminga.Match;
import geminga.Message;
import geminga.Mode;
import geminga.Request;
import geminga.protocol.Addresses;
import geminga.protocol.Counterparts;
import geminga.protocol.Counterparts.Entry;
import geminga.protocol.EarlyFrames;
import geminga.protocol.Frame;
import geminga.protocol.Inbox;
import geminga.protocol.Life;
import geminga.protocol.LineException;
import geminga.protocol.Sequence;
import geminga.protocol.Told;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletionStage;
import java.util.function.Consumer;
import java.util.random.RandomGenerator;

/** A subscriber behind the face: its statement, its providers, its inlets and its inbox. */
public final class SubscriberChannel extends Stated implements Counterparts.Watcher<Inlet>, Inlet.Owner, Datagrams.Reader, Groups.Reader {
    private static final List<String> FIXED = List.of("mode", "port", "address", "protocol");

    private final Counterparts<Inlet> providers = new Counterparts<>(this, true);
    private final Sequence sequences = new Sequence();
    private final Inbox inbox = new Inbox();
    private final EarlyFrames early = new EarlyFrames();
    private final Groups groups;
    private final Consumer<ProviderEvent> listener;
    private final RandomGenerator chance;
    private final long life;
    private final Datagrams socket;
    private Runnable onMessage = () -> {};
    private volatile Request request;
    private Loop.Timer timer;
    private long dropped;
    private long missed;
    /** Whether there has been a provider that states no life. */
    private boolean hasStrangers;
    /** Whether connections wait for room. */
    private boolean isPaused;
    private boolean isClosed;

    /** Opens the socket and states the request. With the lock. */
    public SubscriberChannel(Loop loop, DaemonLink daemon, Request request, long life, RandomGenerator chance, Consumer<ProviderEvent> listener) throws IOException {
        super(loop, daemon, "sub");
        this.listener = listener;
        this.life = life;
        this.chance = chance;
        groups = new Groups(loop, this);
        if (!request.protocols().contains("udp") && !request.protocols().contains("tcp")) throw new IllegalArgumentException("protocol: a subscriber hears udp and tcp");
        InetAddress address = request.address().isEmpty() ? null : Addresses.read(request.address());
        request.attribute("channel", Life.write(life)); // throws if there is no room for it
        socket = request.protocols().contains("udp") ? Datagrams.open(loop, address, request.port(), this) : null;
        this.request = stated(request);
        providers.limit(request.limit());
        begin();
    }

    /** The request with the port and the life that the library states. */
    private Request stated(Request asked) {
        Request own = asked.attribute("channel", Life.write(life)).protocols(asked.protocols().toArray(String[]::new));
        return socket == null || asked.port() != 0 ? own : own.port(socket.port());
    }

    public Request request() {
        return request;
    }

    public long life() {
        return life;
    }

    /** Called with the lock when a message has come. */
    public void onMessage(Runnable action) {
        onMessage = action;
    }

    /** Puts another request in the place of this one. Completes with the answer of the daemon. With the lock. */
    public CompletionStage<Void> modify(Request wanted) {
        Request next = stated(wanted);
        Map<String, String> changes = next.changesFrom(request);
        if (FIXED.stream().anyMatch(changes::containsKey)) throw new IllegalArgumentException("mode, port, address and protocol of a subscriber stay: make another one");
        Request before = request;
        request = next;
        providers.limit(next.limit());
        return modify(changes, () -> {
            if (request != next) return;
            request = before;
            providers.limit(before.limit());
        });
    }

    @Override
    Map<String, String> parameters() {
        return request.parameters();
    }

    @Override
    void told(Told event) {
        if (!event.isOfService() || isClosed) return;
        if (event.change() == Change.REMOVED) {
            Entry<Inlet> entry = providers.at(event.word());
            providers.remove(event.word(), event.reason(), loop.now(), entry != null && entry.channel.hasConnection());
        } else {
            try {
                Match match = event.match();
                if (event.change() == Change.ADDED) {
                    providers.put(match);
                } else {
                    providers.modify(match);
                }
                deliverEarly(providers.at(event.word()));
            } catch (LineException wasRead) {
                throw new IllegalStateException(wasRead);
            }
        }
        changed();
    }

    @Override
    void daemonLost() {
        providers.lost();
        changed();
    }

    @Override
    void daemonBack() {
        providers.back(loop.now());
        changed();
    }

    @Override
    void refused() {
        providers.closeAll("refused");
        close();
    }

    @Override
    public void opened(Entry<Inlet> entry) {
        entry.channel = inlet(entry.match());
        tell(Change.ADDED, entry.match(), "-");
    }

    private Inlet inlet(Match provider) {
        hasStrangers |= provider.life() == 0;
        boolean isHeard = request.protocols().contains(provider.protocol());
        InetSocketAddress group = Groups.of(provider);
        if (isHeard && provider.protocol().equals("tcp") && provider.life() != 0) return new TcpInlet(loop, this, life, provider, chance);
        if (isHeard && group != null) return new MulticastInlet(groups, group);
        if (isHeard && provider.protocol().equals("udp")) return new UdpInlet(loop, socket, life, provider, request.mode() == Mode.STREAM);
        problem("the provider " + provider.word() + (isHeard ? " states no channel and is not connected over TCP" : " speaks " + provider.protocol()));
        return new NoInlet();
    }

    @Override
    public void changed(Entry<Inlet> entry, Match before) {
        Match match = entry.match();
        boolean isOtherKind = !match.protocol().equals(before.protocol()) || Groups.of(match) == null != (Groups.of(before) == null);
        if (isOtherKind) {
            entry.channel.close();
            entry.channel = inlet(match);
        } else {
            entry.channel.changed(match);
        }
        tell(Change.MODIFIED, match, "-");
    }

    @Override
    public void ending(Entry<Inlet> entry) {
        entry.channel.ending();
        if (!(entry.channel instanceof TcpInlet)) loop.after(0, this::drain);
    }

    /** Reads what the sockets hold, and ends the providers that were withdrawn. */
    private void drain() {
        if (isClosed) return;
        boolean isEmpty = (socket == null || socket.drain()) & groups.drain();
        if (!isEmpty) {
            loop.after(0, this::drain);
            return;
        }
        for (Entry<Inlet> entry : providers.all()) {
            if (entry.isEnding() && !(entry.channel instanceof TcpInlet)) providers.ended(entry);
        }
        changed();
    }

    @Override
    public void closed(Entry<Inlet> entry, String reason) {
        entry.channel.close();
        sequences.interrupt(entry.match().life());
        tell(Change.REMOVED, entry.match(), reason);
    }

    private void tell(Change change, Match provider, String reason) {
        if (isClosed) return; // by the application, which need not be told
        loop.tell(() -> listener.accept(new ProviderEvent(change, provider, reason)));
    }

    /** Sets the timer for the next deadline. */
    private void changed() {
        if (timer != null) timer.cancel();
        timer = null;
        long deadline = isClosed ? Long.MAX_VALUE : providers.deadline();
        if (deadline == Long.MAX_VALUE) return;
        timer = loop.after(deadline - loop.now(), () -> {
            for (Entry<Inlet> entry : providers.all()) {
                if (entry.channel.isPaused()) providers.extend(entry, loop.now());
            }
            providers.tick(loop.now(), entry -> entry.channel.hasConnection());
            changed();
        });
    }

    @Override
    public boolean hasRoom() {
        if (inbox.hasRoom()) return true;
        isPaused = true;
        return false;
    }

    @Override
    public void deliver(Match provider, byte[] payload, long sender, long sequence) {
        long before = sender == 0 ? 0 : sequences.take(sender, sequence);
        if (before < 0) {
            dropped();
            return;
        }
        missed += before;
        Entry<Inlet> entry = providers.of(sender);
        if (entry != null) providers.extend(entry, loop.now());
        Message message = new Message(payload, sender, sequence, before, provider);
        if (provider.protocol().equals("tcp")) {
            inbox.putStreamed(message);
        } else {
            missed += inbox.putDatagram(message);
        }
        onMessage.run();
    }

    /** The next message that waits, or null. With the lock. */
    public Message poll() {
        Message message = inbox.take();
        if (isPaused && !isClosed && inbox.isHalfEmpty()) {
            isPaused = false;
            loop.after(0, () -> {
                for (Entry<Inlet> entry : providers.all()) entry.channel.resume();
            });
        }
        return message;
    }

    public boolean hasMessage() {
        return !inbox.isEmpty();
    }

    @Override
    public void read(InetSocketAddress from, ByteBuffer datagram) {
        for (Entry<Inlet> entry : hasStrangers ? providers.all() : List.<Entry<Inlet>>of()) {
            if (entry.match().life() == 0 && entry.channel instanceof UdpInlet inlet && inlet.isAt(from)) {
                deliver(entry.match(), octets(datagram), 0, 0);
                return;
            }
        }
        Frame frame = Frame.ofDatagram(datagram);
        Entry<Inlet> entry = frame == null ? null : providers.of(frame.life());
        boolean isBelieved = entry != null && entry.channel instanceof UdpInlet inlet && inlet.isAt(from);
        take(isBelieved ? entry : null, frame);
        if (!isBelieved && frame != null && frame.kind() != Frame.Kind.HELLO) early.put(from, frame, loop.now());
    }

    /** Delivers the frames that came from a provider before the daemon named it. */
    private void deliverEarly(Entry<Inlet> entry) {
        if (entry == null || entry.match().life() == 0 || !(entry.channel instanceof UdpInlet inlet)) return;
        for (Frame frame : early.take(inlet::isAt, entry.match().life(), loop.now())) {
            if (providers.of(frame.life()) != entry) return; // it has ended
            --dropped;
            take(entry, frame);
        }
    }

    @Override
    public void heard(InetSocketAddress group, InetSocketAddress from, ByteBuffer datagram) {
        for (Entry<Inlet> entry : hasStrangers ? providers.all() : List.<Entry<Inlet>>of()) {
            if (entry.match().life() == 0 && entry.channel instanceof MulticastInlet inlet && inlet.isOf(group) && from.getPort() == entry.match().port()) {
                deliver(entry.match(), octets(datagram), 0, 0);
                return;
            }
        }
        Frame frame = Frame.ofDatagram(datagram);
        Entry<Inlet> entry = frame == null ? null : providers.of(frame.life());
        boolean isBelieved = entry != null && entry.channel instanceof MulticastInlet inlet && inlet.isOf(group) && from.getPort() == entry.match().port();
        take(isBelieved ? entry : null, frame);
    }

    private void take(Entry<Inlet> entry, Frame frame) {
        if (entry == null || frame.kind() == Frame.Kind.HELLO) {
            dropped();
        } else if (frame.kind() == Frame.Kind.END) {
            ended(frame.life(), frame.sequence());
        } else {
            deliver(entry.match(), frame.payload(), frame.life(), frame.sequence());
        }
    }

    private static byte[] octets(ByteBuffer datagram) {
        byte[] octets = new byte[datagram.remaining()];
        datagram.get(octets);
        return octets;
    }

    @Override
    public void dropped() {
        ++dropped;
    }

    @Override
    public void ended(long provider, long sequence) {
        Entry<Inlet> entry = providers.of(provider);
        missed += sequences.missedAtEnd(provider, sequence);
        if (entry != null) providers.ended(entry);
        changed();
    }

    @Override
    public boolean broke(long provider) {
        Entry<Inlet> entry = providers.of(provider);
        boolean isWanted = entry != null && providers.broke(entry);
        changed();
        return isWanted;
    }

    /** Withdraws the request and closes its sockets. Messages that wait are lost. With the lock. */
    public void close() {
        if (isClosed) return;
        isClosed = true;
        withdraw();
        providers.closeAll("");
        if (socket != null) socket.close();
        inbox.clear();
        changed();
        onMessage.run();
        loop.changed();
    }

    public boolean isClosed() {
        return isClosed;
    }

    /** Messages that are known to be missing, those lost in a full inbox with them. */
    public long missedCount() {
        return missed;
    }

    /** The datagrams and frames that were not believed or not new. */
    public long droppedCount() {
        return dropped;
    }

    /** A provider with which there is no channel. */
    private static final class NoInlet implements Inlet {
        @Override
        public void changed(Match match) {}

        @Override
        public void ending() {}

        @Override
        public void resume() {}

        @Override
        public boolean isPaused() {
            return false;
        }

        @Override
        public boolean hasConnection() {
            return false;
        }

        @Override
        public void close() {}
    }
}
