import geminga.Identity;
import geminga.Mode;
import geminga.Offer;
import geminga.protocol.ChannelKeys;
import geminga.protocol.Frame;
import geminga.protocol.Handshake;
import geminga.protocol.SealedFrame;
import geminga.protocol.WireFrame;
import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetSocketAddress;
import java.net.MulticastSocket;
import java.net.NetworkInterface;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;

/** A publisher with keys and plain sockets: only a holder of the key becomes its consumer (src/client/CHANNELS.md, "Sealed channels"). */
final class SealedHandshakeTest {
    private static final Duration LONG = Duration.ofSeconds(30);
    private static final String LIFE = "000000000000000a";
    private static final String WORD = "5e6f7a8b/3/1";

    private SealedHandshakeTest() {}

    private static Offer offer(Mode mode) {
        return Offer.of(mode, Identity.text("x"));
    }

    static void aSealedStreamOverUdpIsSentToWhoHasTheKey() throws Exception {
        for (String mode : List.of("encrypted", "authenticated")) {
            try (PublisherBench bench = PublisherBench.sealed(offer(Mode.STREAM), mode); DatagramSocket listener = new DatagramSocket(); DatagramSocket stranger = new DatagramSocket()) {
                PublisherBench.Consumer consumer = bench.new Consumer(7, "encrypted");
                bench.send(stranger, bench.hello(7, 5, 0));
                byte[] hello = consumer.hello(5, 0);
                bench.send(listener, hello);
                long cookie = consumer.isAnswered(Frame.Kind.FLOOR, 5, PublisherBench.frame(listener));
                byte[] accepted = consumer.hello(5, cookie);
                bench.send(stranger, accepted); // recorded, from another address: a new cookie, and no place
                Check.that(consumer.isAnswered(Frame.Kind.FLOOR, 5, PublisherBench.frame(stranger)) != 0, "not accepted");
                bench.send(listener, accepted);
                Check.equal(0L, consumer.isAnswered(Frame.Kind.FLOOR, 5, PublisherBench.frame(listener)));
                Check.that(bench.publisher.awaitConsumer(LONG), "there");
                bench.send(listener, hello); // recorded, from its own address: the counter does not rise
                bench.awaitDropped(2);
                bench.publisher.send("ball".getBytes());
                WireFrame sent = PublisherBench.frame(listener);
                Check.equal("ball", new String(consumer.open(sent).payload()));
                Check.that(!(sent instanceof Frame), "sealed");
                bench.send(listener, new Frame(Frame.Kind.END, 7, 0, new Handshake(bench.publisher.life(), 5, 0).write()).write());
                bench.awaitDropped(3);
                Check.that(bench.publisher.send(new byte[1]), "a forged end changes nothing");
                PublisherBench.isSilent(stranger);
                Check.that(consumer.open(PublisherBench.frame(listener)).sequence() == 2, "the second");
                bench.send(listener, consumer.say(Frame.Kind.END, 5, cookie));
                while (bench.publisher.awaitConsumer(Duration.ofMillis(1))) Thread.onSpinWait();
            }
        }
    }

    static void aSealedChannelOverUdpBeginsWhenTheDaemonsWordAndItsHelloAreThere() throws Exception {
        try (PublisherBench bench = PublisherBench.sealed(offer(Mode.ONE_TO_ONE), "encrypted"); DatagramSocket listener = new DatagramSocket()) {
            PublisherBench.Consumer consumer = bench.new Consumer(10, "encrypted");
            bench.send(listener, consumer.hello(5, 0));
            long cookie = consumer.isAnswered(Frame.Kind.FLOOR, 5, PublisherBench.frame(listener));
            bench.send(listener, consumer.hello(5, cookie)); // nobody has announced it: it is not answered
            PublisherBench.isSilent(listener);
            bench.daemon.say(ScriptedDaemon.consumer(1, WORD, listener.getLocalPort(), LIFE));
            while (bench.told.isEmpty()) {
                bench.send(listener, consumer.hello(5, cookie));
                Thread.onSpinWait();
            }
            bench.is("ADDED 10 -");
            Check.that(bench.publisher.send("ball".getBytes()), "what is told as added is sent to");
            bench.publisher.close();
            List<Frame.Kind> kinds = new ArrayList<>();
            while (!kinds.contains(Frame.Kind.END)) kinds.add(consumer.open(PublisherBench.frame(listener)).kind());
            kinds.removeIf(Frame.Kind.FLOOR::equals);
            Check.equal(List.of(Frame.Kind.MESSAGE, Frame.Kind.END), kinds);
        }
    }

    static void nothingIsSentOrAnsweredUntilTheKeysAreKnown() throws Exception {
        try (PublisherBench bench = new PublisherBench(offer(Mode.PUBSUB), " keys=yes sealing=encrypted"); DatagramSocket listener = new DatagramSocket()) {
            bench.daemon.say(ScriptedDaemon.consumer(1, WORD, listener.getLocalPort(), LIFE)).say("0 msg pong");
            Check.that(!bench.publisher.awaitConsumer(Duration.ofMillis(30)) && !bench.publisher.send(new byte[1]), "nothing is sent");
            bench.keys("encrypted", PublisherBench.RING);
            PublisherBench.Consumer consumer = bench.new Consumer(10, "encrypted");
            bench.send(listener, consumer.hello(5, 0));
            bench.send(listener, consumer.hello(5, consumer.isAnswered(Frame.Kind.FLOOR, 5, PublisherBench.frame(listener))));
            bench.is("ADDED 10 -");
        }
    }

    static void overTcpASealedHelloGivesTheCookieOfItsConnectionBack() throws Exception {
        try (PublisherBench bench = PublisherBench.sealed(offer(Mode.STREAM).tcp(), "encrypted"); Socket socket = bench.connect(0); Socket replay = bench.connect(0); Socket plain = bench.connect(9)) {
            Check.equal(-1, plain.getInputStream().read()); // a frame that cannot be opened ends the connection
            PublisherBench.Consumer consumer = bench.new Consumer(7, "encrypted");
            byte[] first = consumer.hello(5, 0);
            socket.getOutputStream().write(first);
            long cookie = consumer.isAnswered(Frame.Kind.FLOOR, 5, PublisherBench.readAny(socket));
            byte[] second = consumer.hello(5, cookie);
            replay.getOutputStream().write(first);
            Check.that(consumer.isAnswered(Frame.Kind.FLOOR, 5, PublisherBench.readAny(replay)) != cookie, "another cookie");
            replay.getOutputStream().write(second); // of another connection
            Check.equal(-1, replay.getInputStream().read());
            Check.that(!bench.publisher.send(new byte[1]), "nobody is there");
            socket.getOutputStream().write(second);
            Check.equal(0L, consumer.isAnswered(Frame.Kind.FLOOR, 5, PublisherBench.readAny(socket)));
            Check.that(bench.publisher.awaitConsumer(LONG), "there");
            bench.publisher.send("ball".getBytes());
            Check.equal("ball", new String(consumer.open(PublisherBench.readAny(socket)).payload()));
            new Thread(bench.publisher::close).start();
            Check.equal(Frame.Kind.END, consumer.open(PublisherBench.readAny(socket)).kind());
        }
    }

    static void aHelloOverTcpWaitsForTheKeys() throws Exception {
        try (PublisherBench bench = new PublisherBench(offer(Mode.STREAM).tcp(), " keys=yes sealing=prepared"); Socket socket = bench.connect(7)) {
            Check.that(!bench.publisher.awaitConsumer(Duration.ofMillis(30)), "not yet");
            bench.keys("prepared", PublisherBench.RING);
            Check.that(bench.publisher.awaitConsumer(LONG), "a plain hello is enough while plain frames are sent");
            bench.publisher.send("ball".getBytes());
            Check.equal("ball", new String(PublisherBench.read(socket).payload()));
        }
    }

    static void migrationAndRotationLoseNothing() throws Exception {
        for (boolean isTcp : new boolean[] {false, true}) {
            Offer offer = isTcp ? offer(Mode.STREAM).tcp() : offer(Mode.STREAM);
            try (PublisherBench bench = PublisherBench.sealed(offer, "prepared"); DatagramSocket listener = new DatagramSocket(); Socket socket = isTcp ? bench.connect(0) : new Socket()) {
                PublisherBench.Consumer consumer = bench.new Consumer(7, "prepared");
                if (isTcp) {
                    socket.getOutputStream().write(consumer.hello(5, 0));
                } else {
                    bench.send(listener, consumer.hello(5, 0));
                    bench.send(listener, consumer.hello(5, consumer.isAnswered(Frame.Kind.FLOOR, 5, PublisherBench.frame(listener))));
                    Check.equal(0L, consumer.isAnswered(Frame.Kind.FLOOR, 5, PublisherBench.frame(listener)));
                }
                Check.that(bench.publisher.awaitConsumer(LONG), "there");
                bench.publisher.send("one".getBytes());
                Check.equal("1 one", said(consumer, next(isTcp, socket, listener)));
                bench.keys("mixed", PublisherBench.RING);
                WireFrame floor = next(isTcp, socket, listener); // unasked, so that no message comes before it
                Check.equal(0L, consumer.isAnswered(Frame.Kind.FLOOR, 5, floor));
                Check.that(!(floor instanceof Frame) && floor.sequence() == 1, "sealed");
                bench.publisher.send("two".getBytes());
                Check.equal("2 two", said(consumer, next(isTcp, socket, listener)));
                consumer.keys = ChannelKeys.read("encrypted", PublisherBench.RING + "," + PublisherBench.OTHER);
                bench.keys("mixed", PublisherBench.OTHER + "," + PublisherBench.RING);
                bench.daemon.say("0 msg sealing mode=mixed");
                WireFrame third = null;
                for (int i = 0; third == null || ((SealedFrame) third).key() != 0xbeef; ++i) { // until the line was read
                    bench.publisher.send(("three " + i).getBytes());
                    third = next(isTcp, socket, listener);
                    Check.equal(third.sequence() + " three " + i, said(consumer, third));
                }
                bench.keys("encrypted", PublisherBench.OTHER + "," + PublisherBench.RING);
                if (!isTcp) bench.send(listener, consumer.hello(5, 0));
                long cookie = consumer.isAnswered(Frame.Kind.FLOOR, 5, next(isTcp, socket, listener)); // it said no sealed hello yet, and is asked for one
                Check.that(cookie != 0, "with a cookie");
                bench.publisher.send("four".getBytes()); // and served meanwhile
                Check.that(said(consumer, next(isTcp, socket, listener)).endsWith(" four"), "nothing is lost");
                if (isTcp) {
                    socket.getOutputStream().write(consumer.hello(5, cookie + 1)); // forged or recorded
                    socket.getOutputStream().write(consumer.hello(5, cookie));
                } else {
                    bench.send(listener, consumer.hello(5, cookie));
                }
                Check.equal(0L, consumer.isAnswered(Frame.Kind.FLOOR, 5, next(isTcp, socket, listener)));
                bench.publisher.send("five".getBytes());
                Check.that(said(consumer, next(isTcp, socket, listener)).endsWith(" five"), "nothing is lost");
            }
        }
    }

    private static WireFrame next(boolean isTcp, Socket socket, DatagramSocket listener) throws IOException {
        return isTcp ? PublisherBench.readAny(socket) : PublisherBench.frame(listener);
    }

    private static String said(PublisherBench.Consumer consumer, WireFrame frame) {
        Frame opened = consumer.open(frame);
        return opened.sequence() + " " + new String(opened.payload());
    }

    static void overMulticastASealedHelloIsAnsweredByAFloorAtThePortThatFramesName() throws Exception {
        try (PublisherBench bench = PublisherBench.sealed(offer(Mode.STREAM).address("239.66.77.2"), "encrypted"); DatagramSocket listener = new DatagramSocket();
                MulticastSocket group = new MulticastSocket(new InetSocketAddress("239.66.77.2", bench.publisher.offer().port()))) {
            List<NetworkInterface> all = NetworkInterface.networkInterfaces().toList();
            for (NetworkInterface one : all) {
                if (one.isUp()) group.joinGroup(new InetSocketAddress("239.66.77.2", 0), one);
            }
            PublisherBench.Consumer consumer = bench.new Consumer(7, "encrypted");
            WireFrame heard = null;
            group.setSoTimeout(50);
            DatagramPacket packet = new DatagramPacket(new byte[2000], 2000);
            while (heard == null) {
                bench.publisher.send("ball".getBytes());
                try {
                    group.receive(packet);
                    heard = WireFrame.ofDatagram(ByteBuffer.wrap(packet.getData(), 0, packet.getLength()));
                } catch (SocketTimeoutException notYet) {
                    continue;
                }
            }
            Check.equal("ball", new String(consumer.open(heard).payload()));
            InetSocketAddress hellos = new InetSocketAddress(packet.getAddress(), ((SealedFrame) heard).port());
            for (byte[] octets : List.of(bench.hello(7, 5, 0), consumer.hello(5, 0))) listener.send(new DatagramPacket(octets, octets.length, hellos));
            WireFrame floor = PublisherBench.frame(listener);
            Check.equal(0L, consumer.isAnswered(Frame.Kind.FLOOR, 5, floor));
            Check.that(floor.sequence() >= heard.sequence(), "the last message");
            PublisherBench.isSilent(listener);
        }
    }

    static void aConsumerWithoutALifeIsSentNothingWhereEverythingIsSealed() throws Exception {
        try (PublisherBench bench = PublisherBench.sealed(offer(Mode.PUBSUB), "encrypted"); DatagramSocket plain = new DatagramSocket()) {
            bench.daemon.say(ScriptedDaemon.consumer(1, WORD, plain.getLocalPort(), "no-life"));
            bench.isProblem(WORD + " states no life, so its channel cannot be sealed");
            Check.that(!bench.publisher.send("secret".getBytes()), "nobody is there");
            PublisherBench.isSilent(plain);
        }
    }
}
