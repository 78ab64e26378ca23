package geminga.channels;

import geminga.Match;
import geminga.protocol.Addresses;
import geminga.protocol.Counterparts.Entry;
import geminga.protocol.Frame;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.util.LinkedHashSet;
import java.util.Set;

/** The outlet over UDP to each consumer that the daemon has named. For {@code otm/pubsub} there is a socket only while there is a consumer. */
final class UdpOutlet implements Outlet {
    private static final class Target implements Consumer {
        private final boolean takesFrames;
        private InetSocketAddress address;

        Target(boolean takesFrames) {
            this.takesFrames = takesFrames;
        }

        @Override
        public boolean isThere() {
            return true;
        }
    }

    private final Loop loop;
    private final Owner owner;
    private final long life;
    private final InetAddress address;
    private final boolean closesWithoutConsumer;
    private final Set<Target> targets = new LinkedHashSet<>();
    private Datagrams socket;
    private int port;

    UdpOutlet(Loop loop, Owner owner, long life, InetAddress address, int port, boolean closesWithoutConsumer) throws IOException {
        this.loop = loop;
        this.owner = owner;
        this.life = life;
        this.address = address;
        this.closesWithoutConsumer = closesWithoutConsumer;
        socket = closesWithoutConsumer ? null : Datagrams.open(loop, address, port, null);
        this.port = closesWithoutConsumer ? Datagrams.free(address, port) : socket.port();
    }

    @Override
    public int port() {
        return port;
    }

    @Override
    public boolean hasConsumer() {
        return !targets.isEmpty();
    }

    @Override
    public void send(byte[] payload, long sequence) {
        ByteBuffer datagram = frame(loop.outgoing, life, payload, sequence);
        for (Target target : targets) {
            datagram.position(target.takesFrames ? 0 : Frame.HEADER); // a consumer without a life gets the payload alone
            if (target.address == null || socket == null || !socket.send(datagram, target.address)) owner.leftOut();
        }
    }

    static ByteBuffer frame(ByteBuffer to, long life, byte[] payload, long sequence) {
        Frame.putHeader(to.clear(), Frame.Kind.MESSAGE, life, sequence, payload.length);
        return to.put(payload).flip();
    }

    @Override
    public boolean hasRoom(int octets) {
        return socket == null || socket.hasRoom();
    }

    @Override
    public void opened(Entry<Consumer> entry) {
        Target target = new Target(entry.match().life() != 0);
        entry.channel = target;
        target.address = address(entry.match());
        targets.add(target);
        if (socket == null) openSocket();
    }

    private void openSocket() {
        try {
            socket = Datagrams.open(loop, address, port, null);
            return;
        } catch (IOException isTaken) {
            // another one, below
        }
        try {
            socket = Datagrams.open(loop, address, 0, null);
            port = socket.port();
            owner.moved(port);
        } catch (IOException fault) {
            owner.problem("no socket for a publisher: " + fault.getMessage());
        }
    }

    private static InetSocketAddress address(Match match) {
        InetAddress read = match.address().isEmpty() || match.port() == 0 ? null : Addresses.read(match.address());
        return read == null ? null : new InetSocketAddress(read, match.port());
    }

    @Override
    public void changed(Entry<Consumer> entry, Match before) {
        ((Target) entry.channel).address = address(entry.match());
    }

    @Override
    public void closed(Entry<Consumer> entry) {
        targets.remove((Target) entry.channel);
        if (targets.isEmpty() && closesWithoutConsumer) closeSocket();
    }

    private void closeSocket() {
        if (socket != null) socket.close();
        socket = null;
    }

    @Override
    public boolean hasConnection(Entry<Consumer> entry) {
        return false;
    }

    @Override
    public void end(long sequence) {
        ByteBuffer end = ByteBuffer.wrap(Frame.end(life, sequence).write());
        for (Target target : targets) {
            if (target.takesFrames && target.address != null && socket != null) socket.send(end, target.address);
        }
    }

    @Override
    public boolean hasEnded() {
        return true;
    }

    @Override
    public void close() {
        closeSocket();
    }
}
