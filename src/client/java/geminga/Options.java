package geminga;

import geminga.protocol.Statement;
import java.util.Objects;
import java.util.function.Consumer;

/**
 * How a node calls itself and where its daemon is.
 *
 * @param name what others are told of this program; empty for nothing
 * @param connect {@code ADDRESS:PORT}, {@code [ADDRESS]:PORT}, {@code /PATH} or {@code unix:PATH}; empty for where gemingad usually listens
 * @param listener what is told of the daemon and of problems, on the thread that drives the node; it must not block
 */
public record Options(String name, String connect, Consumer<Event> listener) {
    /**
     * Checks the name.
     *
     * @param name what others are told of this program; empty for nothing
     * @param connect {@code ADDRESS:PORT}, {@code [ADDRESS]:PORT}, {@code /PATH} or {@code unix:PATH}; empty for where gemingad usually listens
     * @param listener what is told of the daemon and of problems
     */
    public Options {
        Objects.requireNonNull(connect);
        Objects.requireNonNull(listener);
        if (!Statement.isWritable(name)) throw new IllegalArgumentException("name: a control character that no line can hold");
    }

    /**
     * The daemon that the environment variable {@code GEMINGA_CONNECT} says, or the usual one.
     *
     * @param name what others are told of this program
     * @return the options
     */
    public static Options named(String name) {
        String connect = System.getenv("GEMINGA_CONNECT");
        return new Options(name, connect == null ? "" : connect, event -> { });
    }

    /**
     * Another daemon.
     *
     * @param address {@code ADDRESS:PORT}, {@code [ADDRESS]:PORT}, {@code /PATH} or {@code unix:PATH}
     * @return the options
     */
    public Options connect(String address) {
        return new Options(name, address, listener);
    }

    /**
     * Who is told of the daemon and of problems.
     *
     * @param told on the thread that drives the node; it must not block
     * @return the options
     */
    public Options listener(Consumer<Event> told) {
        return new Options(name, connect, told);
    }
}
