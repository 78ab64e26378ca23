package geminga.protocol;

import java.time.Duration;

/** Limits of channels, and the times that they keep (src/client/CHANNELS.md). */
public final class Limits {
    public static final int UDP_MESSAGE = 65_000;
    public static final int TCP_MESSAGE = 16 * 1024 * 1024;
    /** Octets that may wait for one TCP consumer; one message may always wait. */
    public static final int WAITING_FOR_CONSUMER = 4 * 1024 * 1024;
    public static final int LISTENERS = 64;
    /** TCP connections of one publisher that have not said hello. */
    public static final int UNKNOWN_CONNECTIONS = 16;
    public static final int TCP_CONSUMERS = 256;
    /** Messages of one subscriber that wait to be taken. */
    public static final int WAITING_MESSAGES = 1024;
    /** Octets of their payloads; one message may always wait. */
    public static final int WAITING_OCTETS = 16 * 1024 * 1024;
    /** Early frames of one subscriber. */
    public static final int EARLY_FRAMES = 64;
    /** Octets of their payloads. */
    public static final int EARLY_OCTETS = 256 * 1024;
    /** Lives of which a subscriber remembers the last sequence. */
    public static final int REMEMBERED_LIVES = 1024;
    /** Messages of one socket before the others have their turn. */
    public static final int TURN = 32;

    public static final long UNKNOWN_CONNECTION = Duration.ofSeconds(5).toNanos();
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
