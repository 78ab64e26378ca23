package geminga.channels;

import geminga.Match;
import geminga.protocol.Addresses;
import geminga.protocol.Counterparts.Entry;
import geminga.protocol.Frame;
import geminga.protocol.Handshake;
import geminga.protocol.Limits;
import geminga.protocol.PublisherFrames;
import geminga.protocol.Said;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;

/**
 * The outlet over UDP to each consumer that the daemon has named; where frames are sealed, to those that have said hello. For {@code otm/pubsub} there is a socket only while there
 * is a consumer.
 */
final class UdpOutlet implements Outlet, Datagrams.Reader, Greeter.Guests {
    private final class Target extends Consumer {
        private final Entry<Consumer> entry;
        private final long life;
        private InetSocketAddress address;
        /** Its last hello that was believed; null until it was accepted. */
        private Said said;

        Target(Entry<Consumer> entry) {
            this.entry = entry;
            life = entry.match().life();
        }

        @Override
        boolean isThere() {
            if (frames.keys() == null) return false;
            return life == 0 ? frames.takesPlain() : said != null || !frames.seals();
        }
    }

    private final Loop loop;
    private final Owner owner;
    private final PublisherFrames frames;
    private final InetAddress address;
    private final boolean closesWithoutConsumer;
    private final Greeter greeter;
    private final Set<Target> targets = new LinkedHashSet<>();
    private final Map<Long, Target> byLife = new LinkedHashMap<>();
    private Datagrams socket;
    private int port;

    UdpOutlet(Loop loop, Owner owner, PublisherFrames frames, InetAddress address, int port, boolean closesWithoutConsumer) throws IOException {
        this.loop = loop;
        this.owner = owner;
        this.frames = frames;
        this.address = address;
        this.closesWithoutConsumer = closesWithoutConsumer;
        greeter = new Greeter(loop, owner, frames, this);
        socket = closesWithoutConsumer ? null : Datagrams.open(loop, address, port, this);
        this.port = closesWithoutConsumer ? Datagrams.free(address, port) : socket.port();
    }

    @Override
    public int port() {
        return port;
    }

    @Override
    public boolean hasConsumer() {
        return targets.stream().anyMatch(Target::isThere);
    }

    @Override
    public void send(byte[] payload) {
        ByteBuffer datagram = loop.outgoing(frames.message(payload, 0));
        for (Target target : targets) {
            if (!target.isThere()) continue;
            ByteBuffer octets = target.life == 0 ? ByteBuffer.wrap(payload) : datagram; // a consumer without a life gets the payload alone
            if (target.address == null || socket == null || !socket.send(octets, target.address)) owner.leftOut();
        }
    }

    @Override
    public void read(InetSocketAddress from, ByteBuffer datagram) {
        if (socket != null) greeter.read(socket, from, datagram);
    }

    @Override
    public Said known(InetSocketAddress from, long life) {
        Target target = byLife.get(life);
        return target == null ? null : target.said;
    }

    @Override
    public void renewed(InetSocketAddress from, long life) {}

    @Override
    public boolean isExpected(long life) {
        return byLife.containsKey(life);
    }

    @Override
    public Said accept(InetSocketAddress from, long life) {
        Target target = byLife.get(life);
        target.said = new Said();
        owner.arrived(target.entry);
        owner.changed();
        return target.said;
    }

    @Override
    public void left(InetSocketAddress from, long life) {
        byLife.get(life).said = null; // its daemon tells the end
        owner.changed();
    }

    @Override
    public boolean hasRoom(int octets) {
        return socket == null || socket.hasRoom();
    }

    @Override
    public void opened(Entry<Consumer> entry) {
        Target target = new Target(entry);
        entry.channel = target;
        target.address = address(entry.match());
        targets.add(target);
        if (target.life != 0) byLife.put(target.life, target);
        if (socket == null) openSocket();
        tellUnsealable(target);
    }

    private void tellUnsealable(Target target) {
        boolean isUnsealable = target.life == 0 && frames.keys() != null && !frames.takesPlain();
        if (isUnsealable) owner.problem(target.entry.match().word() + " states no life, so its channel cannot be sealed");
    }

    private void openSocket() {
        try {
            socket = Datagrams.open(loop, address, port, this);
            return;
        } catch (IOException isTaken) {
            // another one, below
        }
        try {
            socket = Datagrams.open(loop, address, 0, this);
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
        Target target = (Target) entry.channel;
        targets.remove(target);
        byLife.remove(target.life, target);
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
    public void keysChanged(boolean beginsToSeal, boolean isStrict) {
        for (Target target : targets) {
            if (beginsToSeal && target.said != null && socket != null && target.address != null) {
                byte[] floor = frames.answer(Frame.Kind.FLOOR, new Handshake(target.life, target.said.challenge(), 0));
                if (floor != null) socket.send(ByteBuffer.wrap(floor), target.address);
            }
            if (isStrict) tellUnsealable(target);
            if (target.isThere()) owner.arrived(target.entry);
        }
        if (isStrict) loop.after(Limits.UNKNOWN_CONNECTION, this::forgetPlain);
        owner.changed();
    }

    /** Consumers that said a plain hello have had time for a sealed one. */
    private void forgetPlain() {
        if (frames.takesPlain()) return;
        for (Target target : targets) {
            if (target.said != null && !target.said.isSealed()) target.said = null;
        }
        owner.changed();
    }

    @Override
    public void end() {
        byte[] end = frames.end(0);
        if (end == null) return;
        for (Target target : targets) {
            if (target.life != 0 && target.isThere() && target.address != null && socket != null) socket.send(ByteBuffer.wrap(end), target.address);
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
