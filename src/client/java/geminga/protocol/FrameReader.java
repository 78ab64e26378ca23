package geminga.protocol;

import java.nio.ByteBuffer;
import java.util.Arrays;

/** Frames put together from the octets of a stream. Memory grows with the octets that arrive, not with the size that a header claims. */
public final class FrameReader {
    private static final int FIRST = 64 * 1024;

    private final int limit;
    private final byte[] head = new byte[Frame.HEADER];
    private int headed;
    private Frame.Header header;
    private byte[] payload;
    private int filled;
    private boolean isBroken;

    /** A reader of frames with at most {@code limit} octets of payload. */
    public FrameReader(int limit) {
        this.limit = limit;
    }

    /** The next whole frame, or null if more octets are needed. Takes its octets from {@code octets}. */
    public Frame next(ByteBuffer octets) {
        if (isBroken) return null;
        if (header == null && !readHeader(octets)) return null;
        if (!readPayload(octets)) return null;
        Frame frame = new Frame(header.kind(), header.life(), header.sequence(), payload);
        header = null;
        payload = null;
        headed = 0;
        return frame;
    }

    /** Whether something was no frame, so that nothing behind it can be read. */
    public boolean isBroken() {
        return isBroken;
    }

    private boolean readHeader(ByteBuffer octets) {
        int taken = Math.min(octets.remaining(), Frame.HEADER - headed);
        octets.get(head, headed, taken);
        headed += taken;
        if (headed < Frame.HEADER) return false;
        header = Frame.Header.read(ByteBuffer.wrap(head), limit);
        isBroken = header == null;
        if (isBroken) return false;
        payload = new byte[Math.min(header.length(), FIRST)];
        filled = 0;
        return true;
    }

    private boolean readPayload(ByteBuffer octets) {
        while (filled < header.length() && octets.hasRemaining()) {
            if (filled == payload.length) payload = Arrays.copyOf(payload, (int) Math.min(header.length(), payload.length * 2L));
            int taken = Math.min(octets.remaining(), payload.length - filled);
            octets.get(payload, filled, taken);
            filled += taken;
        }
        return filled == header.length();
    }
}
