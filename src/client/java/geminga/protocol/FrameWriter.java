package geminga.protocol;

import geminga.protocol.SealedFrame.Direction;

/** Writes the frames of one life, sealed where the mode seals, and counts those that are sealed, so that no nonce is used twice (src/client/CHANNELS.md, "Sealed channels"). */
public final class FrameWriter {
    private final long life;
    private final Direction direction;
    private long counter;

    public FrameWriter(long life, Direction direction) {
        this(life, direction, 0);
    }

    /** One whose last sealed frame had that counter. */
    public FrameWriter(long life, Direction direction, long counter) {
        this.life = life;
        this.direction = direction;
        this.counter = counter;
    }

    /** The octets of a frame; null if the counter is used up, so that this life can send no more. */
    public byte[] write(ChannelKeys keys, Frame.Kind kind, long sequence, byte[] payload, int port) {
        Frame frame = new Frame(kind, life, sequence, payload);
        if (!keys.mode().seals()) return frame.write();
        if (isUsedUp()) return null;
        return keys.seal(frame, direction, port, ++counter).write();
    }

    /** The octets of a frame that names no port. */
    public byte[] write(ChannelKeys keys, Frame.Kind kind, long sequence, byte[] payload) {
        return write(keys, kind, sequence, payload, 0);
    }

    public long life() {
        return life;
    }

    /** Whether no further frame can be sealed. */
    public boolean isUsedUp() {
        return counter == direction.last();
    }
}
