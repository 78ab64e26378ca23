package geminga.protocol;

import geminga.protocol.SealedFrame.Direction;

/** The frames that one publisher writes and reads: its keys, and the sequence of its last message (src/client/CHANNELS.md, "Sealed channels"). */
public final class PublisherFrames {
    private static final byte[] EMPTY = new byte[0];

    private final FrameWriter writer;
    private ChannelKeys keys;
    private long sequence;

    public PublisherFrames(long life) {
        writer = new FrameWriter(life, Direction.FORWARD);
    }

    public long life() {
        return writer.life();
    }

    /** The keys, or null until it is known whether there are any: nothing is sent or answered until then. */
    public ChannelKeys keys() {
        return keys;
    }

    public void keys(ChannelKeys known) {
        keys = known;
    }

    /** Whether frames can be written. */
    public boolean isReady() {
        return keys != null && !(keys.mode().seals() && writer.isUsedUp());
    }

    /** Whether its frames are sealed. */
    public boolean seals() {
        return keys != null && keys.mode().seals();
    }

    /** Whether it takes and gives plain frames. */
    public boolean takesPlain() {
        return keys != null && keys.mode().takesPlain();
    }

    /** The sequence of the last message. */
    public long sequence() {
        return sequence;
    }

    /** The next message, or null if the life can send no more. With the port where hellos are taken, if that is another one. */
    public byte[] message(byte[] payload, int port) {
        return writer.write(keys, Frame.Kind.MESSAGE, ++sequence, payload, port);
    }

    /** The end behind the last message; null where nothing can be written. */
    public byte[] end(int port) {
        return isReady() ? writer.write(keys, Frame.Kind.END, sequence, EMPTY, port) : null;
    }

    /** A floor or a full; null where nothing can be written. */
    public byte[] answer(Frame.Kind kind, Handshake handshake) {
        return isReady() ? writer.write(keys, kind, sequence, handshake.write()) : null;
    }

    /** The frame of a consumer, or null if it cannot be opened or is not to be taken. */
    public Frame open(WireFrame frame) {
        return keys == null ? null : keys.open(frame, Direction.BACK);
    }
}
