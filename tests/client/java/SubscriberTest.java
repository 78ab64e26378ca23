import geminga.Event;
import geminga.Identity;
import geminga.Message;
import geminga.Mode;
import geminga.Node;
import geminga.Offer;
import geminga.Options;
import geminga.Publisher;
import geminga.Request;
import geminga.Subscriber;
import geminga.protocol.Frame;
import geminga.protocol.Handshake;
import geminga.protocol.Life;
import geminga.protocol.Limits;
import java.io.IOException;
import java.io.OutputStream;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.Inet6Address;
import java.net.InetSocketAddress;
import java.net.NetworkInterface;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Flow;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;

/** Subscribers and plain sockets: what is believed, what is delivered, and how much waits (src/client/CHANNELS.md). */
final class SubscriberTest {
    private static final Duration LONG = Duration.ofSeconds(30);
    private static final String LIFE = "000000000000000a";
    private static final String WORD = "5e6f7a8b/2/1";

    private static Request request() {
        return Request.of(Mode.ONE_TO_ONE, Identity.text("x"));
    }

    private static byte[] message(long life, long sequence, String text) {
        return new Frame(Frame.Kind.MESSAGE, life, sequence, text.getBytes()).write();
    }

    private static void send(DatagramSocket from, int port, byte[] octets) throws IOException {
        from.send(new DatagramPacket(octets, octets.length, new InetSocketAddress("127.0.0.1", port)));
    }

    private static String text(Subscriber subscriber) throws Exception {
        Message message = subscriber.receive(LONG).orElseThrow();
        return message.sequence() + " " + message.missed() + " " + message.text();
    }

    static void overUdpOnlyTheMatchedAddressAndLifeAreBelieved() throws Exception {
        try (SubscriberBench bench = new SubscriberBench(request()); DatagramSocket provider = new DatagramSocket(); DatagramSocket stranger = new DatagramSocket()) {
            int port = bench.subscriber.request().port();
            bench.daemon.say(ScriptedDaemon.provider(1, WORD, provider.getLocalPort(), "udp", LIFE, ""));
            bench.is("ADDED 10 -");
            send(stranger, port, message(10, 1, "another port"));
            send(provider, port, message(11, 1, "another life"));
            send(provider, port, "no frame".getBytes());
            send(provider, port, Frame.end(11, 1).write());
            send(provider, port, message(10, 5, "first"));
            send(provider, port, message(10, 5, "again"));
            send(provider, port, message(10, 8, "second"));
            Check.equal("5 0 first", text(bench.subscriber));
            Check.equal("8 2 second", text(bench.subscriber));
            Check.equal(5L, bench.subscriber.dropped());
            send(provider, port, Frame.end(10, 10).write()); // a hint, since anybody can forge it
            send(provider, port, message(10, 9, "third"));
            Check.equal("9 0 third", text(bench.subscriber));
            bench.daemon.say("1 pub del service=" + WORD + " reason=expired");
            bench.is("REMOVED 10 withdrawn");
            Check.equal(3L, bench.subscriber.missed());
        }
    }

    static void whatAProviderSendsBeforeTheDaemonTellsOfItIsDelivered() throws Exception {
        // If the machine was so busy that more than a second passed, the result means nothing: try again.
        for (boolean isInTime = false; !isInTime;) {
            try (SubscriberBench bench = new SubscriberBench(request()); DatagramSocket provider = new DatagramSocket()) {
                int port = bench.subscriber.request().port();
                isInTime = tellsLate(bench, provider, 10, () -> {
                    for (int i = 1; i <= 2; ++i) send(provider, port, message(10, i, "m" + i));
                    send(provider, port, Frame.hello(10, new Handshake(0, 0, 0)).write());
                }, 3);
                if (!isInTime) continue;
                for (int i = 1; i <= 2; ++i) Check.equal(i + " 0 m" + i, text(bench.subscriber));
                Check.equal(1L, bench.subscriber.dropped());
                // The provider is started again at the same port: another life.
                isInTime = tellsLate(bench, provider, 11, () -> {
                    send(provider, port, message(11, 1, "again"));
                    send(provider, port, Frame.end(11, 3).write());
                }, 3);
                if (!isInTime) continue;
                Check.equal("1 0 again", text(bench.subscriber));
                bench.daemon.say("1 pub del service=5e6f7a8b/2/11 reason=left");
                bench.is("REMOVED 11 withdrawn");
                Check.equal("1 2", bench.subscriber.dropped() + " " + bench.subscriber.missed());
            }
        }
    }

    /** Lets a provider send before the daemon tells of it; whether all that took less than a second. */
    private static boolean tellsLate(SubscriberBench bench, DatagramSocket provider, long life, Check.Action sends, long dropped) throws Exception {
        long begin = System.nanoTime();
        sends.run();
        bench.awaitDropped(dropped);
        bench.daemon.say(ScriptedDaemon.provider(1, "5e6f7a8b/2/" + life, provider.getLocalPort(), "udp", Life.write(life), ""));
        bench.is("ADDED " + life + " -");
        return System.nanoTime() - begin < Limits.EARLY;
    }

    static void whoStatesNoLifeIsHeardAsItSpeaks() throws Exception {
        try (SubscriberBench bench = new SubscriberBench(request()); DatagramSocket plain = new DatagramSocket()) {
            bench.daemon.say(ScriptedDaemon.provider(1, WORD, plain.getLocalPort(), "udp", "", ""));
            bench.is("ADDED 0 -");
            send(plain, bench.subscriber.request().port(), "as it is".getBytes());
            Check.equal("0 0 as it is", text(bench.subscriber));
            bench.daemon.say(ScriptedDaemon.provider(1, "5e6f7a8b/2/2", 9, "tcp", "", ""));
            Check.that(bench.next() instanceof Event.Problem problem && problem.source() == bench.subscriber, "over TCP it is not connected");
        }
    }

    static void whatWasSentBeforeTheEndIsHeardThoughTheWordOfItComesFirst() throws Exception {
        try (SubscriberBench bench = new SubscriberBench(request()); DatagramSocket provider = new DatagramSocket(); Socket tcp = bench.meet()) {
            OutputStream out = tcp.getOutputStream();
            out.write(message(10, 1, "one"));
            Check.equal("1 0 one", text(bench.subscriber));
            bench.daemon.say("1 pub del service=" + WORD + " reason=withdrawn");
            bench.daemon.say(ScriptedDaemon.provider(1, "5e6f7a8b/2/2", provider.getLocalPort(), "udp", "000000000000000b", ""));
            bench.is("ADDED 11 -"); // so the other one's end has been heard of
            out.write(message(10, 2, "two"));
            out.write(message(10, 3, "three"));
            out.write(Frame.end(10, 3).write());
            Check.equal("2 0 two", text(bench.subscriber));
            Check.equal("3 0 three", text(bench.subscriber));
            bench.is("REMOVED 10 withdrawn");
            Check.equal(-1, tcp.getInputStream().read());
        }
    }

    static void aConnectionIsMadeAgainAndTheGapIsSeen() throws Exception {
        try (SubscriberBench bench = new SubscriberBench(request())) {
            Socket first = bench.meet();
            first.getOutputStream().write(message(10, 1, "one"));
            Check.equal("1 0 one", text(bench.subscriber));
            first.close();
            Socket second = bench.accept();
            second.getOutputStream().write(message(10, 4, "four"));
            Check.equal("4 2 four", text(bench.subscriber));
            second.getOutputStream().write("this is no frame, and nothing behind it can be read".getBytes());
            Check.equal(-1, second.getInputStream().read());
            Socket third = bench.accept();
            third.getOutputStream().write(message(11, 5, "another life"));
            third.getOutputStream().write(message(10, 5, "five"));
            Check.equal("5 0 five", text(bench.subscriber));
            Check.equal(2L, bench.subscriber.dropped());
        }
    }

    static void multicastIsHeardInEachFamilyThatTheHostHas() throws Exception {
        // The loopback has no route for multicasts of IPv6.
        boolean hasSix = NetworkInterface.networkInterfaces().flatMap(NetworkInterface::inetAddresses).anyMatch(address -> address instanceof Inet6Address && !address.isLoopbackAddress());
        for (String group : hasSix ? List.of("239.66.77.1", "ff02::6677", "ff05::6677") : List.of("239.66.77.1")) {
            try (SubscriberBench bench = new SubscriberBench(Request.of(Mode.STREAM, Identity.text("x")))) {
                Publisher publisher = bench.node.publish(Offer.of(Mode.STREAM, Identity.text("x")).address(group));
                bench.daemon.takes();
                String event = ScriptedDaemon.provider(1, WORD, publisher.offer().port(), "udp", Life.write(publisher.life()), "");
                bench.daemon.say(event.replace("127.0.0.1", group).replace("mode=oto", "mode=otm/stream"));
                bench.is("ADDED " + publisher.life() + " -");
                Optional<Message> message = Optional.empty();
                for (int i = 0; i < 600 && message.isEmpty(); ++i) {
                    Check.that(publisher.send(group.getBytes()), "whether anybody listens or not");
                    message = bench.subscriber.receive(Duration.ofMillis(50));
                }
                Check.that(message.isPresent(), group + ": " + publisher.leftOut() + " left out, " + bench.subscriber.dropped() + " dropped");
                Check.equal(group, message.get().text());
                publisher.close();
                bench.daemon.say("1 pub del service=" + WORD + " reason=withdrawn");
                bench.is("REMOVED " + publisher.life() + " withdrawn");
            }
        }
    }

    static void aProviderThatMovesIsFollowed() throws Exception {
        try (SubscriberBench bench = new SubscriberBench(request()); Socket first = bench.meet(); DatagramSocket provider = new DatagramSocket()) {
            bench.daemon.say(ScriptedDaemon.provider(1, WORD, provider.getLocalPort(), "udp", LIFE, "").replace("pub add", "pub modify"));
            bench.is("MODIFIED 10 -");
            Check.equal(-1, first.getInputStream().read());
            send(provider, bench.subscriber.request().port(), message(10, 1, "elsewhere"));
            Check.equal("1 0 elsewhere", text(bench.subscriber));
        }
    }

    static void aTakerIsGivenAsManyAsItRequests() throws Exception {
        try (SubscriberBench bench = new SubscriberBench(request()); Socket provider = bench.meet()) {
            Taker taker = new Taker();
            bench.subscriber.subscribe(taker);
            Taker late = new Taker();
            bench.subscriber.subscribe(late);
            Check.equal("error IllegalStateException", late.next());
            Check.fails(IllegalStateException.class, () -> bench.subscriber.receive(LONG));
            for (int i = 1; i <= 5; ++i) provider.getOutputStream().write(message(10, i, "m" + i));
            taker.subscription.request(1);
            Check.equal("m1", taker.next());
            taker.subscription.request(2);
            Check.equal("m2", taker.next());
            Check.equal("m3", taker.next());
            Check.equal(null, taker.told.poll(50, TimeUnit.MILLISECONDS));
            taker.subscription.cancel();
            Check.equal("4 0 m4", text(bench.subscriber)); // what was not requested is still there
            Taker wrong = new Taker();
            bench.subscriber.subscribe(wrong);
            wrong.subscription.request(0);
            Check.equal("error IllegalArgumentException", wrong.next());
            Taker last = new Taker();
            bench.subscriber.subscribe(last);
            last.subscription.request(Long.MAX_VALUE);
            last.subscription.request(Long.MAX_VALUE);
            Check.equal("m5", last.next());
            bench.subscriber.close();
            Check.equal("complete", last.next());
        }
    }

    static void aTakerThatThrowsIsReleasedAndTheNodeGoesOn() throws Exception {
        try (SubscriberBench bench = new SubscriberBench(request()); Socket provider = bench.meet()) {
            Taker taker = new Taker();
            taker.throwing = true;
            bench.subscriber.subscribe(taker);
            taker.subscription.request(5);
            provider.getOutputStream().write(message(10, 1, "one"));
            provider.getOutputStream().write(message(10, 2, "two"));
            Check.that(bench.next() instanceof Event.Problem problem && problem.text().contains("thrown"), "told");
            Check.equal("2 0 two", text(bench.subscriber));
        }
    }

    static void conversionsAreAppliedAlongTheChainOrAtOnce() throws Exception {
        Request steps = request().conversion("a:A", "a:B", payload -> ("b" + new String(payload)).getBytes()).conversion("a:B", "a:C", payload -> ("c" + new String(payload)).getBytes());
        String chain = " convert=a:A>a:B>a:C cost=2";
        try (SubscriberBench bench = new SubscriberBench(steps); DatagramSocket provider = new DatagramSocket()) {
            bench.daemon.say(ScriptedDaemon.provider(1, WORD, provider.getLocalPort(), "udp", LIFE, chain));
            bench.is("ADDED 10 -");
            send(provider, bench.subscriber.request().port(), message(10, 1, "x"));
            Check.equal("1 0 cbx", text(bench.subscriber));
            bench.subscriber.modify(request -> request.conversion("a:A", "a:C", payload -> "whole".getBytes()));
            send(provider, bench.subscriber.request().port(), message(10, 2, "x"));
            Check.equal("2 0 whole", text(bench.subscriber));
            bench.subscriber.modify(request -> request.conversion("a:A", "a:C", payload -> {
                throw new IOException("cannot");
            }));
            for (int i = 3; i <= 4; ++i) send(provider, bench.subscriber.request().port(), message(10, i, "x"));
            Check.that(bench.subscriber.receive(Duration.ofMillis(200)).isEmpty(), "it is dropped");
            Check.that(bench.next() instanceof Event.Problem problem && problem.text().contains("a:A>a:C"), "and told once");
            Check.equal(2L, bench.subscriber.dropped());
            Check.equal(null, bench.told.poll());
        }
    }

    static void whoWouldDoAMissingConversionIsNamed() throws Exception {
        Request request = request().conversion("a:A", "a:B", payload -> payload);
        String chain = " convert=a:A>a:B>a:C cost=2 via=-,udp://10.0.0.7:6000/9c0d1e2f/1/1";
        try (SubscriberBench bench = new SubscriberBench(request); DatagramSocket provider = new DatagramSocket()) {
            bench.daemon.say(ScriptedDaemon.provider(1, WORD, provider.getLocalPort(), "udp", LIFE, chain));
            bench.is("ADDED 10 -");
            send(provider, bench.subscriber.request().port(), message(10, 1, "x"));
            Check.that(bench.subscriber.receive(Duration.ofMillis(200)).isEmpty(), "it is dropped");
            Check.that(bench.next() instanceof Event.Problem problem && problem.text().endsWith(
                    "there is no function for the conversion a:B>a:C, which the service udp://10.0.0.7:6000/9c0d1e2f/1/1 does"), "and told who does it");
        }
    }

    static void whoDoesNotTakeIsNotReadFor() throws Exception {
        try (SubscriberBench bench = new SubscriberBench(request()); Socket provider = bench.meet()) {
            int size = 1024 * 1024;
            int count = 64;
            Thread sender = new Thread(() -> {
                try {
                    for (int i = 1; i <= count; ++i) provider.getOutputStream().write(new Frame(Frame.Kind.MESSAGE, 10, i, new byte[size]).write());
                } catch (IOException isOver) {
                    return;
                }
            });
            sender.start();
            sender.join(500);
            Check.that(sender.isAlive(), "64 MiB do not wait in a subscriber that is not read");
            for (long i = 1; i <= count; ++i) {
                Message message = bench.subscriber.receive(LONG).orElseThrow();
                Check.equal(i + " 0", message.sequence() + " " + message.missed());
            }
            sender.join();
        }
    }

    /** Writes down every call. */
    private static final class Taker implements Flow.Subscriber<Message> {
        final LinkedBlockingQueue<String> told = new LinkedBlockingQueue<>();
        volatile Flow.Subscription subscription;
        volatile boolean throwing;

        String next() throws InterruptedException {
            return told.poll(30, TimeUnit.SECONDS);
        }

        @Override
        public void onSubscribe(Flow.Subscription given) {
            subscription = given;
        }

        @Override
        public void onNext(Message message) {
            if (throwing) throw new IllegalStateException("thrown");
            told.add(message.text());
        }

        @Override
        public void onError(Throwable fault) {
            told.add("error " + fault.getClass().getSimpleName());
        }

        @Override
        public void onComplete() {
            told.add("complete");
        }
    }

    static void aThousandMessagesComeInOrderWithoutAThreadOfTheLibrary() throws Exception {
        try (ScriptedDaemon daemon = new ScriptedDaemon(); Node node = Node.open(Options.named("test").connect(daemon.address()))) {
            List<String> met = new ArrayList<>();
            var said = node.publish(geminga.Offer.of(Mode.STREAM, Identity.text("x")).tcp());
            try (Socket consumer = new Socket("127.0.0.1", said.offer().port())) {
                daemon.greetInBackground();
                consumer.getOutputStream().write(Frame.hello(5, new Handshake(said.life(), 1, 0)).write());
                Check.that(said.awaitConsumer(LONG), "there");
                for (int i = 0; i < 1000; ++i) said.send(Integer.toString(i).getBytes());
                for (int i = 0; i < 1000; ++i) {
                    int length = ByteBuffer.wrap(consumer.getInputStream().readNBytes(Frame.HEADER)).getInt(4);
                    met.add(new String(consumer.getInputStream().readNBytes(length)));
                }
            }
            for (int i = 0; i < 1000; ++i) Check.equal(Integer.toString(i), met.get(i));
        }
    }
}
