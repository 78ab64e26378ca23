package geminga.channels;

import geminga.Match;
import geminga.protocol.Counterparts.Entry;
import geminga.protocol.Frame;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.NetworkInterface;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.concurrent.TimeUnit;

/** The outlet of {@code otm/stream} over UDP to a multicast address: sends to the group on every interface, whether anybody listens or not. */
final class MulticastOutlet implements Outlet {
    /** The time between two looks at the interfaces. */
    static final long LOOK = TimeUnit.SECONDS.toNanos(2);

    private final Loop loop;
    private final Owner owner;
    private final long life;
    private final InetSocketAddress group;
    private final Datagrams socket;
    private List<NetworkInterface> interfaces = List.of();
    private Loop.Timer look;

    MulticastOutlet(Loop loop, Owner owner, long life, InetAddress group, int port) throws IOException {
        this.loop = loop;
        this.owner = owner;
        this.life = life;
        socket = Datagrams.group(loop, new InetSocketAddress(group, port), null);
        this.group = new InetSocketAddress(group, socket.port());
        look();
    }

    private void look() {
        List<NetworkInterface> found = Datagrams.interfaces(group.getAddress());
        if (found.size() == 1 && !found.equals(interfaces)) socket.via(found.get(0));
        interfaces = found;
        look = loop.after(LOOK, this::look);
    }

    @Override
    public int port() {
        return socket.port();
    }

    @Override
    public boolean hasConsumer() {
        return true;
    }

    @Override
    public void send(byte[] payload, long sequence) {
        say(UdpOutlet.frame(loop.outgoing, life, payload, sequence));
    }

    private void say(ByteBuffer datagram) {
        boolean isSent = false;
        if (interfaces.size() == 1) {
            isSent = socket.send(datagram, group);
        } else {
            for (NetworkInterface one : interfaces) isSent |= socket.via(one) && socket.send(datagram, group);
        }
        if (!isSent) owner.leftOut();
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
        say(ByteBuffer.wrap(Frame.end(life, sequence).write()));
    }

    @Override
    public boolean hasEnded() {
        return true;
    }

    @Override
    public void close() {
        look.cancel();
        socket.close();
    }
}
