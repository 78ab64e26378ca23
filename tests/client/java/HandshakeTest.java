import geminga.Event;
import geminga.Identity;
import geminga.Mode;
import geminga.Offer;
import geminga.protocol.Frame;
import geminga.protocol.Handshake;
import geminga.protocol.Life;
import geminga.protocol.Limits;
import java.io.IOException;
import java.io.OutputStream;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** A publisher without keys and plain sockets: the handshake, and places that are shared (src/client/CHANNELS.md, "The handshake", "Places"). */
final class HandshakeTest {
    private static final Duration LONG = Duration.ofSeconds(30);

    private HandshakeTest() {}

    private static Offer offer(Mode mode) {
        return Offer.of(mode, Identity.text("x"));
    }

    private static Frame floor(PublisherBench bench, DatagramSocket from, long life, long cookie) throws IOException {
        bench.send(from, bench.hello(life, 5, cookie));
        Frame floor = (Frame) PublisherBench.frame(from);
        Handshake said = Handshake.read(floor.payload());
        Check.equal("FLOOR " + life + " 5", floor.kind() + " " + said.life() + " " + said.challenge());
        return floor;
    }

    private static long cookie(Frame floor) {
        return Handshake.read(floor.payload()).cookie();
    }

    static void aStreamOverUdpIsSentToWhoGivesTheCookieBack() throws Exception {
        try (PublisherBench bench = new PublisherBench(offer(Mode.STREAM)); DatagramSocket listener = new DatagramSocket(); DatagramSocket other = new DatagramSocket()) {
            byte[] short8 = new Frame(Frame.Kind.HELLO, 7, 0, ByteBuffer.allocate(8).putLong(bench.publisher.life()).array()).write();
            for (byte[] wrong : List.of(Frame.hello(7, new Handshake(99, 5, 0)).write(), short8, "no frame".getBytes(), Frame.end(7, 0).write())) bench.send(listener, wrong);
            bench.awaitDropped(4);
            Frame first = floor(bench, listener, 7, 0);
            Check.that(first.write().length <= bench.hello(7, 5, 0).length, "no answer is longer than its hello");
            long cookie = cookie(first);
            Check.that(cookie != 0 && !bench.publisher.awaitConsumer(Duration.ofMillis(1)), "not accepted yet");
            Check.that(cookie(floor(bench, other, 7, cookie)) != 0, "the cookie of another address");
            Check.equal(0L, cookie(floor(bench, listener, 7, cookie)));
            Check.that(bench.publisher.awaitConsumer(LONG), "accepted");
            bench.publisher.send("hello".getBytes());
            Check.equal("hello", new String(((Frame) PublisherBench.frame(listener)).payload()));
            Frame renewed = floor(bench, listener, 7, 0); // renewed, whatever its cookie is
            Check.equal("0 1", cookie(renewed) + " " + renewed.sequence());
            PublisherBench.isSilent(other);
            bench.send(listener, new Frame(Frame.Kind.END, 7, 0, new Handshake(bench.publisher.life(), 5, 0).write()).write());
            while (bench.publisher.awaitConsumer(Duration.ofMillis(1))) Thread.onSpinWait();
            Check.that(!bench.publisher.send(new byte[1]), "nobody listens");
            Check.equal(4L, bench.publisher.dropped());
        }
    }

    static void elevenHundredListenersOfOneHostLockNobodyOut() throws Exception {
        try (PublisherBench bench = new PublisherBench(offer(Mode.STREAM)); DatagramSocket honest = new DatagramSocket(0, InetAddress.getByName("127.0.0.2"))) {
            List<DatagramSocket> flood = new ArrayList<>();
            InetAddress host = InetAddress.getByName("127.0.0.3");
            int refused = 0;
            for (int i = 0; i < Limits.LISTENERS + 76; ++i) {
                DatagramSocket one = new DatagramSocket(0, host);
                flood.add(one);
                refused += accept(bench, one, 100 + i) ? 0 : 1;
                for (int known = 0; i % 64 == 0 && known < i; ++known) bench.send(flood.get(known), bench.hello(100 + known, 5, 0)); // so that none is forgotten
            }
            Check.that(refused >= 1, "more than there are places");
            bench.isProblem("all 1024 places for listeners are taken");
            Check.equal("1 pub modify channel.full=1024", bench.daemon.heard());
            Check.that(accept(bench, honest, 7), "another host has a place");
            bench.publisher.send("hello".getBytes());
            Frame frame = (Frame) PublisherBench.frame(honest);
            Check.equal("hello", new String(frame.payload()));
            for (DatagramSocket one : flood) one.close();
        }
    }

    /** Asks for a place until there is an answer, since the rate of answers is limited; whether it has one. */
    private static boolean accept(PublisherBench bench, DatagramSocket socket, long life) throws IOException {
        long cookie = 0;
        socket.setSoTimeout(50);
        byte[] octets = new byte[2000];
        while (true) {
            bench.send(socket, bench.hello(life, 5, cookie));
            DatagramPacket packet = new DatagramPacket(octets, octets.length);
            try {
                socket.receive(packet);
            } catch (SocketTimeoutException isLimited) {
                continue;
            }
            Frame answer = Frame.ofDatagram(ByteBuffer.wrap(octets, 0, packet.getLength()));
            if (answer.kind() == Frame.Kind.FULL) return false;
            if (answer.kind() == Frame.Kind.MESSAGE) continue;
            cookie = cookie(answer);
            if (cookie == 0) return true;
        }
    }

    static void helloesAreAnsweredWithALimit() throws Exception {
        try (PublisherBench bench = new PublisherBench(offer(Mode.STREAM)); DatagramSocket flood = new DatagramSocket()) {
            flood.setReceiveBufferSize(4 * 1024 * 1024);
            long begin = System.nanoTime();
            for (int i = 0; i < 4 * Limits.ANSWERS; ++i) bench.send(flood, bench.hello(7, 5, 0));
            bench.send(flood, "no frame".getBytes());
            bench.awaitDropped(1); // so all hellos have been read
            double seconds = (System.nanoTime() - begin) / 1e9;
            int answers = 0;
            flood.setSoTimeout(100);
            try {
                while (true) {
                    flood.receive(new DatagramPacket(new byte[100], 100));
                    ++answers;
                }
            } catch (SocketTimeoutException allHaveCome) {
                Check.that(answers > 0 && answers <= Limits.ANSWERS * (1 + seconds) + 1, answers + " answers in " + seconds + " s");
            }
        }
    }

    static void overTcpAHelloWithoutThePublishersLifeIsClosedAtOnce() throws Exception {
        try (PublisherBench bench = new PublisherBench(offer(Mode.STREAM).tcp())) {
            byte[] short8 = new Frame(Frame.Kind.HELLO, 7, 0, new byte[8]).write();
            byte[] none = new Frame(Frame.Kind.HELLO, 7, 0, new byte[0]).write();
            int dropped = 0;
            for (byte[] wrong : List.of(Frame.hello(7, new Handshake(99, 5, 0)).write(), short8, none, new Frame(Frame.Kind.FLOOR, 7, 0, new byte[24]).write())) {
                try (Socket socket = bench.connect(0)) {
                    socket.getOutputStream().write(wrong);
                    Check.equal(-1, socket.getInputStream().read());
                }
                Check.equal((long) ++dropped, bench.publisher.dropped());
            }
            Check.that(!bench.publisher.send(new byte[1]), "nobody is there");
        }
    }

    static void connectionsThatReadNothingCostABoundedMemoryAndTheOthersAreServed() throws Exception {
        try (PublisherBench bench = new PublisherBench(offer(Mode.STREAM).tcp()); Socket honest = bench.connect(7)) {
            Check.that(bench.publisher.awaitConsumer(LONG), "there");
            Thread reader = new Thread(() -> {
                try {
                    honest.getInputStream().transferTo(OutputStream.nullOutputStream());
                } catch (IOException isOver) {
                    return;
                }
            });
            reader.setDaemon(true);
            reader.start();
            List<Socket> deaf = new ArrayList<>();
            byte[] message = new byte[1024 * 1024];
            Set<String> problems = new HashSet<>();
            // Each of them begins to wait behind other messages, so that nothing that waits is shared.
            for (int i = 0; i < 40; ++i) {
                deaf.add(bench.connect(100 + i));
                for (int j = 0; j < 10; ++j) {
                    bench.publisher.awaitRoom(0, Duration.ofMillis(2));
                    bench.publisher.send(message);
                }
            }
            boolean hasClosed = false;
            for (Event event = bench.told.poll(); event != null; event = bench.told.poll()) {
                String text = ((Event.Problem) event).text();
                boolean isLeftOut = text.endsWith("is slow: messages to it are left out until it has taken some");
                boolean isOfReader = text.startsWith("the consumer " + Life.write(7) + " "); // which may be slow twice
                if (isLeftOut) Check.that(problems.add(text) || isOfReader, "told once: " + text);
                hasClosed |= text.contains("is too slow and was closed");
                Check.that(!text.startsWith("the consumer " + Life.write(7) + " is too slow"), "the one that reads stays");
            }
            Check.that(!problems.isEmpty(), "what is left out is told");
            Check.that(hasClosed, "more than 64 MiB would have waited");
            Check.that(bench.publisher.awaitConsumer(LONG) && reader.isAlive(), "the one that reads is still there");
            for (Socket socket : deaf) socket.close();
        }
    }
}
