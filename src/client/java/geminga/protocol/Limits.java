package geminga.protocol;

import java.time.Duration;

/** The limits of channels and the times that they keep (src/client/CHANNELS.md). */
public final class Limits {
    public static final int UDP_MESSAGE = 65_000;
    public static final int TCP_MESSAGE = 16 * 1024 * 1024;
    /** Octets that wait for one TCP consumer, or one message. */
    public static final int WAITING_FOR_CONSUMER = 4 * 1024 * 1024;
    public static final int LISTENERS = 64;
    /** Connections of a publisher that have not said whose they are. */
    public static final int UNKNOWN_CONNECTIONS = 16;
    public static final int TCP_CONSUMERS = 256;
    /** Messages that wait in a subscriber until the application takes them. */
    public static final int WAITING_MESSAGES = 1024;
    /** Octets of these, or one message. */
    public static final int WAITING_OCTETS = 16 * 1024 * 1024;
    /** Frames over UDP of one subscriber that are of nobody whom it knows yet. */
    public static final int EARLY_FRAMES = 64;
    /** Octets of payload of these. */
    public static final int EARLY_OCTETS = 256 * 1024;
    /** Lives whose last sequence a subscriber remembers. */
    public static final int REMEMBERED_LIVES = 1024;
    /** Messages that one socket gives before the others are looked at. */
    public static final int TURN = 32;

    public static final long UNKNOWN_CONNECTION = Duration.ofSeconds(5).toNanos();
    public static final long HELLO_INTERVAL = Duration.ofSeconds(1).toNanos();
    public static final long LISTENER_SILENCE = Duration.ofSeconds(3).toNanos();
    /** How long a consumer that reads waits for more of a provider that was withdrawn. */
    public static final long ENDING = Duration.ofSeconds(2).toNanos();
    /** How long a connection that ends waits for one who takes nothing. */
    public static final long CLOSING = Duration.ofSeconds(5).toNanos();
    /** How long an early frame is kept. */
    public static final long EARLY = Duration.ofSeconds(1).toNanos();
    /** How long a channel over UDP goes on without its daemons. */
    public static final long ORPHAN = Duration.ofSeconds(10).toNanos();
    /** After this long with the daemon, channels that no {@code add} has confirmed are orphans. */
    public static final long CONFIRMATION = Duration.ofSeconds(10).toNanos();

    private Limits() {}
}
