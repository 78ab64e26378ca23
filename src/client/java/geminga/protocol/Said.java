package geminga.protocol;

/** The last hello of a consumer that was accepted: its life, its challenge, and what is needed to tell a recorded hello from a new one. */
public final class Said {
    private long life;
    private long challenge;
    private long counter;
    private boolean isSealed;

    public long life() {
        return life;
    }

    public long challenge() {
        return challenge;
    }

    /** Whether it has said something sealed, so that nothing plain is taken from it. */
    public boolean isSealed() {
        return isSealed;
    }

    /** Takes a hello, or an end, which was opened. Whether it is new: the counter of a life rises, and after a sealed frame no plain one is taken. */
    public boolean take(WireFrame frame, long challenge) {
        boolean isSame = frame.life() == life;
        if (frame instanceof SealedFrame sealed) {
            if (isSame && isSealed && Long.compareUnsigned(sealed.counter(), counter) <= 0) return false;
            counter = sealed.counter();
            isSealed = true;
        } else {
            if (isSame && isSealed) return false;
            isSealed = false;
        }
        life = frame.life();
        this.challenge = challenge;
        return true;
    }
}
