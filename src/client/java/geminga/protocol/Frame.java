package geminga.protocol;

import java.nio.ByteBuffer;

/** A frame: one datagram, or a piece of a stream (src/client/CHANNELS.md, "Frames"). */
public record Frame(Kind kind, long life, long sequence, byte[] payload) {
    /** The octets of the header. */
    public static final int HEADER = 24;
    private static final short MARK = 0x4743; // "GC"
    private static final byte VERSION = 1;

    /** The kinds by their numbers, from 1 on. */
    public enum Kind {
        MESSAGE,
        HELLO,
        END;

        static Kind of(int number) {
            return number >= 1 && number <= 3 ? values()[number - 1] : null;
        }
    }

    /** A header that was read. */
    record Header(Kind kind, int length, long life, long sequence) {
        /** Reads 24 octets; null if they are no header of a frame with at most {@code limit} octets of payload. */
        static Header read(ByteBuffer octets, int limit) {
            boolean isMarked = octets.getShort() == MARK & octets.get() == VERSION;
            Kind kind = Kind.of(octets.get());
            int length = octets.getInt();
            long life = octets.getLong();
            long sequence = octets.getLong();
            boolean isWhole = isMarked && kind != null && length >= 0 && length <= limit && life != 0;
            return isWhole ? new Header(kind, length, life, sequence) : null;
        }
    }

    /** The frame that a datagram is, or null if it is none. */
    public static Frame ofDatagram(ByteBuffer datagram) {
        if (datagram.remaining() < HEADER) return null;
        Header header = Header.read(datagram, Limits.UDP_MESSAGE);
        if (header == null || header.length() != datagram.remaining()) return null;
        byte[] payload = new byte[header.length()];
        datagram.get(payload);
        return new Frame(header.kind(), header.life(), header.sequence(), payload);
    }

    /** Appends the header of a frame to {@code to}. */
    public static void putHeader(ByteBuffer to, Kind kind, long life, long sequence, int length) {
        to.putShort(MARK).put(VERSION).put((byte) (kind.ordinal() + 1)).putInt(length).putLong(life).putLong(sequence);
    }

    /** The octets of the whole frame. */
    public byte[] write() {
        ByteBuffer octets = ByteBuffer.allocate(HEADER + payload.length);
        putHeader(octets, kind, life, sequence, payload.length);
        return octets.put(payload).array();
    }

    /** A hello over TCP. */
    public static Frame hello(long life) {
        return new Frame(Kind.HELLO, life, 0, new byte[0]);
    }

    /** A hello or an end of a listener over UDP, to the publisher of that life. */
    public static Frame toPublisher(Kind kind, long life, long publisher) {
        return new Frame(kind, life, 0, ByteBuffer.allocate(Long.BYTES).putLong(publisher).array());
    }

    /** The end of a life, after the message of that sequence. */
    public static Frame end(long life, long sequence) {
        return new Frame(Kind.END, life, sequence, new byte[0]);
    }

    /** Whether this hello or end over UDP is for the publisher of that life. */
    public boolean isFor(long publisher) {
        return payload.length == Long.BYTES && ByteBuffer.wrap(payload).getLong() == publisher;
    }
}
