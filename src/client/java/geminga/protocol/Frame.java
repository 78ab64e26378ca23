package geminga.protocol;

import java.nio.ByteBuffer;

/** A frame that can be read: one datagram, or a piece of a stream (src/client/CHANNELS.md, "Frames"). */
public record Frame(Kind kind, long life, long sequence, byte[] payload) implements WireFrame {
    /** The octets of the header. */
    public static final int HEADER = 24;
    static final short MARK = 0x4743; // "GC"
    static final int PLAIN = 1;

    /** The kinds by their numbers, from 1 on. */
    public enum Kind {
        MESSAGE,
        HELLO,
        END,
        FLOOR,
        FULL;

        static Kind of(int number) {
            return number >= 1 && number <= values().length ? values()[number - 1] : null;
        }
    }

    @Override
    public int size() {
        return payload.length;
    }

    /** The plain frame that a datagram is, or null if it is none. */
    public static Frame ofDatagram(ByteBuffer datagram) {
        return WireFrame.ofDatagram(datagram) instanceof Frame frame ? frame : null;
    }

    /** Appends the first 24 octets of a frame of any form to {@code to}. */
    static void putHeader(ByteBuffer to, int form, Kind kind, int length, long life, long sequence) {
        to.putShort(MARK).put((byte) form).put((byte) (kind.ordinal() + 1)).putInt(length).putLong(life).putLong(sequence);
    }

    /** Appends the header of a plain frame to {@code to}. */
    public static void putHeader(ByteBuffer to, Kind kind, long life, long sequence, int length) {
        putHeader(to, PLAIN, kind, length, life, sequence);
    }

    /** The octets of the whole frame. */
    public byte[] write() {
        ByteBuffer octets = ByteBuffer.allocate(HEADER + payload.length);
        putHeader(octets, kind, life, sequence, payload.length);
        return octets.put(payload).array();
    }

    /** A hello of that life. */
    public static Frame hello(long life, Handshake handshake) {
        return new Frame(Kind.HELLO, life, 0, handshake.write());
    }

    /** The end of a life, after the message of that sequence. */
    public static Frame end(long life, long sequence) {
        return new Frame(Kind.END, life, sequence, new byte[0]);
    }
}
