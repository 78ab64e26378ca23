package geminga.channels;

import geminga.Event;
import geminga.protocol.Backoff;
import geminga.protocol.Limits;
import geminga.protocol.LineException;
import geminga.protocol.LineReader;
import geminga.protocol.Parameter;
import geminga.protocol.Reply;
import geminga.protocol.Statement;
import geminga.protocol.Told;
import java.io.IOException;
import java.net.SocketAddress;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import java.util.random.RandomGenerator;

/** The link to the daemon, which connects again with back-off until the node is closed. All calls but the constructor are made with the loop's lock. */
public final class DaemonLink implements Stream.Reader {
    /** Stands after the actions that one pong answers. */
    private static final Runnable PONG = () -> {};
    private static final long HELLO_TIMEOUT = TimeUnit.SECONDS.toNanos(5);

    private final Loop loop;
    private final List<SocketAddress> addresses;
    private final String name;
    private final Backoff backoff;
    private final TreeMap<Long, Stated> requests = new TreeMap<>();
    /** The actions that wait for a pong, in the order of the pings. */
    private final ArrayDeque<Runnable> pings = new ArrayDeque<>();
    private LineReader lines = new LineReader();
    private long skipped;
    private Stream stream;
    private Loop.Timer helloTimeout;
    private int attempt;
    private long lastNumber;
    private boolean isUp;
    private boolean isPingDue;
    private boolean isClosed;
    private boolean isGone;

    public DaemonLink(Loop loop, List<SocketAddress> addresses, String name, RandomGenerator chance) {
        this.loop = loop;
        this.addresses = addresses;
        this.name = name;
        backoff = new Backoff(chance);
    }

    /** Begins to connect. */
    public void open() {
        loop.lock.lock();
        try {
            connect();
        } finally {
            loop.lock.unlock();
        }
    }

    long nextNumber() {
        return ++lastNumber;
    }

    /** Whether the daemon has said hello. */
    public boolean isUp() {
        return isUp;
    }

    void add(Stated request) {
        requests.put(request.number, request);
    }

    void forget(Stated request) {
        requests.remove(request.number);
    }

    void say(long number, String command, String subcommand, Map<String, String> parameters) {
        List<Parameter> written = new ArrayList<>();
        parameters.forEach((key, value) -> written.add(new Parameter(key, value)));
        String line = new Statement(number, command, subcommand, written).write() + "\r\n";
        stream.write(ByteBuffer.wrap(line.getBytes(StandardCharsets.UTF_8)));
    }

    /** Runs an action when the daemon has handled everything that was said so far. */
    void whenHandled(Runnable action) {
        pings.add(action);
        if (isPingDue) return;
        isPingDue = true;
        loop.after(0, this::ping);
    }

    /** Sends a ping that is due at once. */
    void pingWhereDue() {
        if (isPingDue) ping();
    }

    private void ping() {
        if (!isPingDue) return;
        isPingDue = false;
        if (!isUp) return;
        say(0, "sys", "ping", Map.of());
        pings.add(PONG);
    }

    private void connect() {
        if (isClosed) return;
        lines = new LineReader();
        skipped = 0;
        SocketAddress address = addresses.get(attempt++ % addresses.size());
        try {
            stream = Stream.connect(loop, address, this);
            helloTimeout = loop.after(HELLO_TIMEOUT, () -> {
                stream.close();
                broke("the daemon does not say hello");
            });
        } catch (IOException fault) {
            stream = null;
            later();
        }
    }

    private void later() {
        boolean isAnotherLeft = attempt % addresses.size() != 0;
        loop.after(isAnotherLeft ? 0 : backoff.next(), this::connect);
    }

    @Override
    public void connected() {
        say(0, "sys", "hello", name.isEmpty() ? Map.of() : Map.of("name", name));
    }

    @Override
    public void read(ByteBuffer octets) {
        for (String line = lines.next(octets); line != null && stream != null; line = lines.next(octets)) {
            try {
                handle(line);
            } catch (LineException fault) {
                loop.problem("a line of the daemon cannot be read: " + fault.getMessage());
            }
        }
        if (lines.skipped() > skipped) loop.problem("a line of the daemon is too long");
        skipped = lines.skipped();
    }

    private void handle(String line) throws LineException {
        Reply reply = Reply.read(line);
        if (reply != null) {
            Stated request = requests.get(reply.id());
            if (request != null) request.error(reply.code(), reply.text());
            if (reply.id() == 0) loop.problem(reply.code() + " " + reply.text());
            return;
        }
        Statement statement = Statement.read(line);
        if (statement.id() == 0 && statement.command().equals("msg")) {
            if (statement.subcommand().equals("hello") && !isUp) hello(statement);
            if (statement.subcommand().equals("pong")) pong();
            return;
        }
        Stated request = requests.get(statement.id());
        Told told = request == null || !isUp ? null : Told.read(statement);
        if (told != null) request.told(told);
    }

    private void hello(Statement statement) {
        isUp = true;
        helloTimeout.cancel();
        backoff.reset();
        attempt = 0;
        String participant = "";
        String host = "";
        for (Parameter parameter : statement.parameters()) {
            if (parameter.key().equals("participant")) participant = parameter.value();
            if (parameter.key().equals("participant_name")) host = parameter.value();
        }
        loop.tell(new Event.Connected(participant, host));
        for (Stated request : List.copyOf(requests.values())) {
            request.daemonBack();
            request.state();
        }
        loop.changed();
    }

    private void pong() {
        for (Runnable action = pings.poll(); action != null && action != PONG; action = pings.poll()) action.run();
        loop.changed();
    }

    @Override
    public void drained() {}

    @Override
    public void finished() {
        stream.close();
        broke("the daemon closed the connection");
    }

    @Override
    public void broke(String reason) {
        helloTimeout.cancel();
        stream = null;
        pings.clear();
        isPingDue = false;
        if (isUp) {
            isUp = false;
            loop.tell(new Event.Disconnected(reason));
            for (Stated request : List.copyOf(requests.values())) request.lost();
        }
        isGone = isClosed;
        if (!isClosed) later();
        loop.changed();
    }

    /** Says goodbye; {@link #isGone} tells when the daemon has heard it. */
    public void close() {
        isClosed = true;
        if (isUp) {
            say(0, "sys", "bye", Map.of());
            loop.after(Limits.ENDING, () -> isGone = true);
        } else {
            if (stream != null) stream.close();
            isGone = true;
        }
    }

    /** Whether the goodbye is complete. */
    public boolean isGone() {
        return isGone;
    }
}
