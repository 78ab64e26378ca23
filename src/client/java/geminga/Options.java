package geminga;

import geminga.protocol.Statement;
import java.nio.charset.StandardCharsets;
import java.util.Objects;
import java.util.function.Consumer;

/**
 * The name of a node and the endpoint of its daemon.
 *
 * @param name the name that others see; empty for none
 * @param connect {@code ADDRESS:PORT}, {@code [ADDRESS]:PORT}, {@code /PATH} or {@code unix:PATH}; empty for the usual endpoint of gemingad
 * @param listener told of the daemon and of problems, on the thread that serves the node; it must not block
 * @param log takes one line for each thing that is waited for or was refused, on the thread that serves the node; it must not block
 */
public record Options(String name, String connect, Consumer<Event> listener, Consumer<String> log) {
    private static final int MAX_NAME = 64;

    /**
     * Checks the name.
     *
     * @param name the name that others see; empty for none
     * @param connect {@code ADDRESS:PORT}, {@code [ADDRESS]:PORT}, {@code /PATH} or {@code unix:PATH}; empty for the usual endpoint of gemingad
     * @param listener told of the daemon and of problems
     * @param log takes one line for each thing that is waited for or was refused
     */
    public Options {
        Objects.requireNonNull(name, "name: 1 to 64 octets, not null");
        Objects.requireNonNull(connect, "connect: the endpoint of a daemon, not null");
        Objects.requireNonNull(listener, "listener: a function, not null");
        Objects.requireNonNull(log, "log: a function, not null");
        int octets = name.getBytes(StandardCharsets.UTF_8).length;
        if (octets > MAX_NAME) throw new IllegalArgumentException("name: 1 to " + MAX_NAME + " octets, not " + octets);
        if (!Statement.isWritable(name)) throw new IllegalArgumentException("name: a control character that no line can hold");
    }

    /**
     * Options for the daemon of the environment variable {@code GEMINGA_CONNECT}, or the usual one.
     *
     * @param name the name that others see, 1 to 64 octets
     * @return the options
     */
    public static Options named(String name) {
        if (name.isEmpty()) throw new IllegalArgumentException("name: 1 to " + MAX_NAME + " octets, not 0; Options.unnamed() is for a node without a name");
        return of(name);
    }

    /**
     * Options of a node without a name, for the daemon of the environment variable {@code GEMINGA_CONNECT}, or the usual one.
     *
     * @return the options
     */
    public static Options unnamed() {
        return of("");
    }

    private static Options of(String name) {
        String connect = System.getenv("GEMINGA_CONNECT");
        return new Options(name, connect == null ? "" : connect, event -> { }, line -> System.err.println("geminga: " + line));
    }

    /**
     * Options for another daemon.
     *
     * @param address {@code ADDRESS:PORT}, {@code [ADDRESS]:PORT}, {@code /PATH} or {@code unix:PATH}
     * @return the options
     */
    public Options connect(String address) {
        return new Options(name, address, listener, log);
    }

    /**
     * Options with another listener.
     *
     * @param told is told of the daemon and of problems, on the thread that serves the node; it must not block
     * @return the options
     */
    public Options listener(Consumer<Event> told) {
        return new Options(name, connect, told, log);
    }

    /**
     * Options with another log. Unless told, lines go to standard error, with {@code geminga: } before them.
     *
     * @param lines takes one line for each thing that is waited for or was refused, on the thread that serves the node; it must not block
     * @return the options
     */
    public Options log(Consumer<String> lines) {
        return new Options(name, connect, listener, lines);
    }
}
