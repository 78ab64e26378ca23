package geminga;

import geminga.protocol.Statement;
import java.util.Objects;
import java.util.function.Consumer;

/**
 * The name of a node and the endpoint of its daemon.
 *
 * @param name the name that others see; empty for none
 * @param connect {@code ADDRESS:PORT}, {@code [ADDRESS]:PORT}, {@code /PATH} or {@code unix:PATH}; empty for the usual endpoint of gemingad
 * @param listener told of the daemon and of problems, on the thread that serves the node; it must not block
 */
public record Options(String name, String connect, Consumer<Event> listener) {
    /**
     * Checks the name.
     *
     * @param name the name that others see; empty for none
     * @param connect {@code ADDRESS:PORT}, {@code [ADDRESS]:PORT}, {@code /PATH} or {@code unix:PATH}; empty for the usual endpoint of gemingad
     * @param listener told of the daemon and of problems
     */
    public Options {
        Objects.requireNonNull(connect);
        Objects.requireNonNull(listener);
        if (!Statement.isWritable(name)) throw new IllegalArgumentException("name: a control character that no line can hold");
    }

    /**
     * Options for the daemon of the environment variable {@code GEMINGA_CONNECT}, or the usual one.
     *
     * @param name the name that others see
     * @return the options
     */
    public static Options named(String name) {
        String connect = System.getenv("GEMINGA_CONNECT");
        return new Options(name, connect == null ? "" : connect, event -> { });
    }

    /**
     * Options for another daemon.
     *
     * @param address {@code ADDRESS:PORT}, {@code [ADDRESS]:PORT}, {@code /PATH} or {@code unix:PATH}
     * @return the options
     */
    public Options connect(String address) {
        return new Options(name, address, listener);
    }

    /**
     * Options with another listener.
     *
     * @param told is told of the daemon and of problems, on the thread that serves the node; it must not block
     * @return the options
     */
    public Options listener(Consumer<Event> told) {
        return new Options(name, connect, told);
    }
}
