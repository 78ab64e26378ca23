import geminga.Event;
import geminga.Identity;
import geminga.MessageTooLargeException;
import geminga.Mode;
import geminga.Offer;
import geminga.Publisher;
import geminga.protocol.Frame;
import geminga.protocol.Handshake;
import geminga.protocol.Life;
import geminga.protocol.Limits;
import java.io.IOException;
import java.net.DatagramSocket;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;

/** Publishers and plain sockets: what is written, who is a consumer, and the limits (src/client/CHANNELS.md). */
final class PublisherTest {
    private static final Duration LONG = Duration.ofSeconds(30);
    private static final String LIFE = "000000000000000a";
    private static final String WORD = "5e6f7a8b/3/1";

    private static Offer offer(Mode mode) {
        return Offer.of(mode, Identity.text("x"));
    }

    static void withoutAConsumerNothingIsCounted() throws Exception {
        try (PublisherBench bench = new PublisherBench(offer(Mode.PUBSUB))) {
            Check.that(!bench.publisher.send(new byte[3]), "nobody is there");
            Check.equal(0L, bench.publisher.sent());
            Check.fails(MessageTooLargeException.class, () -> bench.publisher.send(new byte[Limits.UDP_MESSAGE + 1]));
        }
    }

    static void overUdpEachConsumerIsSentFramesFromTheStatedPort() throws Exception {
        try (PublisherBench bench = new PublisherBench(offer(Mode.ONE_TO_ONE)); DatagramSocket one = new DatagramSocket(); DatagramSocket other = new DatagramSocket()) {
            bench.daemon.say(ScriptedDaemon.consumer(1, WORD, one.getLocalPort(), LIFE)).say(ScriptedDaemon.consumer(1, "5e6f7a8b/3/2", other.getLocalPort(), "000000000000000b"));
            bench.is("ADDED 10 -");
            bench.is("ADDED 11 -");
            bench.publisher.send("hello".getBytes());
            for (DatagramSocket socket : List.of(one, other)) {
                Check.equal(ByteBuffer.wrap(new Frame(Frame.Kind.MESSAGE, bench.publisher.life(), 1, "hello".getBytes()).write()), ByteBuffer.wrap(PublisherBench.receive(socket)));
            }
            bench.publisher.close();
            Check.equal(ByteBuffer.wrap(Frame.end(bench.publisher.life(), 1).write()), ByteBuffer.wrap(PublisherBench.receive(one)));
        }
    }

    static void aConsumerWithoutALifeIsSentThePayloadAlone() throws Exception {
        try (PublisherBench bench = new PublisherBench(offer(Mode.PUBSUB)); DatagramSocket plain = new DatagramSocket()) {
            bench.daemon.say(ScriptedDaemon.consumer(1, WORD, plain.getLocalPort(), "no-life"));
            bench.is("ADDED 0 -");
            bench.publisher.send("hello".getBytes());
            Check.equal("hello", new String(PublisherBench.receive(plain)));
        }
    }

    static void pubsubHasASocketOnlyWhileThereIsAConsumerAndMovesWhereItsPortIsTaken() throws Exception {
        try (PublisherBench bench = new PublisherBench(offer(Mode.PUBSUB))) {
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
        try (PublisherBench bench = new PublisherBench(offer(Mode.PUBSUB).tcp()); Socket early = bench.connect(10)) {
            Check.that(!bench.publisher.awaitConsumer(Duration.ofMillis(50)), "nobody has announced it");
            bench.daemon.say(ScriptedDaemon.consumer(1, WORD, 9, LIFE));
            bench.is("ADDED 10 -");
            bench.publisher.send("one".getBytes());
            Check.equal("one", new String(PublisherBench.read(early).payload()));
            Socket second = bench.connect(10); // takes the place of the first
            Check.equal(-1, early.getInputStream().read());
            bench.publisher.send("two".getBytes());
            Check.equal(2L, PublisherBench.read(second).sequence());
            second.close();
            bench.is("REMOVED 10 lost");
            Check.that(!bench.publisher.send(new byte[1]), "nobody is there");
            try (Socket third = bench.connect(10)) {
                bench.is("ADDED 10 -");
                bench.daemon.say("1 sub del subscription=" + WORD + " reason=outranked");
                bench.is("REMOVED 10 outranked");
                Check.equal(null, PublisherBench.read(third)); // closed without an end, since this life goes on
            }
        }
    }

    static void aPublisherEndsBehindItsLastMessage() throws Exception {
        try (PublisherBench bench = new PublisherBench(offer(Mode.STREAM).tcp()); Socket consumer = bench.connect(10)) {
            Check.that(bench.publisher.awaitConsumer(LONG), "a stream takes any life");
            for (int i = 0; i < 3; ++i) bench.publisher.send(new byte[100_000]);
            new Thread(bench.publisher::close).start();
            for (int i = 1; i <= 3; ++i) Check.equal((long) i, PublisherBench.read(consumer).sequence());
            Frame end = PublisherBench.read(consumer);
            Check.equal("END 3", end.kind() + " " + end.sequence());
            Check.equal(null, PublisherBench.read(consumer));
        }
    }

    static void fourMebibytesWaitForOneConsumerAndTheOthersAreNotHeldUp() throws Exception {
        try (PublisherBench bench = new PublisherBench(offer(Mode.STREAM).tcp()); Socket slow = bench.connect(10)) {
            Check.that(bench.publisher.awaitConsumer(LONG), "there");
            byte[] message = new byte[Limits.WAITING_FOR_CONSUMER / 4 - Frame.HEADER];
            while (bench.publisher.leftOut() == 0) bench.publisher.send(message);
            Check.that(!bench.publisher.awaitRoom(message.length, Duration.ofMillis(1)), "there is no room");
            long first = bench.publisher.sent();
            for (long sequence = 1; sequence < first; ++sequence) Check.equal(sequence, PublisherBench.read(slow).sequence());
            Check.that(bench.publisher.awaitRoom(message.length, LONG), "there is room again");
            bench.publisher.send(new byte[1]);
            Check.equal(first + 1, PublisherBench.read(slow).sequence());
        }
    }

    static void whereTooMuchWaitsForAllTheSlowestConsumerIsToldAsRemoved() throws Exception {
        try (PublisherBench bench = new PublisherBench(offer(Mode.PUBSUB).tcp())) {
            List<Socket> deaf = new ArrayList<>();
            int large = Limits.TCP_MESSAGE - Frame.HEADER; // one message may always wait
            String removed = "";
            for (int life = 10; removed.isEmpty(); ++life) {
                bench.daemon.say(ScriptedDaemon.consumer(1, "5e6f7a8b/3/" + life, 9, Life.write(life)));
                deaf.add(bench.connect(life));
                while (removed.isEmpty() && !(bench.next() instanceof Event.ConsumerEvent event && event.consumer().life() == life)) Thread.onSpinWait();
                bench.publisher.send(new byte[large]); // waits for this one, and is left out for the others
                for (Event event = bench.told.poll(); event != null; event = bench.told.poll()) {
                    if (event instanceof Event.ConsumerEvent gone && gone.reason().equals("slow")) removed = gone.change() + " " + gone.consumer().life();
                }
                Check.that(life < 20, "64 MiB wait for all");
            }
            Check.that(removed.startsWith("REMOVED "), removed); // which one depends on the system's buffers
            for (Socket socket : deaf) socket.close();
        }
    }

    static void oneMessageOfAnySizeMayWait() throws Exception {
        try (PublisherBench bench = new PublisherBench(offer(Mode.STREAM).tcp()); Socket slow = bench.connect(10)) {
            Check.that(bench.publisher.awaitConsumer(LONG), "there");
            bench.publisher.send(new byte[Limits.TCP_MESSAGE]);
            bench.publisher.send(new byte[Limits.TCP_MESSAGE]);
            Check.equal(1L, bench.publisher.leftOut());
            Check.fails(MessageTooLargeException.class, () -> bench.publisher.send(new byte[Limits.TCP_MESSAGE + 1]));
            Check.equal(Limits.TCP_MESSAGE, PublisherBench.read(slow).payload().length);
        }
    }

    static void soManyConnectionsMayBeSilentAndAnotherAddressStillHasAPlace() throws Exception {
        try (PublisherBench bench = new PublisherBench(offer(Mode.STREAM).tcp())) {
            List<Socket> silent = new ArrayList<>();
            for (int i = 0; i < Limits.UNKNOWN_CONNECTIONS; ++i) silent.add(bench.connect(0));
            silent.get(0).getOutputStream().write(bench.hello(99, 5, 0));
            Check.that(bench.publisher.awaitConsumer(LONG), "the first says hello and is a consumer");
            silent.add(bench.connect(0)); // at the limit
            Check.equal(0L, bench.publisher.dropped());
            try (Socket refused = bench.connect(0)) {
                Check.equal(-1, refused.getInputStream().read());
            }
            Check.equal(1L, bench.publisher.dropped());
            try (Socket other = bench.connectFrom("127.0.0.2", 98)) {
                Check.equal(-1, silent.get(silent.size() - 1).getInputStream().read()); // the newest of the address that has most
                while (bench.publisher.send(new byte[1]) && other.getInputStream().available() == 0) Thread.onSpinWait();
                Check.equal((int) 'G', other.getInputStream().read());
            }
            for (Socket socket : silent) socket.close();
        }
    }

    static void soManyConsumersAreServedAndOneMoreIsToldThatThereIsNoPlace() throws Exception {
        try (PublisherBench bench = new PublisherBench(offer(Mode.STREAM).tcp())) {
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
            Check.equal(null, bench.told.poll());
            try (Socket more = bench.connect(1000)) {
                Frame full = PublisherBench.read(more);
                Check.equal("FULL " + new Handshake(1000, 5, 0), full.kind() + " " + Handshake.read(full.payload()));
                Check.equal(-1, more.getInputStream().read());
            }
            Check.equal(1L, bench.publisher.dropped());
            bench.isProblem("all 256 places for consumers are taken");
            Check.equal("1 pub modify channel.full=256", bench.daemon.heard());
            try (Socket other = bench.connectFrom("127.0.0.2", 1001); Socket again = bench.connect(1002)) {
                Check.equal(Frame.Kind.FULL, PublisherBench.read(again).kind()); // refused, as before
                for (int life = 1; life <= Limits.TCP_CONSUMERS / 2; ++life) consumers.get(life).close();
                Check.equal("0 sys ping", bench.daemon.heard());
                Check.equal("1 pub modify channel.full=0", bench.daemon.heard());
                bench.publisher.send(new byte[1]);
                Check.equal((int) 'G', other.getInputStream().read());
                Check.equal(null, bench.told.poll()); // told once
            }
            for (Socket consumer : consumers) consumer.close();
        }
    }

    static void whoSendsNoFrameIsClosed() throws Exception {
        try (PublisherBench bench = new PublisherBench(offer(Mode.STREAM).tcp()); Socket stranger = bench.connect(0); Socket flood = bench.connect(7)) {
            stranger.getOutputStream().write("GET / HTTP/1.1\r\nHost: robot2\r\n\r\n".getBytes());
            Check.equal(-1, stranger.getInputStream().read());
            ByteBuffer large = ByteBuffer.allocate(Frame.HEADER);
            Frame.putHeader(large, Frame.Kind.MESSAGE, 7, 1, Handshake.OCTETS + 1);
            flood.getOutputStream().write(large.array()); // nobody says so much to a publisher
            Check.equal(-1, flood.getInputStream().read());
            Check.equal(2L, bench.publisher.dropped());
        }
    }

    static void theDaemonMaySayWhatItWantsOfAStreamsConsumers() throws Exception {
        try (PublisherBench bench = new PublisherBench(offer(Mode.STREAM))) {
            bench.daemon.say(ScriptedDaemon.consumer(1, WORD, 9, LIFE)).say("1 sub del subscription=" + WORD + " reason=left");
            Publisher other = bench.node.publish(offer(Mode.STREAM).tcp());
            bench.daemon.takes();
            Check.that(other.awaitTaken(LONG), "it goes on");
            Check.equal(null, bench.told.poll());
        }
    }
}
