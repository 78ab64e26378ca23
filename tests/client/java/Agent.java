import geminga.Change;
import geminga.Event;
import geminga.Identity;
import geminga.Message;
import geminga.Node;
import geminga.Offer;
import geminga.Options;
import geminga.Publisher;
import geminga.Request;
import geminga.Subscriber;
import geminga.protocol.Frame;
import geminga.protocol.Life;
import geminga.protocol.LineException;
import geminga.protocol.Reply;
import geminga.protocol.Statement;
import java.io.BufferedReader;
import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Flow;
import java.util.concurrent.locks.LockSupport;
import java.util.function.UnaryOperator;

/** The agent of the Java library (tests/client/conformance/AGENT.md). */
public final class Agent {
    private static final int SHOWN_OCTETS = 32;
    private static final HexFormat HEX = HexFormat.of();
    private static final PrintStream OUT = new PrintStream(new FileOutputStream(FileDescriptor.out), false, StandardCharsets.UTF_8);

    private final Node node;
    private final Map<Object, Speaker> speakers = new ConcurrentHashMap<>();
    private final Map<String, Publisher> publishers = new ConcurrentHashMap<>();
    private final Map<String, Taker> takers = new ConcurrentHashMap<>();
    private final Map<String, List<UnaryOperator<Request>>> conversions = new ConcurrentHashMap<>();

    private Agent(String name) throws IOException {
        node = Node.open(Options.named(name).listener(this::happened), Node::newThread);
    }

    public static void main(String[] arguments) throws Exception {
        Agent agent = new Agent(arguments.length > 0 ? arguments[0] : "agent");
        try (agent.node; BufferedReader told = new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8))) {
            for (String line = told.readLine(); line != null && !line.equals("quit"); line = told.readLine()) agent.told(line);
        }
        System.exit(0);
    }

    private static synchronized void say(Object... words) {
        StringBuilder line = new StringBuilder();
        for (Object word : words) line.append(line.length() == 0 ? "" : " ").append(word);
        OUT.print(line.append('\n'));
        OUT.flush();
    }

    private synchronized void happened(Event event) {
        if (event instanceof Event.Connected) say("connected");
        if (event instanceof Event.Disconnected) say("disconnected");
        if (event instanceof Event.Problem problem) {
            Speaker speaker = speakers.get(problem.source() == null ? this : problem.source());
            if (speaker == null) {
                say("problem", "-", problem.text());
            } else {
                speaker.say("problem", problem.text());
            }
        }
    }

    private void told(String line) {
        String[] words = line.split(" ", 3);
        String label = words.length > 1 ? words[1] : "";
        String rest = words.length > 2 ? words[2] : "";
        try {
            does(words[0], label, rest);
        } catch (IOException | RuntimeException fault) {
            say("error", label, fault.getMessage());
        }
    }

    private void does(String word, String label, String rest) throws IOException {
        switch (word) {
            case "pub" -> publish(label, rest);
            case "sub" -> subscribe(label, rest);
            case "convert" -> convert(label, rest.split(" "));
            case "modify" -> modify(label, rest);
            case "send" -> publishers.get(label).send(HEX.parseHex(rest));
            case "stream" -> {
                long[] numbers = Arrays.stream(rest.split(" ")).mapToLong(Long::parseLong).toArray();
                Thread thread = new Thread(() -> stream(label, numbers[0], (int) numbers[1], numbers[2]));
                thread.setDaemon(true);
                thread.start();
            }
            case "count" -> count(label);
            case "quiet" -> takers.get(label).isQuiet = true;
            case "deaf" -> takers.get(label).setDeaf(true);
            case "reading" -> takers.get(label).setDeaf(false);
            case "close" -> {
                if (publishers.containsKey(label)) publishers.get(label).close();
                if (takers.containsKey(label)) takers.get(label).subscriber.close();
                say("closed", label);
            }
            case "identity" -> identity(label, rest);
            case "frame" -> frame(label);
            case "line" -> line(rest.isEmpty() ? label : label + " " + rest);
            default -> say("error", word, "is no word of an agent");
        }
    }

    /** Says lines about a label behind its ok. */
    private static final class Speaker {
        private final String label;
        private final List<Runnable> early = new ArrayList<>();
        private boolean isOk;

        Speaker(String label) {
            this.label = label;
        }

        synchronized void say(String word, Object... rest) {
            Runnable saying = () -> {
                List<Object> words = new ArrayList<>(List.of(word, label));
                words.addAll(List.of(rest));
                Agent.say(words.toArray());
            };
            if (isOk) {
                saying.run();
            } else {
                early.add(saying);
            }
        }

        synchronized void ok(Throwable fault) {
            if (fault != null) {
                Throwable cause = fault instanceof CompletionException && fault.getCause() != null ? fault.getCause() : fault;
                Agent.say("error", label, cause.getMessage());
                return;
            }
            Agent.say("ok", label);
            isOk = true;
            early.forEach(Runnable::run);
            early.clear();
        }
    }

    private synchronized void publish(String label, String parameters) throws IOException {
        Speaker speaker = new Speaker(label);
        Publisher publisher = node.publish(Offer.read(parameters), event -> speaker.say("consumer", change(event.change()), event.consumer().lifeText(), event.reason()));
        publishers.put(label, publisher);
        speakers.put(publisher, speaker);
        publisher.taken().whenComplete((nothing, fault) -> speaker.ok(fault));
    }

    private synchronized void subscribe(String label, String parameters) throws IOException {
        Speaker speaker = new Speaker(label);
        Request request = Request.read(parameters);
        for (UnaryOperator<Request> one : conversions.getOrDefault(label, List.of())) request = one.apply(request);
        Subscriber subscriber = node.subscribe(request, event -> speaker.say("provider", change(event.change()), event.provider().lifeText(), event.reason()));
        Taker taker = new Taker(subscriber, speaker);
        takers.put(label, taker);
        speakers.put(subscriber, speaker);
        subscriber.subscribe(taker);
        subscriber.taken().whenComplete((nothing, fault) -> speaker.ok(fault));
    }

    private static String change(Change change) {
        return change.name().toLowerCase(Locale.ROOT);
    }

    private void convert(String label, String[] words) {
        byte[] prefix = HEX.parseHex(words.length > 2 ? words[2] : "");
        UnaryOperator<Request> conversion = request ->
                request.conversion(words[0], words[1], payload -> ByteBuffer.allocate(prefix.length + payload.length).put(prefix).put(payload).array());
        conversions.computeIfAbsent(label, unknown -> new ArrayList<>()).add(conversion);
    }

    private void modify(String label, String parameters) throws IOException {
        try {
            if (publishers.containsKey(label)) {
                publishers.get(label).modify(offer -> offer.with(parameters)).toCompletableFuture().join();
            } else {
                takers.get(label).subscriber.modify(request -> request.with(parameters)).toCompletableFuture().join();
            }
        } catch (CompletionException refused) {
            throw new IOException(refused.getCause().getMessage());
        }
    }

    private void stream(String label, long count, int size, long milliseconds) {
        Publisher publisher = publishers.get(label);
        byte[] payload = new byte[size];
        long begin = System.nanoTime();
        try {
            for (long number = 1; number <= count; ++number) {
                byte[] digits = ByteBuffer.allocate(Long.BYTES).putLong(number).array();
                System.arraycopy(digits, 0, payload, 0, Math.min(size, digits.length));
                if (milliseconds == 0) publisher.awaitRoom(size, Duration.ofDays(1));
                publisher.send(payload);
                long due = begin + number * milliseconds * 1_000_000;
                while (milliseconds > 0 && due - System.nanoTime() > 0) LockSupport.parkNanos(due - System.nanoTime());
            }
            say("streamed", label);
        } catch (IOException | InterruptedException fault) {
            say("error", label, fault.getMessage());
        }
    }

    private void count(String label) {
        Publisher publisher = publishers.get(label);
        if (publisher != null) {
            say("count", label, "sent=" + publisher.sent(), "left_out=" + publisher.leftOut(), "dropped=" + publisher.dropped());
        } else {
            while (!takers.get(label).count(label)) Thread.onSpinWait();
        }
    }

    private static void identity(String kind, String rest) {
        int space = kind.equals("concept") || kind.equals("expression") && !rest.endsWith(")") ? rest.lastIndexOf(' ') : -1;
        String value = space < 0 ? rest : rest.substring(0, space);
        String representation = space < 0 ? "" : "<" + rest.substring(space + 1) + ">";
        Identity identity = switch (kind) {
            case "number" -> Identity.number(Long.parseLong(value));
            case "text" -> Identity.text(value);
            case "concept" -> Identity.concept("<" + value + ">", representation);
            default -> Identity.concept(value, representation);
        };
        say("identity", identity.id32());
    }

    private static void frame(String digits) {
        Frame frame = Frame.ofDatagram(ByteBuffer.wrap(HEX.parseHex(digits)));
        if (frame == null) {
            say("frame refused");
        } else {
            say("frame", frame.kind().name().toLowerCase(Locale.ROOT), Life.write(frame.life()), Long.toUnsignedString(frame.sequence()), HEX.formatHex(frame.payload()));
        }
    }

    private static void line(String text) {
        try {
            Reply reply = Reply.read(text);
            say("line", reply != null ? reply.write() : Statement.read(text).write());
        } catch (LineException fault) {
            say("line refused");
        }
    }

    /** Takes one message after the other, unless the subscriber is deaf. */
    private static final class Taker implements Flow.Subscriber<Message> {
        private final Subscriber subscriber;
        private final Speaker speaker;
        private volatile boolean isQuiet;
        private Flow.Subscription subscription;
        private long taken;
        private boolean isDeaf;
        private boolean isAsking;

        Taker(Subscriber subscriber, Speaker speaker) {
            this.subscriber = subscriber;
            this.speaker = speaker;
        }

        @Override
        public void onSubscribe(Flow.Subscription given) {
            subscription = given;
            ask();
        }

        synchronized void setDeaf(boolean deaf) {
            isDeaf = deaf;
            if (!deaf && !isAsking) ask();
        }

        private synchronized void ask() {
            isAsking = !isDeaf;
            if (isAsking) subscription.request(1);
        }

        /** Says the counts, unless a message is between the library and its line. */
        synchronized boolean count(String label) {
            long missed = subscriber.missed();
            if (subscriber.received() != taken) return false;
            Agent.say("count", label, "received=" + taken, "missed=" + missed, "dropped=" + subscriber.dropped());
            return true;
        }

        @Override
        public synchronized void onNext(Message message) {
            ++taken;
            if (!isQuiet) {
                byte[] payload = message.payload();
                String shown = HEX.formatHex(payload, 0, Math.min(payload.length, SHOWN_OCTETS));
                speaker.say("message", Life.write(message.life()), Long.toUnsignedString(message.sequence()), message.missed(), payload.length, shown);
            }
            ask();
        }

        @Override
        public void onError(Throwable fault) {}

        @Override
        public void onComplete() {}
    }
}
