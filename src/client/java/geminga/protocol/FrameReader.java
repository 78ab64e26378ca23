package geminga.protocol;

import java.nio.ByteBuffer;
import java.util.Arrays;

/** Frames put together from the octets of a stream. Memory grows with the octets that arrive, not with the size that a header claims. */
public final class FrameReader {
    private static final int FIRST = 64 * 1024;

    private final int limit;
    private final byte[] head = new byte[Frame.HEADER];
    private int headed;
    private WireFrame.Header header;
    /** The octets behind the first 24. */
    private byte[] rest;
    private int filled;
    private boolean isBroken;

    /** A reader of frames with at most {@code limit} octets of payload. */
    public FrameReader(int limit) {
        this.limit = limit;
    }

    /** The next whole frame, or null if more octets are needed. Takes its octets from {@code octets}. */
    public WireFrame next(ByteBuffer octets) {
        if (isBroken) return null;
        if (header == null && !readHeader(octets)) return null;
        if (!readRest(octets)) return null;
        WireFrame frame = header.rest() == 0 && rest.length == header.length()
                ? new Frame(header.kind(), header.life(), header.sequence(), rest) : header.frame(ByteBuffer.wrap(rest));
        header = null;
        rest = null;
        headed = 0;
        return frame;
    }

    /** Whether something was no frame, so that nothing behind it can be read. */
    public boolean isBroken() {
        return isBroken;
    }

    private int length() {
        return header.rest() + header.length();
    }

    private boolean readHeader(ByteBuffer octets) {
        int taken = Math.min(octets.remaining(), Frame.HEADER - headed);
        octets.get(head, headed, taken);
        headed += taken;
        if (headed < Frame.HEADER) return false;
        header = WireFrame.Header.read(ByteBuffer.wrap(head), limit);
        isBroken = header == null;
        if (isBroken) return false;
        rest = new byte[Math.min(length(), FIRST)];
        filled = 0;
        return true;
    }

    private boolean readRest(ByteBuffer octets) {
        while (filled < length() && octets.hasRemaining()) {
            if (filled == rest.length) rest = Arrays.copyOf(rest, (int) Math.min(length(), rest.length * 2L));
            int taken = Math.min(octets.remaining(), rest.length - filled);
            octets.get(rest, filled, taken);
            filled += taken;
        }
        return filled == length();
    }
}
