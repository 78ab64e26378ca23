import geminga.Identity;
import geminga.Mode;
import geminga.Request;
import geminga.protocol.ChannelKeys;
import geminga.protocol.Frame;
import geminga.protocol.Handshake;
import geminga.protocol.Limits;
import geminga.protocol.WireFrame;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.Inet4Address;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.MulticastSocket;
import java.net.NetworkInterface;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketException;
import java.net.SocketTimeoutException;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;

/** A subscriber and plain sockets: what it says and what it believes, with and without keys, and what a stranger cannot do (src/client/CHANNELS.md). */
final class SealedTest {
    private static final Duration LONG = Duration.ofSeconds(30);
    private static final String LIFE = SubscriberBench.LIFE;
    private static final String WORD = SubscriberBench.WORD;

    private SealedTest() {}

    private static Request request(Mode mode) {
        return Request.of(mode, Identity.text("x"));
    }

    /** The next hello of the subscriber that is said with this cookie. */
    private static Handshake hello(SubscriberBench.Provider provider, DatagramSocket socket, long cookie) throws Exception {
        while (true) {
            Handshake said = provider.hello(PublisherBench.frame(socket));
            if (said.cookie() == cookie) return said;
        }
    }

    private static void meet(SubscriberBench bench, DatagramSocket provider) throws Exception {
        bench.daemon.say(ScriptedDaemon.provider(1, WORD, provider.getLocalPort(), "udp", LIFE, ""));
        bench.is("ADDED 10 -");
    }

    static void overUdpNothingIsDeliveredBeforeAFreshFloor() throws Exception {
        for (String mode : List.of("encrypted", "authenticated")) {
            try (SubscriberBench bench = SubscriberBench.sealed(request(Mode.ONE_TO_ONE), mode); DatagramSocket socket = new DatagramSocket()) {
                SubscriberBench.Provider provider = bench.new Provider(mode);
                meet(bench, socket);
                long challenge = hello(provider, socket, 0).challenge();
                byte[] recorded = provider.message(3, "recorded");
                bench.send(socket, recorded);
                bench.send(socket, provider.message(5, "sent before the floor came"));
                bench.send(socket, provider.answer(Frame.Kind.FLOOR, 2, challenge + 1, 0)); // recorded: another challenge
                bench.send(socket, provider.answer(Frame.Kind.FLOOR, 4, challenge, 9));
                Check.equal(challenge, hello(provider, socket, 9).challenge());
                Check.equal("5 0 sent before the floor came", bench.text());
                bench.send(socket, provider.answer(Frame.Kind.FLOOR, 5, challenge, 0));
                bench.send(socket, new Frame(Frame.Kind.MESSAGE, 10, 7, "plain".getBytes()).write());
                bench.send(socket, new Frame(Frame.Kind.MESSAGE, 10, -1, "forged".getBytes()).write());
                bench.send(socket, Frame.end(10, 8).write());
                byte[] bent = provider.message(6, "bent");
                bent[bent.length - 1] ^= 1;
                bench.send(socket, bent);
                bench.send(socket, recorded);
                byte[] six = provider.message(6, "six");
                bench.send(socket, six);
                bench.send(socket, six); // twice
                bench.send(socket, provider.message(900_000, "any step"));
                Check.equal("6 0 six", bench.text());
                Check.equal("900000 899993 any step", bench.text());
                bench.send(socket, provider.end(900_002)); // is believed at once
                bench.is("REMOVED 10 withdrawn");
                Check.equal(899_995L, bench.subscriber.missed());
            }
        }
    }

    static void withoutAKeyAForgedSequenceMutesNoChannelForGoodAndAForgedEndEndsNone() throws Exception {
        try (SubscriberBench bench = new SubscriberBench(request(Mode.ONE_TO_ONE)); DatagramSocket socket = new DatagramSocket()) {
            meet(bench, socket);
            bench.send(socket, new Frame(Frame.Kind.MESSAGE, 10, 1, "one".getBytes()).write());
            bench.send(socket, new Frame(Frame.Kind.MESSAGE, 10, -1, "forged".getBytes()).write());
            bench.send(socket, Frame.end(10, -1).write());
            bench.send(socket, new Frame(Frame.Kind.MESSAGE, 10, 2, "two".getBytes()).write());
            Check.equal("1 0 one", bench.text());
            Check.equal("2 0 two", bench.text());
            Check.equal("0 1", bench.subscriber.missed() + " " + bench.subscriber.dropped());
            Check.equal(null, bench.told.poll());
        }
    }

    static void aStreamIsAskedUntilItAcceptsAndTheCookieIsGivenBackAtOnce() throws Exception {
        try (SubscriberBench bench = new SubscriberBench(request(Mode.STREAM)); DatagramSocket socket = new DatagramSocket()) {
            SubscriberBench.Provider provider = bench.new Provider("plain");
            meet(bench, socket);
            long challenge = hello(provider, socket, 0).challenge();
            bench.send(socket, provider.answer(Frame.Kind.FLOOR, 4, challenge, 9));
            hello(provider, socket, 9);
            bench.send(socket, provider.answer(Frame.Kind.FLOOR, 4, challenge, 0));
            bench.send(socket, provider.message(4, "without a key a floor is no floor"));
            Check.equal("4 0 without a key a floor is no floor", bench.text());
            bench.send(socket, provider.answer(Frame.Kind.FULL, 4, challenge + 1, 0)); // forged
            bench.send(socket, provider.answer(Frame.Kind.FULL, 4, challenge, 0));
            bench.send(socket, provider.answer(Frame.Kind.FULL, 4, challenge, 0));
            bench.isProblem("the provider 127.0.0.1:" + socket.getLocalPort() + " has no place for another consumer");
            hello(provider, socket, 0); // it goes on asking
            Check.equal(null, bench.told.poll()); // told once
            bench.subscriber.close();
            WireFrame last = PublisherBench.frame(socket);
            while (last.kind() == Frame.Kind.HELLO) last = PublisherBench.frame(socket);
            Check.equal(Frame.Kind.END, last.kind());
        }
    }

    static void overTcpASealedChannelBeginsWithTwoHellos() throws Exception {
        try (SubscriberBench bench = SubscriberBench.sealed(request(Mode.ONE_TO_ONE), "encrypted")) {
            SubscriberBench.Provider provider = bench.new Provider("encrypted");
            bench.daemon.say(ScriptedDaemon.provider(1, WORD, bench.server.getLocalPort(), "tcp", LIFE, ""));
            bench.is("ADDED 10 -");
            Socket first = bench.server.accept();
            long challenge = provider.hello(PublisherBench.readAny(first)).challenge();
            first.getOutputStream().write(provider.answer(Frame.Kind.FLOOR, 4, challenge, 9));
            Check.equal(9L, provider.hello(PublisherBench.readAny(first)).cookie());
            first.getOutputStream().write(provider.answer(Frame.Kind.FLOOR, 4, challenge, 0));
            first.getOutputStream().write(provider.message(4, "not after the floor"));
            first.getOutputStream().write(provider.message(5, "five"));
            Check.equal("5 0 five", bench.text());
            first.getOutputStream().write(new Frame(Frame.Kind.MESSAGE, 10, 6, "plain".getBytes()).write()); // ends the connection
            Check.equal(-1, first.getInputStream().read());
            Socket second = bench.server.accept();
            Check.equal(0L, provider.hello(PublisherBench.readAny(second)).cookie());
            second.getOutputStream().write(provider.answer(Frame.Kind.FULL, 4, challenge, 0));
            second.close();
            bench.isProblem("the provider 127.0.0.1:" + bench.server.getLocalPort() + " has no place for another consumer");
            Socket third = bench.server.accept();
            provider.hello(PublisherBench.readAny(third));
            third.getOutputStream().write(provider.answer(Frame.Kind.FLOOR, 5, challenge, 0));
            third.getOutputStream().write(provider.message(8, "eight"));
            Check.equal("8 2 eight", bench.text());
            third.getOutputStream().write(provider.end(8));
            bench.is("REMOVED 10 withdrawn");
        }
    }

    static void noChannelIsOpenedBeforeItsKeysHaveCome() throws Exception {
        try (SubscriberBench bench = new SubscriberBench(request(Mode.ONE_TO_ONE), " keys=yes sealing=encrypted"); DatagramSocket socket = new DatagramSocket()) {
            SubscriberBench.Provider provider = bench.new Provider("encrypted");
            meet(bench, socket);
            bench.send(socket, new Frame(Frame.Kind.MESSAGE, 10, 1, "plain".getBytes()).write());
            bench.awaitDropped(1);
            bench.keys("encrypted", PublisherBench.RING);
            long challenge = hello(provider, socket, 0).challenge();
            bench.send(socket, provider.answer(Frame.Kind.FLOOR, 1, challenge, 0));
            bench.send(socket, provider.message(2, "two"));
            Check.equal("2 0 two", bench.text());
        }
    }

    static void keysAreToldOnceThoughAProviderGoesAndComesBack() throws Exception {
        try (SubscriberBench bench = SubscriberBench.sealed(request(Mode.ONE_TO_ONE), "encrypted"); DatagramSocket socket = new DatagramSocket()) {
            SubscriberBench.Provider provider = bench.new Provider("encrypted");
            meet(bench, socket);
            long first = hello(provider, socket, 0).challenge();
            bench.daemon.say("1 pub del service=" + WORD + " reason=outranked");
            bench.is("REMOVED 10 outranked");
            meet(bench, socket);
            WireFrame said = PublisherBench.frame(socket);
            while (said.kind() != Frame.Kind.HELLO || provider.hello(said).challenge() == first) said = PublisherBench.frame(socket);
            Check.that(provider.hello(said).challenge() != first, "another channel, another challenge");
        }
    }

    static void aPlainTeamIsMigratedAndTheKeyRotatedWithoutALoss() throws Exception {
        try (SubscriberBench bench = new SubscriberBench(request(Mode.ONE_TO_ONE)); DatagramSocket socket = new DatagramSocket()) {
            SubscriberBench.Provider provider = bench.new Provider("plain");
            meet(bench, socket);
            bench.send(socket, provider.message(1, "plain"));
            Check.equal("1 0 plain", bench.text());
            bench.daemon.say("0 msg sealing mode=prepared");
            bench.keys("prepared", PublisherBench.RING);
            provider.keys = PublisherBench.keysOf("prepared");
            long challenge = hello(provider, socket, 0).challenge();
            bench.send(socket, provider.answer(Frame.Kind.FLOOR, 1, challenge, 9));
            hello(provider, socket, 9);
            bench.send(socket, provider.answer(Frame.Kind.FLOOR, 1, challenge, 0));
            bench.send(socket, provider.message(2, "still plain"));
            Check.equal("2 0 still plain", bench.text());
            provider.keys = PublisherBench.keysOf("mixed");
            bench.send(socket, provider.answer(Frame.Kind.FLOOR, 2, challenge, 0));
            bench.send(socket, provider.message(3, "sealed"));
            Check.equal("3 0 sealed", bench.text());
            bench.send(socket, new Frame(Frame.Kind.MESSAGE, 10, 4, "after a sealed one no plain one".getBytes()).write());
            bench.keys("encrypted", PublisherBench.RING + "," + PublisherBench.OTHER);
            provider.keys = ChannelKeys.read("encrypted", PublisherBench.OTHER);
            bench.daemon.say(ScriptedDaemon.provider(1, WORD, socket.getLocalPort(), "udp", LIFE, " rate=1").replace("pub add", "pub modify"));
            bench.is("MODIFIED 10 -"); // so the keys have been read
            bench.send(socket, provider.message(4, "with the other key"));
            Check.equal("4 0 with the other key", bench.text());
            Check.equal("1 0", bench.subscriber.dropped() + " " + bench.subscriber.missed());
        }
    }

    static void overMulticastARecordingIsNotHeard() throws Exception {
        try (SubscriberBench bench = SubscriberBench.sealed(request(Mode.STREAM), "encrypted"); MulticastSocket socket = new MulticastSocket(0); DatagramSocket hellos = new DatagramSocket()) {
            SubscriberBench.Provider provider = bench.new Provider("encrypted");
            InetAddress group = InetAddress.getByName("239.66.77.3");
            String event = ScriptedDaemon.provider(1, WORD, socket.getLocalPort(), "udp", LIFE, "").replace("127.0.0.1", "239.66.77.3");
            bench.daemon.say(event);
            bench.is("ADDED 10 -");
            NetworkInterface via = NetworkInterface.networkInterfaces().filter(one -> isUsed(one)).findFirst().orElse(NetworkInterface.getByName("lo"));
            socket.setNetworkInterface(via);
            byte[] recorded = provider.message(3, "recorded", hellos.getLocalPort());
            hellos.setSoTimeout(50);
            DatagramPacket hello = new DatagramPacket(new byte[2000], 2000);
            while (hello.getPort() <= 0) { // until the group is joined
                socket.send(new DatagramPacket(recorded, recorded.length, group, socket.getLocalPort()));
                try {
                    hellos.receive(hello);
                } catch (SocketTimeoutException notYet) {
                    continue;
                }
            }
            long challenge = provider.hello(WireFrame.ofDatagram(ByteBuffer.wrap(hello.getData(), 0, hello.getLength()))).challenge();
            byte[] floor = provider.answer(Frame.Kind.FLOOR, 4, challenge, 0);
            hellos.send(new DatagramPacket(floor, floor.length, new InetSocketAddress(hello.getAddress(), bench.subscriber.request().port())));
            while (bench.subscriber.receive(Duration.ofMillis(20)).isEmpty()) { // until the floor has come
                byte[] fresh = provider.message(5, "fresh", hellos.getLocalPort());
                socket.send(new DatagramPacket(recorded, recorded.length, group, socket.getLocalPort()));
                socket.send(new DatagramPacket(fresh, fresh.length, group, socket.getLocalPort()));
            }
            Check.equal(1L, bench.subscriber.received());
        }
    }

    private static boolean isUsed(NetworkInterface one) {
        try {
            return one.isUp() && !one.isLoopback() && one.supportsMulticast() && one.inetAddresses().anyMatch(address -> address instanceof Inet4Address);
        } catch (SocketException isGone) {
            return false;
        }
    }

    static void aServiceWithoutALifeIsNotConnectedWhereEverythingIsSealed() throws Exception {
        try (SubscriberBench bench = new SubscriberBench(request(Mode.PUBSUB), " keys=yes sealing=encrypted"); DatagramSocket plain = new DatagramSocket()) {
            bench.daemon.say(ScriptedDaemon.provider(1, WORD, plain.getLocalPort(), "udp", "", ""));
            bench.isProblem(WORD + " states no life, so its channel cannot be sealed");
            bench.is("ADDED 0 -");
            bench.send(plain, "as it is".getBytes());
            bench.awaitDropped(1);
            bench.daemon.say("0 msg sealing mode=mixed");
            while (bench.subscriber.received() == 0) {
                bench.send(plain, "as it is".getBytes());
                bench.subscriber.receive(Duration.ofMillis(20));
            }
        }
    }

    static void twoHundredAndFiftySixProvidersHaveAPlaceAndAnHonestOneIsStillConnected() throws Exception {
        try (SubscriberBench bench = new SubscriberBench(request(Mode.PUBSUB)); ServerSocket honest = new ServerSocket(0, 8, InetAddress.getByName("127.0.0.2"));
                ServerSocket forged = new ServerSocket(0, 512, InetAddress.getByName("127.0.0.3"))) {
            List<Socket> taken = new ArrayList<>();
            for (int i = 1; i <= Limits.TCP_PROVIDERS; ++i) {
                bench.daemon.say(event(i, forged.getLocalPort(), "127.0.0.3"));
                Check.that(bench.next() instanceof geminga.Event.ProviderEvent, "added");
                taken.add(forged.accept());
            }
            Check.equal(null, bench.told.poll());
            bench.daemon.say(event(Limits.TCP_PROVIDERS + 1, forged.getLocalPort(), "127.0.0.3"));
            bench.isProblem("all 256 places for providers over TCP are taken");
            Check.that(bench.next() instanceof geminga.Event.ProviderEvent, "added, though without a place");
            bench.daemon.say(event(1000, honest.getLocalPort(), "127.0.0.2"));
            Check.that(bench.next() instanceof geminga.Event.ProviderEvent, "added");
            honest.setSoTimeout(30_000);
            try (Socket socket = honest.accept()) {
                Check.equal(Frame.Kind.HELLO, PublisherBench.read(socket).kind());
                socket.getOutputStream().write(new Frame(Frame.Kind.MESSAGE, 1000, 1, "honest".getBytes()).write());
                Check.equal("1 0 honest", bench.text());
                Socket loser = taken.get(taken.size() - 1); // the newest of the address that has most
                loser.setSoTimeout(30_000);
                PublisherBench.read(loser);
                Check.equal(-1, loser.getInputStream().read());
            }
            for (Socket socket : taken) socket.close();
        }
    }

    private static String event(long life, int port, String address) {
        return ScriptedDaemon.provider(1, "5e6f7a8b/2/" + life, port, "tcp", geminga.protocol.Life.write(life), "").replace("127.0.0.1", address).replace("mode=oto", "mode=otm/pubsub");
    }

    static void aPlaceThatIsNotConnectedGoesToAProviderThatWaits() throws Exception {
        try (SubscriberBench bench = new SubscriberBench(request(Mode.PUBSUB)); ServerSocket late = new ServerSocket(0, 8, InetAddress.getByName("127.0.0.1"));
                ServerSocket closed = new ServerSocket(0, 8, InetAddress.getByName("127.0.0.1"))) {
            closed.close();
            for (int i = 1; i <= Limits.TCP_PROVIDERS; ++i) bench.daemon.say(event(i, closed.getLocalPort(), "127.0.0.1"));
            bench.daemon.say(event(1000, late.getLocalPort(), "127.0.0.1")); // of the same address, so it waits
            late.setSoTimeout(30_000);
            try (Socket socket = late.accept()) {
                Check.equal(Frame.Kind.HELLO, PublisherBench.read(socket).kind());
            }
        }
    }

    static void keysAreNeverTold() throws Exception {
        try (SubscriberBench bench = SubscriberBench.sealed(request(Mode.ONE_TO_ONE), "encrypted"); DatagramSocket socket = new DatagramSocket()) {
            bench.daemon.say("1 pub keys life=" + LIFE + " mode=encrypted ring=" + PublisherBench.RING + "x");
            bench.isProblem("a line of the daemon cannot be read: the keys of a channel cannot be read");
            bench.daemon.say("1 pub keys life=" + LIFE + " mode=encrypted ring=\"" + PublisherBench.RING);
            bench.next();
            meet(bench, socket);
            for (Object one : List.of(bench.subscriber, bench.subscriber.request(), bench.log, bench.told)) Check.that(!one.toString().contains("618408bc"), "shown: " + one);
        }
    }
}
