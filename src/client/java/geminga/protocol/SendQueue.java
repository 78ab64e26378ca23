package geminga.protocol;

import java.nio.ByteBuffer;
import java.util.ArrayDeque;

/** The frames that wait for one consumer over TCP. A frame that waits for many consumers is kept and counted once (src/client/CHANNELS.md, "Frames"). */
public final class SendQueue {
    /** The octets that wait for all consumers of one publisher. */
    public static final class Pool {
        private long octets;
        private int entries;

        public long octets() {
            return octets;
        }

        /** Whether more waits than may. */
        public boolean isOver() {
            return octets > Limits.WAITING_FOR_ALL || entries > Limits.WAITING_FRAMES_FOR_ALL;
        }
    }

    /** Octets that are written to several connections, and never changed. */
    public static final class Shared {
        private final byte[] octets;
        private int holders;

        public Shared(byte[] octets) {
            this.octets = octets;
        }

        /** The octets to be written, from the first on. */
        public ByteBuffer octets() {
            return ByteBuffer.wrap(octets);
        }

        public int size() {
            return octets.length;
        }
    }

    private record Waiting(Shared frame, ByteBuffer rest) {}

    private final Pool pool;
    private final ArrayDeque<Waiting> waiting = new ArrayDeque<>();
    private long octets;

    public SendQueue(Pool pool) {
        this.pool = pool;
    }

    public boolean isEmpty() {
        return waiting.isEmpty();
    }

    /** The octets that wait. */
    public long octets() {
        return octets;
    }

    /** Whether a frame of this size may wait for this consumer; one may always. */
    public boolean hasRoom(int size) {
        return octets == 0 || octets + size <= Limits.WAITING_FOR_CONSUMER && waiting.size() < Limits.WAITING_FRAMES;
    }

    /** Keeps the rest of a frame, which was not written. */
    public void put(Shared frame, ByteBuffer rest) {
        if (!rest.hasRemaining()) return;
        if (frame.holders++ == 0) pool.octets += frame.size();
        ++pool.entries;
        waiting.add(new Waiting(frame, rest));
        octets += rest.remaining();
    }

    /** The octets to be written next. Requires that something waits. */
    public ByteBuffer first() {
        return waiting.peek().rest();
    }

    /** So many octets of the first frame were written. */
    public void written(long count) {
        octets -= count;
        if (!waiting.isEmpty() && !waiting.peek().rest().hasRemaining()) release(waiting.poll());
    }

    /** Nothing will be written any more. */
    public void clear() {
        while (!waiting.isEmpty()) release(waiting.poll());
        octets = 0;
    }

    private void release(Waiting one) {
        --pool.entries;
        if (--one.frame().holders == 0) pool.octets -= one.frame().size();
    }
}
