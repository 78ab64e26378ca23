package geminga;

/** Events that a node, a publisher or a subscriber tells its application. None of them is an error that the application must handle. */
public sealed interface Event {
    /**
     * The daemon was reached. All requests are stated to it.
     *
     * @param participant the daemon, in eight hexadecimal digits
     * @param host its name
     */
    record Connected(String participant, String host) implements Event {}

    /**
     * The daemon is gone. Channels go on, and the node connects again.
     *
     * @param reason what ended the connection
     */
    record Disconnected(String reason) implements Event {}

    /**
     * A provider of a subscriber has changed.
     *
     * @param change what has happened to it
     * @param provider all that is known of it
     * @param reason why it is gone, a word of GCNP; {@code -} unless it is {@link Change#REMOVED}
     */
    record ProviderEvent(Change change, Match provider, String reason) implements Event {}

    /**
     * A consumer of a publisher has changed. Over TCP it is added when its connection has come.
     *
     * @param change what has happened to it
     * @param consumer all that is known of it
     * @param reason why it is gone, a word of GCNP; {@code -} unless it is {@link Change#REMOVED}
     */
    record ConsumerEvent(Change change, Match consumer, String reason) implements Event {}

    /**
     * Something that a person should know: a conversion without a function, a request that was taken back.
     *
     * @param source the {@link Publisher} or {@link Subscriber} that it is about; null where it is about the node
     * @param text for humans
     */
    record Problem(AutoCloseable source, String text) implements Event {}
}
