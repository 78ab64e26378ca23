package geminga.channels;

import geminga.protocol.Frame;
import geminga.protocol.Handshake;
import geminga.protocol.Limits;
import geminga.protocol.Listeners;
import geminga.protocol.Listeners.Listener;
import geminga.protocol.Places;
import geminga.protocol.PublisherFrames;
import geminga.protocol.Said;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.util.List;

/** The outlet of {@code otm/stream} over UDP to a unicast address: sends to each listener that says hello. */
final class ListenersOutlet implements StreamOutlet, Datagrams.Reader, Greeter.Guests {
    private final Loop loop;
    private final Owner owner;
    private final PublisherFrames frames;
    private final Datagrams socket;
    private final Greeter greeter;
    private final Listeners listeners = new Listeners();
    private Loop.Timer silence;

    ListenersOutlet(Loop loop, Owner owner, PublisherFrames frames, InetAddress address, int port) throws IOException {
        this.loop = loop;
        this.owner = owner;
        this.frames = frames;
        greeter = new Greeter(loop, owner, frames, this);
        socket = Datagrams.open(loop, address, port, this);
    }

    @Override
    public int port() {
        return socket.port();
    }

    @Override
    public void read(InetSocketAddress from, ByteBuffer datagram) {
        greeter.read(socket, from, datagram);
        forgetSilent();
    }

    @Override
    public Said known(InetSocketAddress from, long life) {
        Listener known = listeners.at(from);
        // A sealed life proves itself by its own cookie. Without a key any hello renews the listener of its address.
        boolean isKnown = known != null && (known.said().life() == life || !known.said().isSealed() && frames.takesPlain());
        return isKnown ? known.said() : null;
    }

    @Override
    public void renewed(InetSocketAddress from, long life) {
        listeners.renew(listeners.at(from), loop.now());
    }

    @Override
    public boolean isExpected(long life) {
        return true;
    }

    @Override
    public Said accept(InetSocketAddress from, long life) {
        listeners.remove(from); // another life was there
        Places.Outcome<Listener> outcome = listeners.add(from, loop.now());
        Listener loser = outcome.loser();
        if (loser != null) greeter.answer(socket, loser.address(), Frame.Kind.FULL, new Handshake(loser.said().life(), loser.said().challenge(), 0));
        placesChanged();
        return outcome.isTaken() ? listeners.at(from).said() : null;
    }

    @Override
    public void left(InetSocketAddress from, long life) {
        listeners.remove(from);
        placesChanged();
    }

    private void placesChanged() {
        owner.placesChanged(listeners.places(), Limits.LISTENERS, "listeners");
        owner.changed();
    }

    private void forgetSilent() {
        if (silence != null) silence.cancel();
        silence = null;
        listeners.forget(loop.now());
        if (listeners.all().isEmpty()) return;
        silence = loop.after(listeners.deadline() - loop.now(), () -> {
            forgetSilent();
            placesChanged();
        });
    }

    @Override
    public boolean hasConsumer() {
        return !listeners.all().isEmpty();
    }

    @Override
    public void send(byte[] payload) {
        ByteBuffer datagram = loop.outgoing(frames.message(payload, 0));
        for (Listener listener : listeners.all()) {
            if (!socket.send(datagram, listener.address())) owner.leftOut();
        }
    }

    @Override
    public boolean hasRoom(int octets) {
        return socket.hasRoom();
    }

    @Override
    public void keysChanged(boolean beginsToSeal, boolean isStrict) {
        for (Listener listener : List.copyOf(listeners.all())) {
            Said said = listener.said();
            byte[] floor = beginsToSeal ? frames.answer(Frame.Kind.FLOOR, new Handshake(said.life(), said.challenge(), 0)) : null;
            if (floor != null) socket.send(ByteBuffer.wrap(floor), listener.address());
            // Where plain hellos are taken no more, one does not renew a listener, which then has the rest of its time for a sealed one.
        }
        placesChanged();
    }

    @Override
    public void end() {
        byte[] end = frames.end(0);
        if (end == null) return;
        for (Listener listener : listeners.all()) socket.send(ByteBuffer.wrap(end), listener.address());
    }

    @Override
    public boolean hasEnded() {
        return true;
    }

    @Override
    public void close() {
        if (silence != null) silence.cancel();
        socket.close();
    }
}
