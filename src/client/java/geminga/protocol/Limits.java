package geminga.protocol;

import java.time.Duration;

/** Limits of channels, and the times that they keep (src/client/CHANNELS.md). */
public final class Limits {
    public static final int UDP_MESSAGE = 65_000;
    public static final int TCP_MESSAGE = 16 * 1024 * 1024;
    /** Octets that may wait for one TCP consumer; one message may always wait. */
    public static final int WAITING_FOR_CONSUMER = 4 * 1024 * 1024;
    /** Octets that may wait for all TCP consumers of one publisher, each frame counted once. */
    public static final int WAITING_FOR_ALL = 64 * 1024 * 1024;
    /** Frames that may wait for one TCP consumer: what keeps a tiny frame costs more than the frame. */
    public static final int WAITING_FRAMES = 16_384;
    /** Frames that may wait for all TCP consumers of one publisher, counted for each consumer. */
    public static final int WAITING_FRAMES_FOR_ALL = 262_144;
    /** Listeners of one stream over UDP. */
    public static final int LISTENERS = 1024;
    /** TCP connections of one publisher that are not yet consumers. */
    public static final int UNKNOWN_CONNECTIONS = 64;
    /** TCP consumers of one publisher. */
    public static final int TCP_CONSUMERS = 256;
    /** Providers over TCP of one subscriber. */
    public static final int TCP_PROVIDERS = 256;
    /** Floors and fulls of one publisher that answer datagrams: at once, and in a second. */
    public static final int ANSWERS = 512;
    /** The largest step of the sequence of a life over UDP without a key. */
    public static final long SEQUENCE_STEP = 65_536;
    /** Runs of delivered sequences that are remembered of a life. */
    public static final int DELIVERED_RANGES = 256;
    /** Messages of one subscriber that wait to be taken. */
    public static final int WAITING_MESSAGES = 1024;
    /** Octets of their payloads; one message may always wait. */
    public static final int WAITING_OCTETS = 16 * 1024 * 1024;
    /** Early frames of one subscriber. */
    public static final int EARLY_FRAMES = 64;
    /** Octets of their payloads. */
    public static final int EARLY_OCTETS = 256 * 1024;
    /** Lives of which a subscriber remembers the last sequence, and the keys. */
    public static final int REMEMBERED_LIVES = 1024;
    /** Messages of one socket before the others have their turn. */
    public static final int TURN = 32;

    /** The time after which stragglers are believed. */
    public static final long MUTED = Duration.ofSeconds(2).toNanos();
    /** The time for which an end over UDP without a key is remembered. */
    public static final long END_HINT = Duration.ofSeconds(10).toNanos();
    /** The time that a connection that is no consumer yet has its place. */
    public static final long UNKNOWN_CONNECTION = Duration.ofSeconds(5).toNanos();
    /** The time that a provider over TCP keeps a place without a connection, if another one waits. */
    public static final long UNCONNECTED = Duration.ofSeconds(5).toNanos();
    /** The time without a daemon after which the log says so. */
    public static final long NO_DAEMON = Duration.ofSeconds(1).toNanos();
    /** The time after which a consumer is asked for a sealed hello again. */
    public static final long ASK_AGAIN = Duration.ofMillis(500).toNanos();
    public static final long HELLO_INTERVAL = Duration.ofSeconds(1).toNanos();
    public static final long LISTENER_SILENCE = Duration.ofSeconds(3).toNanos();
    /** The time that a subscriber waits for more of a withdrawn provider. */
    public static final long ENDING = Duration.ofSeconds(2).toNanos();
    /** The time that a publisher waits at its end for a consumer that takes nothing. */
    public static final long CLOSING = Duration.ofSeconds(5).toNanos();
    /** The time that an early frame is kept. */
    public static final long EARLY = Duration.ofSeconds(1).toNanos();
    /** The time that a channel over UDP goes on after the daemons have lost sight of its other end. */
    public static final long ORPHAN = Duration.ofSeconds(10).toNanos();
    /** The time that a daemon that is back has to confirm a channel. */
    public static final long CONFIRMATION = Duration.ofSeconds(10).toNanos();

    private Limits() {}
}
