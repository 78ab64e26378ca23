package geminga.channels;

import geminga.Match;
import geminga.protocol.Counterparts.Entry;
import geminga.protocol.Frame;
import geminga.protocol.Listeners;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;

/** The outlet of {@code otm/stream} over UDP to a unicast address: sends to each listener that says hello. */
final class ListenersOutlet implements Outlet, Datagrams.Reader {
    private final Loop loop;
    private final Owner owner;
    private final long life;
    private final Datagrams socket;
    private final Listeners<InetSocketAddress> listeners = new Listeners<>();
    private Loop.Timer silence;

    ListenersOutlet(Loop loop, Owner owner, long life, InetAddress address, int port) throws IOException {
        this.loop = loop;
        this.owner = owner;
        this.life = life;
        socket = Datagrams.open(loop, address, port, this);
    }

    @Override
    public int port() {
        return socket.port();
    }

    @Override
    public void read(InetSocketAddress from, ByteBuffer datagram) {
        Frame frame = Frame.ofDatagram(datagram);
        boolean isToUs = frame != null && frame.kind() != Frame.Kind.MESSAGE && frame.isFor(life);
        if (!isToUs) {
            owner.dropped();
            return;
        }
        if (frame.kind() == Frame.Kind.END) {
            listeners.remove(from);
        } else if (!listeners.heard(from, loop.now())) {
            owner.dropped();
        }
        owner.changed();
        forgetSilent();
    }

    private void forgetSilent() {
        if (silence != null) silence.cancel();
        silence = null;
        listeners.forget(loop.now());
        if (listeners.all().isEmpty()) return;
        silence = loop.after(listeners.deadline() - loop.now(), () -> {
            forgetSilent();
            owner.changed();
        });
    }

    @Override
    public boolean hasConsumer() {
        return !listeners.all().isEmpty();
    }

    @Override
    public void send(byte[] payload, long sequence) {
        ByteBuffer datagram = UdpOutlet.frame(loop.outgoing, life, payload, sequence);
        for (InetSocketAddress listener : listeners.all()) {
            if (!socket.send(datagram, listener)) owner.leftOut();
        }
    }

    @Override
    public boolean hasRoom(int octets) {
        return socket.hasRoom();
    }

    @Override
    public void opened(Entry<Consumer> entry) {
        throw new IllegalStateException("the daemon tells of no consumers of a stream");
    }

    @Override
    public void changed(Entry<Consumer> entry, Match before) {}

    @Override
    public void closed(Entry<Consumer> entry) {}

    @Override
    public boolean hasConnection(Entry<Consumer> entry) {
        return false;
    }

    @Override
    public void end(long sequence) {
        ByteBuffer end = ByteBuffer.wrap(Frame.end(life, sequence).write());
        for (InetSocketAddress listener : listeners.all()) socket.send(end, listener);
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
