import geminga.Event;
import geminga.Node;
import geminga.Offer;
import geminga.Options;
import geminga.Publisher;
import geminga.protocol.ChannelKeys;
import geminga.protocol.Frame;
import geminga.protocol.FrameReader;
import geminga.protocol.FrameWriter;
import geminga.protocol.Handshake;
import geminga.protocol.Life;
import geminga.protocol.Limits;
import geminga.protocol.LineException;
import geminga.protocol.SealedFrame;
import geminga.protocol.SealedFrame.Direction;
import geminga.protocol.WireFrame;
import java.io.DataInputStream;
import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;

/** A publisher, its scripted daemon, and what is told; and consumers that say what a test wants. */
final class PublisherBench implements AutoCloseable {
    /** A ring of one key. */
    static final String RING = "6208:618408bc05ef2b7c262ac0676abe39df9dfe9db66ca3fe78e3e00d4cda7f5fc8:201c6285b39c9e9b12c712d9f5045fc698f675d1d8957dbca1d05d6fbceea32b";
    /** Another key. */
    static final String OTHER = "beef:" + "11".repeat(32) + ":" + "22".repeat(32);

    final ScriptedDaemon daemon = new ScriptedDaemon();
    final LinkedBlockingQueue<Event> told = new LinkedBlockingQueue<>();
    final LinkedBlockingQueue<String> log = new LinkedBlockingQueue<>();
    final Node node = Node.open(Options.named("test").connect(daemon.address()).listener(told::add).log(log::add), Node::newThread);
    final Publisher publisher;

    PublisherBench(Offer offer) throws Exception {
        this(offer, "");
    }

    /** With a daemon whose greeting says more. */
    PublisherBench(Offer offer, String greeting) throws Exception {
        daemon.greet(greeting);
        publisher = node.publish(offer, told::add);
        daemon.takes();
        Check.that(next() instanceof Event.Connected, "connected");
    }

    /** With a daemon that gives the publisher keys in this mode. */
    static PublisherBench sealed(Offer offer, String mode) throws Exception {
        PublisherBench bench = new PublisherBench(offer, " keys=yes sealing=" + mode);
        bench.keys(mode, RING);
        return bench;
    }

    /** Has the daemon give other keys, and waits until they were read. */
    void keys(String mode, String ring) throws IOException, InterruptedException {
        daemon.say("1 pub keys life=" + Life.write(publisher.life()) + " mode=" + mode + (ring.isEmpty() ? "" : " ring=" + ring));
        daemon.say("0 429 read so far");
        await(told, one -> one instanceof Event.Problem problem && problem.text().equals("429 read so far"));
        await(log, "429 read so far"::equals);
    }

    /** Waits for one thing that is told, and puts back what came before it. */
    private static <T> void await(LinkedBlockingQueue<T> queue, Predicate<T> isIt) throws InterruptedException {
        List<T> before = new ArrayList<>();
        for (T one = queue.poll(30, TimeUnit.SECONDS); !isIt.test(one); one = queue.poll(30, TimeUnit.SECONDS)) before.add(one);
        queue.addAll(before);
    }

    static ChannelKeys keysOf(String mode) throws LineException {
        return ChannelKeys.read(mode, mode.equals("plain") ? "" : RING);
    }

    Event next() throws InterruptedException {
        Event event = told.poll(30, TimeUnit.SECONDS);
        Check.that(event != null, "nothing was told");
        return event;
    }

    void is(String change) throws InterruptedException {
        Event.ConsumerEvent event = (Event.ConsumerEvent) next();
        Check.equal(change, event.change() + " " + event.consumer().life() + " " + event.reason());
    }

    void isProblem(String text) throws InterruptedException {
        Check.equal(text, ((Event.Problem) next()).text());
        Check.equal(text, log.poll(30, TimeUnit.SECONDS));
    }

    void awaitDropped(long count) {
        while (publisher.dropped() < count) Thread.yield();
    }

    /** Nothing comes to the socket. */
    static void isSilent(DatagramSocket socket) throws IOException {
        socket.setSoTimeout(30);
        try {
            socket.receive(new DatagramPacket(new byte[1], 1));
        } catch (SocketTimeoutException nothingCame) {
            return;
        }
        throw new AssertionError("something came");
    }

    /** A plain hello of that life. */
    byte[] hello(long life, long challenge, long cookie) {
        return Frame.hello(life, new Handshake(publisher.life(), challenge, cookie)).write();
    }

    InetSocketAddress address() {
        return new InetSocketAddress("127.0.0.1", publisher.offer().port());
    }

    /** A connection that says hello with that life, or nothing where it is 0. */
    Socket connect(long life) throws IOException {
        return connectFrom("127.0.0.1", life);
    }

    Socket connectFrom(String local, long life) throws IOException {
        Socket socket = new Socket(InetAddress.getByName("127.0.0.1"), publisher.offer().port(), InetAddress.getByName(local), 0);
        socket.setSoTimeout(30_000);
        if (life != 0) socket.getOutputStream().write(hello(life, 5, 0));
        return socket;
    }

    void send(DatagramSocket from, byte[] octets) throws IOException {
        from.send(new DatagramPacket(octets, octets.length, address()));
    }

    /** A consumer that seals what it says, and opens what it hears. */
    final class Consumer {
        private final FrameWriter writer;
        final long life;
        ChannelKeys keys;

        Consumer(long life, String mode) throws LineException {
            this.life = life;
            keys = keysOf(mode);
            writer = new FrameWriter(life, Direction.BACK);
        }

        byte[] say(Frame.Kind kind, long challenge, long cookie) {
            return writer.write(keys, kind, 0, new Handshake(publisher.life(), challenge, cookie).write());
        }

        byte[] hello(long challenge, long cookie) {
            return say(Frame.Kind.HELLO, challenge, cookie);
        }

        Frame open(WireFrame frame) {
            return frame == null ? null : keys.open(frame, Direction.FORWARD);
        }

        /** The next frame of a socket, which must be this answer to it; its cookie. */
        long isAnswered(Frame.Kind kind, long challenge, WireFrame frame) {
            Frame answer = open(frame);
            Handshake said = Handshake.read(answer.payload());
            Check.equal(kind + " " + life + " " + challenge, answer.kind() + " " + said.life() + " " + said.challenge());
            return said.cookie();
        }
    }

    static WireFrame readAny(Socket socket) throws IOException {
        DataInputStream octets = new DataInputStream(socket.getInputStream());
        byte[] header = octets.readNBytes(Frame.HEADER);
        if (header.length < Frame.HEADER) return null;
        int more = header[2] == 1 ? 0 : SealedFrame.HEADER - Frame.HEADER;
        byte[] payload = octets.readNBytes(more + ByteBuffer.wrap(header).getInt(4));
        return new FrameReader(Limits.TCP_MESSAGE).next(ByteBuffer.allocate(header.length + payload.length).put(header).put(payload).flip());
    }

    static Frame read(Socket socket) throws IOException {
        return (Frame) readAny(socket);
    }

    static byte[] receive(DatagramSocket socket) throws IOException {
        socket.setSoTimeout(30_000);
        DatagramPacket packet = new DatagramPacket(new byte[66_000], 66_000);
        socket.receive(packet);
        return Arrays.copyOf(packet.getData(), packet.getLength());
    }

    static WireFrame frame(DatagramSocket socket) throws IOException {
        return WireFrame.ofDatagram(ByteBuffer.wrap(receive(socket)));
    }

    @Override
    public void close() throws Exception {
        daemon.close();
        node.close();
    }
}
