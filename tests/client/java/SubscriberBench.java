import geminga.Event;
import geminga.Message;
import geminga.Node;
import geminga.Options;
import geminga.Request;
import geminga.Subscriber;
import geminga.protocol.ChannelKeys;
import geminga.protocol.Frame;
import geminga.protocol.FrameWriter;
import geminga.protocol.Handshake;
import geminga.protocol.Life;
import geminga.protocol.LineException;
import geminga.protocol.SealedFrame.Direction;
import geminga.protocol.WireFrame;
import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.time.Duration;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;

/** A subscriber, its scripted daemon, a provider over TCP, and what is told. */
final class SubscriberBench implements AutoCloseable {
    static final Duration LONG = Duration.ofSeconds(30);
    static final String LIFE = "000000000000000a";
    static final String WORD = "5e6f7a8b/2/1";

    final ScriptedDaemon daemon = new ScriptedDaemon();
    final LinkedBlockingQueue<Event> told = new LinkedBlockingQueue<>();
    final LinkedBlockingQueue<String> log = new LinkedBlockingQueue<>();
    final Node node = Node.open(Options.named("test").connect(daemon.address()).listener(told::add).log(log::add), Node::newThread);
    final Subscriber subscriber;
    final ServerSocket server = new ServerSocket(0, 8, InetAddress.getByName("127.0.0.1"));

    SubscriberBench(Request request) throws Exception {
        this(request, "");
    }

    /** With a daemon whose greeting says more. */
    SubscriberBench(Request request, String greeting) throws Exception {
        daemon.greet(greeting);
        subscriber = node.subscribe(request, told::add);
        daemon.takes();
        Check.that(next() instanceof Event.Connected, "connected");
    }

    /** With a daemon that has keys, and gives those of the provider in this mode. */
    static SubscriberBench sealed(Request request, String mode) throws Exception {
        SubscriberBench bench = new SubscriberBench(request, " keys=yes sealing=" + mode);
        bench.keys(mode, PublisherBench.RING);
        return bench;
    }

    void keys(String mode, String ring) throws IOException {
        daemon.say("1 pub keys life=" + LIFE + " mode=" + mode + (ring.isEmpty() ? "" : " ring=" + ring));
    }

    Event next() throws InterruptedException {
        Event event = told.poll(30, TimeUnit.SECONDS);
        Check.that(event != null, "nothing was told");
        return event;
    }

    void is(String change) throws InterruptedException {
        Event told = next();
        Check.that(told instanceof Event.ProviderEvent, "told: " + told);
        Event.ProviderEvent event = (Event.ProviderEvent) told;
        Check.equal(change, event.change() + " " + event.provider().life() + " " + event.reason());
    }

    void isProblem(String text) throws InterruptedException {
        Check.equal(text, ((Event.Problem) next()).text());
        Check.equal(text, log.poll(30, TimeUnit.SECONDS));
    }

    void awaitDropped(long count) {
        while (subscriber.dropped() < count) Thread.yield();
    }

    /** The subscriber is told of the provider over TCP, connects, and says hello. */
    Socket meet() throws Exception {
        daemon.say(ScriptedDaemon.provider(1, WORD, server.getLocalPort(), "tcp", LIFE, ""));
        is("ADDED 10 -");
        return accept();
    }

    Socket accept() throws IOException {
        Socket socket = server.accept();
        socket.setSoTimeout(30_000);
        Frame hello = PublisherBench.read(socket);
        Handshake said = Handshake.read(hello.payload());
        Check.equal("HELLO " + subscriber.life() + " 10 0", hello.kind() + " " + hello.life() + " " + said.life() + " " + said.cookie());
        Check.that(said.challenge() != 0, "a challenge");
        return socket;
    }

    InetSocketAddress address() {
        return new InetSocketAddress("127.0.0.1", subscriber.request().port());
    }

    void send(DatagramSocket from, byte[] octets) throws IOException {
        from.send(new DatagramPacket(octets, octets.length, address()));
    }

    String text() throws Exception {
        Message message = subscriber.receive(LONG).orElseThrow();
        return message.sequence() + " " + message.missed() + " " + message.text();
    }

    /** A provider of life 10 that seals what it says, and opens what it hears. */
    final class Provider {
        private final FrameWriter writer = new FrameWriter(10, Direction.FORWARD);
        ChannelKeys keys;

        Provider(String mode) throws LineException {
            keys = PublisherBench.keysOf(mode);
        }

        byte[] message(long sequence, String text) {
            return writer.write(keys, Frame.Kind.MESSAGE, sequence, text.getBytes());
        }

        byte[] message(long sequence, String text, int port) {
            return writer.write(keys, Frame.Kind.MESSAGE, sequence, text.getBytes(), port);
        }

        byte[] answer(Frame.Kind kind, long sequence, long challenge, long cookie) {
            return writer.write(keys, kind, sequence, new Handshake(subscriber.life(), challenge, cookie).write());
        }

        byte[] end(long sequence) {
            return writer.write(keys, Frame.Kind.END, sequence, new byte[0]);
        }

        /** The payload of a hello. */
        Handshake hello(WireFrame frame) {
            Frame hello = keys.open(frame, Direction.BACK);
            Check.equal("HELLO " + Life.write(subscriber.life()), hello.kind() + " " + Life.write(hello.life()));
            Handshake said = Handshake.read(hello.payload());
            Check.equal(10L, said.life());
            return said;
        }
    }

    @Override
    public void close() throws Exception {
        daemon.close();
        server.close();
        node.close();
    }
}
