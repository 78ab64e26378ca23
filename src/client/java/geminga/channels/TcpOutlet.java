package geminga.channels;

import geminga.Match;
import geminga.protocol.Counterparts.Entry;
import geminga.protocol.Frame;
import geminga.protocol.FrameReader;
import geminga.protocol.Limits;
import java.io.IOException;
import java.net.InetAddress;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.SelectionKey;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;

/** The outlet over TCP: it listens, and a connection becomes a consumer if its hello has the life of one that the daemon has named; with {@code otm/stream}, any life. */
final class TcpOutlet implements Outlet, Loop.Ready {
    private static final int BACKLOG = 256;

    /** A consumer that the daemon has named. */
    private final class Expected implements Consumer {
        private final long consumer;

        Expected(long consumer) {
            this.consumer = consumer;
        }

        @Override
        public boolean isThere() {
            return guests.containsKey(consumer);
        }
    }

    private final Loop loop;
    private final Owner owner;
    private final long life;
    private final boolean isStream;
    private final ServerSocketChannel server;
    /** Connections without a hello, the oldest first; and those whose consumer the daemon has not named yet. */
    private final ArrayDeque<Guest> unknown = new ArrayDeque<>();
    private final Map<Long, Guest> early = new LinkedHashMap<>();
    private final Map<Long, Guest> guests = new LinkedHashMap<>();
    /** Connections that get the frames that still wait for them. */
    private final Set<Guest> leaving = new LinkedHashSet<>();
    private final Map<Long, Entry<Consumer>> expected = new LinkedHashMap<>();

    TcpOutlet(Loop loop, Owner owner, long life, InetAddress address, int port, boolean isStream) throws IOException {
        this.loop = loop;
        this.owner = owner;
        this.life = life;
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
                if (unknown.size() == Limits.UNKNOWN_CONNECTIONS) unknown.peek().stream.look(); // its hello may have come
                if (unknown.size() == Limits.UNKNOWN_CONNECTIONS) unknown.peek().leave();
                new Guest(channel);
            } catch (IOException fault) {
                loop.interest(key, SelectionKey.OP_ACCEPT, false); // no descriptors are left: look again soon
                loop.after(Limits.HELLO_INTERVAL, () -> loop.interest(key, SelectionKey.OP_ACCEPT, true));
                return;
            }
        }
    }

    /** One connection of a consumer, or of a stranger. */
    private final class Guest implements Stream.Reader {
        private final FrameReader frames = new FrameReader(Long.BYTES);
        private final Stream stream;
        private Loop.Timer patience;
        private long waitingBefore;
        private long consumer;

        Guest(SocketChannel channel) throws IOException {
            Stream made;
            try {
                made = Stream.accepted(loop, channel, this);
            } catch (IOException fault) {
                channel.close();
                throw fault;
            }
            stream = made;
            unknown.add(this);
            patience = loop.after(Limits.UNKNOWN_CONNECTION, this::leave);
        }

        @Override
        public void connected() {}

        @Override
        public void read(ByteBuffer octets) {
            for (Frame frame = frames.next(octets); frame != null; frame = frames.next(octets)) {
                if (frame.kind() == Frame.Kind.HELLO && consumer == 0) {
                    introduce(frame.life());
                } else if (frame.kind() == Frame.Kind.END) {
                    leave();
                    return;
                } else {
                    owner.dropped();
                }
            }
            if (!frames.isBroken()) return;
            owner.dropped();
            leave();
        }

        private void introduce(long said) {
            consumer = said;
            unknown.remove(this);
            if (isStream || expected.containsKey(said)) {
                admit();
                return;
            }
            Guest before = early.get(said);
            if (before != null) before.leave();
            if (early.size() == Limits.TCP_CONSUMERS) {
                owner.dropped();
                leave();
                return;
            }
            early.put(said, this);
        }

        /** Makes the connection a consumer's. */
        void admit() {
            patience.cancel();
            early.remove(consumer, this);
            Guest before = guests.get(consumer);
            if (before == null && guests.size() == Limits.TCP_CONSUMERS) {
                owner.dropped();
                leave();
                return;
            }
            guests.put(consumer, this);
            Entry<Consumer> entry = expected.get(consumer);
            if (before != null) {
                before.leave();
            } else if (entry != null) {
                owner.arrived(entry);
            }
            owner.changed();
        }

        @Override
        public void drained() {
            owner.changed();
        }

        @Override
        public void finished() {
            leave();
        }

        @Override
        public void broke(String reason) {
            leave();
        }

        /** Writes the frames that wait, and closes. A consumer that takes nothing for a while is left. */
        void finish() {
            guests.remove(consumer, this);
            leaving.add(this);
            stream.finish();
            waitingBefore = stream.waiting();
            patience = loop.after(Limits.CLOSING, this::lookAgain);
        }

        private void lookAgain() {
            boolean hasTaken = stream.waiting() < waitingBefore;
            waitingBefore = stream.waiting();
            if (hasTaken) {
                patience = loop.after(Limits.CLOSING, this::lookAgain);
            } else {
                leave();
            }
        }

        void leave() {
            patience.cancel();
            stream.close();
            if (leaving.remove(this)) owner.changed();
            unknown.remove(this);
            early.remove(consumer, this);
            if (!guests.remove(consumer, this)) return;
            Entry<Consumer> entry = expected.get(consumer);
            if (entry != null) owner.departed(entry);
            owner.changed();
        }
    }

    @Override
    public boolean hasConsumer() {
        return !guests.isEmpty();
    }

    @Override
    public void send(byte[] payload, long sequence) {
        ByteBuffer header = loop.outgoing.clear();
        Frame.putHeader(header, Frame.Kind.MESSAGE, life, sequence, payload.length);
        header.flip();
        for (Guest guest : guests.values()) {
            if (guest.stream.hasRoom(Frame.HEADER + payload.length)) {
                guest.stream.write(header.rewind(), ByteBuffer.wrap(payload));
            } else {
                owner.leftOut();
            }
        }
    }

    @Override
    public boolean hasRoom(int octets) {
        return guests.values().stream().allMatch(guest -> guest.stream.hasRoom(Frame.HEADER + octets));
    }

    @Override
    public void opened(Entry<Consumer> entry) {
        entry.channel = new Expected(entry.match().life());
        if (entry.match().life() == 0) {
            owner.problem("the consumer " + entry.match().word() + " states no channel and is not served over TCP");
            return;
        }
        expected.put(entry.match().life(), entry);
        Guest guest = early.get(entry.match().life());
        if (guest != null) guest.admit();
    }

    @Override
    public void changed(Entry<Consumer> entry, Match before) {}

    @Override
    public void closed(Entry<Consumer> entry) {
        expected.remove(entry.match().life());
        Guest guest = guests.get(entry.match().life());
        if (guest != null) guest.finish();
    }

    @Override
    public boolean hasConnection(Entry<Consumer> entry) {
        return guests.containsKey(entry.match().life());
    }

    @Override
    public void end(long sequence) {
        loop.close(server);
        for (Guest guest : new ArrayList<>(unknown)) guest.leave();
        for (Guest guest : new ArrayList<>(early.values())) guest.leave();
        expected.clear();
        for (Guest guest : new ArrayList<>(guests.values())) {
            guest.stream.write(ByteBuffer.wrap(Frame.end(life, sequence).write()));
            guest.finish();
        }
    }

    @Override
    public boolean hasEnded() {
        return guests.isEmpty() && leaving.isEmpty();
    }

    @Override
    public void close() {
        if (server.isOpen()) loop.close(server);
        for (Guest guest : new ArrayList<>(guests.values())) guest.leave();
        for (Guest guest : new ArrayList<>(leaving)) guest.leave();
    }
}
