package geminga.channels;

import geminga.Event;
import geminga.protocol.Backoff;
import geminga.protocol.ChannelKeys;
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
import java.util.LinkedHashMap;
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
    /** The line of the log about a daemon that is not there. */
    private Loop.Timer complaint;
    private String reason = "no answer";
    private boolean hasComplained;
    /** Whether the last daemon that said hello has keys; null before the first one. */
    private Boolean hasKeys;
    /** The mode of this host; null where the daemon has not said it. */
    private ChannelKeys.Mode mode;
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
            complainLater();
            connect();
        } finally {
            loop.lock.unlock();
        }
    }

    /** Says once that there is no daemon, when there has been none for a while. */
    private void complainLater() {
        complaint = loop.after(Limits.NO_DAEMON, () -> {
            hasComplained = true;
            loop.log("no daemon at " + Endpoint.text(addresses.get(0)) + " for 1 s (" + reason + "): start gemingad, or say where it is with GEMINGA_CONNECT");
        });
    }

    /** The keys of a new channel: none, or null until the daemon has told them. */
    ChannelKeys keysOfNew() {
        if (mode != null) return mode == ChannelKeys.Mode.PLAIN ? ChannelKeys.NONE : null;
        return Boolean.FALSE.equals(hasKeys) ? ChannelKeys.NONE : null;
    }

    /** Whether services without a life may be connected; null if that is not known yet. */
    Boolean takesPlain() {
        if (mode != null) return mode.takesPlain();
        return Boolean.FALSE.equals(hasKeys) ? Boolean.TRUE : null;
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
        stream.write(line.getBytes(StandardCharsets.UTF_8));
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
            reason = text(fault.getMessage());
            later();
        }
    }

    private void later() {
        boolean isAnotherLeft = attempt % addresses.size() != 0;
        loop.after(isAnotherLeft ? 0 : backoff.next(), this::connect);
    }

    @Override
    public void connected() {
        Map<String, String> said = new LinkedHashMap<>();
        if (!name.isEmpty()) said.put("name", name);
        said.put("keys", "yes");
        say(0, "sys", "hello", said);
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
            if (statement.subcommand().equals("sealing") && isUp) mode(ChannelKeys.mode(value(statement, "mode")));
            return;
        }
        Stated request = requests.get(statement.id());
        if (statement.command().equals("pub") && statement.subcommand().equals("keys")) {
            if (isUp) keys(request, statement);
            return;
        }
        Told told = request == null || !isUp ? null : Told.read(statement);
        if (told != null) request.told(told);
    }

    /** Takes a line with keys, which neither the application nor a log is shown. */
    private void keys(Stated request, Statement line) throws LineException {
        ChannelKeys keys = ChannelKeys.read(line);
        if (request != null) request.keys(ChannelKeys.life(line), keys);
        mode(keys.mode());
    }

    private void mode(ChannelKeys.Mode told) {
        if (told == null || told == mode) return;
        mode = told;
        List.copyOf(requests.values()).forEach(Stated::modeChanged);
    }

    private static String value(Statement statement, String key) {
        return statement.parameters().stream().filter(one -> one.key().equals(key)).map(Parameter::value).findFirst().orElse("");
    }

    private void hello(Statement statement) {
        isUp = true;
        helloTimeout.cancel();
        complaint.cancel();
        if (hasComplained) loop.log("the daemon at " + Endpoint.text(addresses.get((attempt - 1) % addresses.size())) + " answers");
        hasComplained = false;
        backoff.reset();
        boolean isWithKeys = value(statement, "keys").equals("yes");
        hasKeys = isWithKeys;
        mode = ChannelKeys.mode(value(statement, "sealing"));
        attempt = 0;
        loop.tell(new Event.Connected(value(statement, "participant"), value(statement, "participant_name")));
        for (Stated request : List.copyOf(requests.values())) {
            request.daemonKeys(isWithKeys);
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
    public void broke(String why) {
        reason = text(why);
        helloTimeout.cancel();
        stream = null;
        pings.clear();
        isPingDue = false;
        if (isUp) {
            isUp = false;
            loop.tell(new Event.Disconnected(reason));
            complainLater();
            for (Stated request : List.copyOf(requests.values())) request.lost();
        }
        isGone = isClosed;
        if (!isClosed) later();
        loop.changed();
    }

    private static String text(String why) {
        return why == null ? "no reason is known" : why;
    }

    /** Says goodbye; {@link #isGone} tells when the daemon has heard it. */
    public void close() {
        isClosed = true;
        complaint.cancel();
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
