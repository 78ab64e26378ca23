package geminga.protocol;

/** A consumer's part of the handshake with one publisher: its challenge, the cookie, when the next hello is due, and the floor (src/client/CHANNELS.md, "The handshake"). */
public final class Greeting {
    private static final long FIRST = 20_000_000L;

    private final long challenge;
    private long cookie;
    private long wait = FIRST;
    private boolean isAccepted;
    private boolean hasFloor;
    private boolean isFloorSealed;
    private long floor;

    /** With a challenge that is not 0. */
    public Greeting(long challenge) {
        this.challenge = challenge;
    }

    /** The payload of the next hello to a publisher. */
    public Handshake hello(long publisher) {
        return new Handshake(publisher, challenge, cookie);
    }

    /** The time from a hello to the next one: 20, 40, ... 640 ms, then each second; each second once it is accepted. */
    public long next() {
        if (isAccepted) return Limits.HELLO_INTERVAL;
        long now = wait;
        wait = wait > Limits.HELLO_INTERVAL / 2 ? Limits.HELLO_INTERVAL : wait * 2;
        return now;
    }

    /** Begins anew, at another address or on another connection. The floor stays. */
    public void begin() {
        cookie = 0;
        wait = FIRST;
        isAccepted = false;
    }

    /** Whether an answer gives this challenge back to that life. */
    public boolean isAnswer(Handshake answer, long own) {
        return answer != null && answer.life() == own && answer.challenge() == challenge;
    }

    /** Takes a floor with this challenge. Whether to say hello at once. A sealed floor takes the place of a plain one. */
    public boolean floor(Handshake answer, long sequence, boolean isSealed) {
        if (!hasFloor || isSealed && !isFloorSealed) {
            floor = sequence;
            hasFloor = true;
            isFloorSealed = isSealed;
        }
        if (answer.cookie() == 0) {
            isAccepted = true;
            wait = FIRST;
            return false;
        }
        isAccepted = false;
        boolean isNew = cookie != answer.cookie();
        cookie = answer.cookie();
        return isNew;
    }

    /** There is no place at the publisher. */
    public void refused() {
        isAccepted = false;
        cookie = 0;
        wait = Limits.HELLO_INTERVAL;
    }

    public boolean isAccepted() {
        return isAccepted;
    }

    /** Whether a floor that sealed messages can be compared with has come. */
    public boolean hasFloor(boolean takesPlain) {
        return hasFloor && (isFloorSealed || takesPlain);
    }

    /** Whether a sealed message of that sequence was made after this challenge. Requires a floor. */
    public boolean isFresh(long sequence) {
        return Long.compareUnsigned(sequence, floor) > 0;
    }
}
