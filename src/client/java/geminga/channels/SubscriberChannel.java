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
import geminga.protocol.ChannelKeys;
import geminga.protocol.Frame;
import geminga.protocol.FrameWriter;
import geminga.protocol.Inbox;
import geminga.protocol.Life;
import geminga.protocol.LineException;
import geminga.protocol.ProviderKeys;
import geminga.protocol.SealedFrame;
import geminga.protocol.Sequence;
import geminga.protocol.Told;
import geminga.protocol.WireFrame;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletionStage;
import java.util.function.Consumer;
import java.util.random.RandomGenerator;

/** A subscriber behind the face: its statement, its providers, its inlets and its inbox. */
public final class SubscriberChannel extends Stated implements Counterparts.Watcher<ProviderChannel>, ProviderChannel.Owner {
    private static final List<String> FIXED = List.of("mode", "port", "address", "protocol");

    private final Counterparts<ProviderChannel> providers = new Counterparts<>(this, true);
    private final Sequence sequences = new Sequence();
    private final Inbox inbox = new Inbox();
    private final EarlyFrames early = new EarlyFrames();
    private final Consumer<ProviderEvent> listener;
    private final RandomGenerator chance;
    private final FrameWriter writer;
    private final DatagramInlets datagrams;
    private final TcpPlaces tcpPlaces;
    private final ProviderKeys keys = new ProviderKeys();
    private Runnable onMessage = () -> {};
    private volatile Request request;
    private Loop.Timer timer;
    private long dropped;
    private long missed;
    /** Whether connections wait for room. */
    private boolean isPaused;
    private boolean isClosed;

    /** Opens the socket and states the request. With the lock. */
    public SubscriberChannel(Loop loop, DaemonLink daemon, Request request, long life, RandomGenerator chance, Consumer<ProviderEvent> listener) throws IOException {
        super(loop, daemon, "sub");
        this.listener = listener;
        this.chance = chance;
        writer = new FrameWriter(life, SealedFrame.Direction.BACK);
        tcpPlaces = new TcpPlaces(loop, this);
        if (!request.protocols().contains("udp") && !request.protocols().contains("tcp")) throw new IllegalArgumentException("protocol: a subscriber hears udp and tcp");
        InetAddress address = request.address().isEmpty() ? null : Addresses.read(request.address());
        request.attribute("channel", Life.write(life)); // throws if there is no room for it
        datagrams = new DatagramInlets(loop, this, providers);
        if (request.protocols().contains("udp")) datagrams.open(address, request.port());
        this.request = stated(request);
        providers.limit(request.limit());
        begin();
    }

    /** The request with the port and the life that the library states. */
    private Request stated(Request asked) {
        Request own = asked.attribute("channel", Life.write(life())).protocols(asked.protocols().toArray(String[]::new));
        return datagrams.port() == 0 || asked.port() != 0 ? own : own.port(datagrams.port());
    }

    public Request request() {
        return request;
    }

    @Override
    public long life() {
        return writer.life();
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
            Entry<ProviderChannel> entry = providers.at(event.word());
            boolean hasEnded = providers.isLeftOpen(event.word(), event.reason()) && entry.channel.endsAsSaid();
            if (!hasEnded) providers.remove(event.word(), event.reason(), loop.now());
        } else {
            try {
                Match match = event.match();
                if (event.change() == Change.ADDED) {
                    providers.put(match, loop.now());
                } else {
                    providers.modify(match, loop.now());
                }
                Entry<ProviderChannel> entry = providers.at(event.word());
                if (entry != null) deliverEarly(entry.channel);
            } catch (LineException wasRead) {
                throw new IllegalStateException(wasRead);
            }
        }
        changed();
    }

    @Override
    void keys(long provider, ChannelKeys told) {
        if (provider == 0 || isClosed) return;
        keys.put(provider, told);
        Entry<ProviderChannel> entry = providers.of(provider);
        if (entry != null && entry.channel.keys(told)) {
            entry.channel.inlet(inlet(entry.channel));
            deliverEarly(entry.channel);
        }
    }

    @Override
    void daemonKeys(boolean hasKeys) {
        keys.clear();
        if (hasKeys) return;
        for (Entry<ProviderChannel> entry : providers.all()) {
            if (entry.match().life() != 0) keys(entry.match().life(), ChannelKeys.NONE);
        }
        keys.clear();
        modeChanged();
    }

    /** Services without a life cannot be sealed, so they are connected only where plain frames are taken. */
    @Override
    void modeChanged() {
        for (Entry<ProviderChannel> entry : providers.all()) {
            if (entry.match().life() != 0) continue;
            entry.channel.inlet().close();
            entry.channel.inlet(inlet(entry.channel));
        }
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
    public void opened(Entry<ProviderChannel> entry) {
        ChannelKeys told = keys.of(entry.match().life());
        ProviderChannel channel = new ProviderChannel(loop, this, entry.match(), told != null ? told : daemon.keysOfNew(), Life.draw(chance));
        entry.channel = channel;
        channel.inlet(inlet(channel));
        tell(Change.ADDED, entry.match(), "-");
    }

    private Inlet inlet(ProviderChannel channel) {
        Match provider = channel.match();
        boolean hasLife = provider.life() != 0;
        if (!hasLife && daemon.takesPlain() == null || hasLife && channel.keys() == null) return Inlet.NONE; // until the daemon has told the keys
        if (!hasLife && !daemon.takesPlain()) {
            problem(provider.word() + " states no life, so its channel cannot be sealed");
            return Inlet.NONE;
        }
        boolean isHeard = request.protocols().contains(provider.protocol());
        if (isHeard && provider.protocol().equals("tcp") && hasLife) return new TcpInlet(loop, tcpPlaces, channel, chance);
        if (isHeard && provider.protocol().equals("udp")) return datagrams.inlet(channel, request.mode() == Mode.STREAM);
        problem("the provider " + provider.word() + (isHeard ? " states no channel and is not connected over TCP" : " speaks " + provider.protocol()));
        return Inlet.NONE;
    }

    @Override
    public void changed(Entry<ProviderChannel> entry, Match before) {
        Match match = entry.match();
        ProviderChannel channel = entry.channel;
        channel.changed(match);
        boolean isOtherKind = !match.protocol().equals(before.protocol()) || Groups.of(match) == null != (Groups.of(before) == null);
        if (isOtherKind) {
            channel.inlet().close();
            channel.inlet(inlet(channel));
        } else {
            channel.inlet().changed(match);
        }
        if (!Counterparts.isSame(before, match)) tell(Change.MODIFIED, match, "-");
    }

    @Override
    public boolean hasConnection(Entry<ProviderChannel> entry) {
        return entry.channel.inlet().hasConnection();
    }

    @Override
    public void ending(Entry<ProviderChannel> entry) {
        entry.channel.ending();
        if (!(entry.channel.inlet() instanceof TcpInlet)) loop.after(0, this::drain);
    }

    /** Reads what the sockets hold, and ends the providers that were withdrawn. */
    private void drain() {
        if (isClosed) return;
        if (!datagrams.drain()) {
            loop.after(0, this::drain);
            return;
        }
        for (Entry<ProviderChannel> entry : providers.all()) {
            if (entry.isEnding() && !(entry.channel.inlet() instanceof TcpInlet)) providers.ended(entry);
        }
        changed();
    }

    @Override
    public void closed(Entry<ProviderChannel> entry, String reason) {
        entry.channel.inlet().close();
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
            for (Entry<ProviderChannel> entry : providers.all()) {
                if (entry.channel.inlet().isPaused()) providers.extend(entry, loop.now());
            }
            providers.tick(loop.now());
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
    public void deliver(ProviderChannel from, Frame frame, boolean isProved) {
        long before = sequences.take(frame.life(), frame.sequence(), isProved, loop.now());
        if (before < 0) {
            dropped();
            return;
        }
        missed += before;
        Entry<ProviderChannel> entry = providers.of(frame.life());
        if (entry != null) providers.extend(entry, loop.now());
        put(new Message(frame.payload(), frame.life(), frame.sequence(), before, from.match()));
    }

    /** Takes a message of a provider that states no life. */
    void deliverPlain(ProviderChannel from, byte[] payload) {
        put(new Message(payload, 0, 0, 0, from.match()));
    }

    private void put(Message message) {
        if (message.provider().protocol().equals("tcp")) {
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
                for (Entry<ProviderChannel> entry : providers.all()) entry.channel.inlet().resume();
            });
        }
        return message;
    }

    public boolean hasMessage() {
        return !inbox.isEmpty();
    }

    @Override
    public void keepEarly(InetSocketAddress from, WireFrame frame) {
        early.put(from, frame, loop.now());
    }

    /** Delivers the frames that came from a provider before the daemon named it, or before its floor. */
    @Override
    public void deliverEarly(ProviderChannel channel) {
        long provider = channel.match().life();
        Inlet inlet = channel.inlet();
        if (provider == 0 || inlet == Inlet.NONE || inlet instanceof TcpInlet) return;
        for (EarlyFrames.Kept kept : early.take(from -> inlet instanceof MulticastInlet || ((UdpInlet) inlet).isAt(from), provider, loop.now())) {
            Entry<ProviderChannel> entry = providers.of(provider);
            if (entry == null || entry.channel != channel) return; // it has ended
            --dropped;
            channel.take(kept.frame(), kept.from());
        }
    }

    @Override
    public void dropped() {
        ++dropped;
    }

    @Override
    public void ended(ProviderChannel channel, long sequence, boolean isProved) {
        Entry<ProviderChannel> entry = providers.of(channel.match().life());
        missed += sequences.missedAtEnd(channel.match().life(), sequence, isProved);
        if (entry != null) providers.ended(entry);
        changed();
    }

    @Override
    public boolean broke(ProviderChannel channel) {
        Entry<ProviderChannel> entry = providers.of(channel.match().life());
        boolean isWanted = entry != null && providers.broke(entry);
        changed();
        return isWanted;
    }

    @Override
    public byte[] write(ChannelKeys ofProvider, Frame.Kind kind, byte[] payload) {
        return writer.write(ofProvider, kind, 0, payload);
    }

    /** Withdraws the request and closes its sockets. Messages that wait are lost. With the lock. */
    public void close() {
        if (isClosed) return;
        isClosed = true;
        withdraw();
        tcpPlaces.close();
        providers.closeAll("");
        datagrams.close();
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
}
