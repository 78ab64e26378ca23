import geminga.Event;
import geminga.Identity;
import geminga.MessageTooLargeException;
import geminga.Mode;
import geminga.Node;
import geminga.Offer;
import geminga.Options;
import geminga.Publisher;
import geminga.protocol.Frame;
import geminga.protocol.FrameReader;
import geminga.protocol.Limits;
import java.io.DataInputStream;
import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;

/** Publishers and plain sockets: what is written, who is a consumer, and the limits (src/client/CHANNELS.md). */
final class PublisherTest {
    private static final Duration LONG = Duration.ofSeconds(30);
    private static final String LIFE = "000000000000000a";
    private static final String WORD = "5e6f7a8b/3/1";

    /** A publisher, its daemon, and its events. */
    private static final class Bench implements AutoCloseable {
        final ScriptedDaemon daemon = new ScriptedDaemon();
        final LinkedBlockingQueue<Event> told = new LinkedBlockingQueue<>();
        final Node node = Node.open(Options.named("test").connect(daemon.address()).listener(told::add), Node::newThread);
        final Publisher publisher;

        Bench(Offer offer) throws Exception {
            daemon.greet();
            publisher = node.publish(offer, told::add);
            daemon.takes();
            Check.that(next() instanceof Event.Connected, "connected");
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

        /** A connection that says hello with that life, or nothing where it is 0. */
        Socket connect(long life) throws IOException {
            Socket socket = new Socket(InetAddress.getByName("127.0.0.1"), publisher.offer().port());
            socket.setSoTimeout(30_000);
            if (life != 0) socket.getOutputStream().write(Frame.hello(life).write());
            return socket;
        }

        @Override
        public void close() throws Exception {
            daemon.close();
            node.close();
        }
    }

    private static Offer offer(Mode mode) {
        return Offer.of(mode, Identity.text("x"));
    }

    private static Frame read(Socket socket) throws IOException {
        DataInputStream octets = new DataInputStream(socket.getInputStream());
        byte[] header = octets.readNBytes(Frame.HEADER);
        if (header.length < Frame.HEADER) return null;
        byte[] payload = octets.readNBytes(ByteBuffer.wrap(header).getInt(4));
        return new FrameReader(Limits.TCP_MESSAGE).next(ByteBuffer.allocate(header.length + payload.length).put(header).put(payload).flip());
    }

    private static byte[] receive(DatagramSocket socket) throws IOException {
        socket.setSoTimeout(30_000);
        DatagramPacket packet = new DatagramPacket(new byte[66_000], 66_000);
        socket.receive(packet);
        return Arrays.copyOf(packet.getData(), packet.getLength());
    }

    static void withoutAConsumerNothingIsCounted() throws Exception {
        try (Bench bench = new Bench(offer(Mode.PUBSUB))) {
            Check.that(!bench.publisher.send(new byte[3]), "nobody is there");
            Check.equal(0L, bench.publisher.sent());
            Check.fails(MessageTooLargeException.class, () -> bench.publisher.send(new byte[Limits.UDP_MESSAGE + 1]));
        }
    }

    static void overUdpEachConsumerIsSentFramesFromTheStatedPort() throws Exception {
        try (Bench bench = new Bench(offer(Mode.ONE_TO_ONE)); DatagramSocket one = new DatagramSocket(); DatagramSocket other = new DatagramSocket()) {
            bench.daemon.say(ScriptedDaemon.consumer(1, WORD, one.getLocalPort(), LIFE)).say(ScriptedDaemon.consumer(1, "5e6f7a8b/3/2", other.getLocalPort(), "000000000000000b"));
            bench.is("ADDED 10 -");
            bench.is("ADDED 11 -");
            bench.publisher.send("hello".getBytes());
            for (DatagramSocket socket : List.of(one, other)) {
                Check.equal(ByteBuffer.wrap(new Frame(Frame.Kind.MESSAGE, bench.publisher.life(), 1, "hello".getBytes()).write()), ByteBuffer.wrap(receive(socket)));
            }
            bench.publisher.close();
            Check.equal(ByteBuffer.wrap(Frame.end(bench.publisher.life(), 1).write()), ByteBuffer.wrap(receive(one)));
        }
    }

    static void aConsumerWithoutALifeIsSentThePayloadAlone() throws Exception {
        try (Bench bench = new Bench(offer(Mode.PUBSUB)); DatagramSocket plain = new DatagramSocket()) {
            bench.daemon.say(ScriptedDaemon.consumer(1, WORD, plain.getLocalPort(), "no-life"));
            bench.is("ADDED 0 -");
            bench.publisher.send("hello".getBytes());
            Check.equal("hello", new String(receive(plain)));
        }
    }

    static void pubsubHasASocketOnlyWhileThereIsAConsumerAndMovesWhereItsPortIsTaken() throws Exception {
        try (Bench bench = new Bench(offer(Mode.PUBSUB))) {
            int port = bench.publisher.offer().port();
            try (DatagramSocket thief = new DatagramSocket(port)) {
                bench.daemon.say(ScriptedDaemon.consumer(1, WORD, 9, LIFE));
                bench.is("ADDED 10 -");
                int other = bench.publisher.offer().port();
                Check.that(other != port, "another port than " + thief.getLocalPort());
                Check.equal("1 pub modify port=" + other, bench.daemon.heard());
                Check.fails(IOException.class, () -> new DatagramSocket(other).close());
                bench.daemon.say("1 sub del subscription=" + WORD + " reason=withdrawn");
                bench.is("REMOVED 10 withdrawn");
                bench.publisher.awaitRoom(1, LONG);
                while (!canBind(other)) bench.publisher.awaitRoom(1, Duration.ofMillis(1)); // the selector lets go of it in its next turn
            }
        }
    }

    private static boolean canBind(int port) {
        try (DatagramSocket socket = new DatagramSocket(port)) {
            return socket.isBound();
        } catch (IOException isTaken) {
            return false;
        }
    }

    static void overTcpAConsumerIsThereWhenBothItsWordAndItsConnectionAre() throws Exception {
        try (Bench bench = new Bench(offer(Mode.PUBSUB).tcp()); Socket early = bench.connect(10)) {
            Check.that(!bench.publisher.awaitConsumer(Duration.ofMillis(50)), "nobody has announced it");
            bench.daemon.say(ScriptedDaemon.consumer(1, WORD, 9, LIFE));
            bench.is("ADDED 10 -");
            bench.publisher.send("one".getBytes());
            Check.equal("one", new String(read(early).payload()));
            Socket second = bench.connect(10); // takes the place of the first
            Check.equal(-1, early.getInputStream().read());
            bench.publisher.send("two".getBytes());
            Check.equal(2L, read(second).sequence());
            second.close();
            bench.is("REMOVED 10 lost");
            Check.that(!bench.publisher.send(new byte[1]), "nobody is there");
            try (Socket third = bench.connect(10)) {
                bench.is("ADDED 10 -");
                bench.daemon.say("1 sub del subscription=" + WORD + " reason=outranked");
                bench.is("REMOVED 10 outranked");
                Check.equal(null, read(third)); // closed without an end, since this life goes on
            }
        }
    }

    static void aPublisherEndsBehindItsLastMessage() throws Exception {
        try (Bench bench = new Bench(offer(Mode.STREAM).tcp()); Socket consumer = bench.connect(10)) {
            Check.that(bench.publisher.awaitConsumer(LONG), "a stream takes any life");
            for (int i = 0; i < 3; ++i) bench.publisher.send(new byte[100_000]);
            new Thread(bench.publisher::close).start();
            for (int i = 1; i <= 3; ++i) Check.equal((long) i, read(consumer).sequence());
            Frame end = read(consumer);
            Check.equal("END 3", end.kind() + " " + end.sequence());
            Check.equal(null, read(consumer));
        }
    }

    static void fourMebibytesWaitForOneConsumerAndTheOthersAreNotHeldUp() throws Exception {
        try (Bench bench = new Bench(offer(Mode.STREAM).tcp()); Socket slow = bench.connect(10)) {
            Check.that(bench.publisher.awaitConsumer(LONG), "there");
            byte[] message = new byte[Limits.WAITING_FOR_CONSUMER / 4 - Frame.HEADER];
            while (bench.publisher.leftOut() == 0) bench.publisher.send(message);
            Check.that(!bench.publisher.awaitRoom(message.length, Duration.ofMillis(1)), "there is no room");
            long first = bench.publisher.sent();
            for (long sequence = 1; sequence < first; ++sequence) Check.equal(sequence, read(slow).sequence());
            Check.that(bench.publisher.awaitRoom(message.length, LONG), "there is room again");
            bench.publisher.send(new byte[1]);
            Check.equal(first + 1, read(slow).sequence());
        }
    }

    static void oneMessageOfAnySizeMayWait() throws Exception {
        try (Bench bench = new Bench(offer(Mode.STREAM).tcp()); Socket slow = bench.connect(10)) {
            Check.that(bench.publisher.awaitConsumer(LONG), "there");
            bench.publisher.send(new byte[Limits.TCP_MESSAGE]);
            bench.publisher.send(new byte[Limits.TCP_MESSAGE]);
            Check.equal(1L, bench.publisher.leftOut());
            Check.fails(MessageTooLargeException.class, () -> bench.publisher.send(new byte[Limits.TCP_MESSAGE + 1]));
            Check.equal(Limits.TCP_MESSAGE, read(slow).payload().length);
        }
    }

    static void soManyConnectionsMayBeSilentAndTheOldestIsClosed() throws Exception {
        try (Bench bench = new Bench(offer(Mode.STREAM).tcp())) {
            List<Socket> silent = new ArrayList<>();
            for (int i = 0; i < Limits.UNKNOWN_CONNECTIONS; ++i) silent.add(bench.connect(0));
            silent.get(0).getOutputStream().write(Frame.hello(99).write());
            Check.that(bench.publisher.awaitConsumer(LONG), "the oldest is still there and says hello");
            silent.add(bench.connect(0));
            silent.get(1).setSoTimeout(100);
            Check.fails(IOException.class, () -> silent.get(1).getInputStream().read()); // nothing comes, since there are sixteen
            silent.get(1).setSoTimeout(30_000);
            silent.add(bench.connect(0));
            Check.equal(-1, silent.get(1).getInputStream().read());
            for (Socket socket : silent) socket.close();
        }
    }

    static void soManyConsumersAreServedAndOneMoreIsClosed() throws Exception {
        try (Bench bench = new Bench(offer(Mode.STREAM).tcp())) {
            List<Socket> consumers = new ArrayList<>();
            for (int life = 1; life <= Limits.TCP_CONSUMERS; ++life) {
                Socket consumer = bench.connect(life);
                consumers.add(consumer);
                consumer.setSoTimeout(20);
                for (boolean isHeard = false; !isHeard;) { // until it is a consumer
                    bench.publisher.send(new byte[1]);
                    try {
                        isHeard = consumer.getInputStream().read() == 'G';
                    } catch (SocketTimeoutException notYet) {
                        continue;
                    }
                }
            }
            Check.equal(0L, bench.publisher.dropped());
            try (Socket more = bench.connect(1000)) {
                Check.equal(-1, more.getInputStream().read());
            }
            Check.equal(1L, bench.publisher.dropped());
            for (Socket consumer : consumers) consumer.close();
        }
    }

    static void whoSendsNoFrameIsClosed() throws Exception {
        try (Bench bench = new Bench(offer(Mode.STREAM).tcp()); Socket stranger = bench.connect(0); Socket flood = bench.connect(7)) {
            stranger.getOutputStream().write("GET / HTTP/1.1\r\nHost: robot2\r\n\r\n".getBytes());
            Check.equal(-1, stranger.getInputStream().read());
            ByteBuffer large = ByteBuffer.allocate(Frame.HEADER);
            Frame.putHeader(large, Frame.Kind.MESSAGE, 7, 1, 9);
            flood.getOutputStream().write(large.array()); // nobody says so much to a publisher
            Check.equal(-1, flood.getInputStream().read());
            Check.equal(2L, bench.publisher.dropped());
        }
    }

    static void aStreamOverUdpIsSentToWhoSaysHello() throws Exception {
        try (Bench bench = new Bench(offer(Mode.STREAM)); DatagramSocket listener = new DatagramSocket()) {
            InetSocketAddress address = new InetSocketAddress("127.0.0.1", bench.publisher.offer().port());
            for (byte[] octets : List.of(Frame.toPublisher(Frame.Kind.HELLO, 7, 99).write(), Frame.hello(7).write(), Frame.toPublisher(Frame.Kind.HELLO, 7, bench.publisher.life()).write())) {
                listener.send(new DatagramPacket(octets, octets.length, address));
            }
            Check.that(bench.publisher.awaitConsumer(LONG), "heard");
            Check.equal(2L, bench.publisher.dropped());
            bench.publisher.send("hello".getBytes());
            Check.equal("hello", new String(Frame.ofDatagram(ByteBuffer.wrap(receive(listener))).payload()));
            byte[] end = Frame.toPublisher(Frame.Kind.END, 7, bench.publisher.life()).write();
            listener.send(new DatagramPacket(end, end.length, address));
            while (bench.publisher.awaitConsumer(Duration.ofMillis(1))) Thread.onSpinWait();
            Check.that(!bench.publisher.send(new byte[1]), "nobody listens");
        }
    }

    static void theDaemonMaySayWhatItWantsOfAStreamsConsumers() throws Exception {
        try (Bench bench = new Bench(offer(Mode.STREAM))) {
            bench.daemon.say(ScriptedDaemon.consumer(1, WORD, 9, LIFE)).say("1 sub del subscription=" + WORD + " reason=left");
            Publisher other = bench.node.publish(offer(Mode.STREAM).tcp());
            bench.daemon.takes();
            Check.that(other.awaitTaken(LONG), "it goes on");
            Check.equal(null, bench.told.poll());
        }
    }
}
