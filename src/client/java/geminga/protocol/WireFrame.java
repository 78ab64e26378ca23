package geminga.protocol;

import java.nio.ByteBuffer;

/** A frame as it came: plain, or sealed and not opened yet (src/client/CHANNELS.md, "Frames"). */
public sealed interface WireFrame permits Frame, SealedFrame {
    /** Its kind. Of a sealed frame nothing is proved until it was opened. */
    Frame.Kind kind();

    /** The life that it claims to come from. */
    long life();

    /** Its sequence. */
    long sequence();

    /** The octets behind its header. */
    int size();

    /** The frame that a datagram is, or null if it is none. */
    static WireFrame ofDatagram(ByteBuffer datagram) {
        if (datagram.remaining() < Frame.HEADER) return null;
        Header header = Header.read(datagram, Limits.UDP_MESSAGE);
        if (header == null || header.rest() + header.length() != datagram.remaining()) return null;
        return header.frame(datagram);
    }

    /** The first 24 octets of a header, which all forms share. */
    record Header(int form, Frame.Kind kind, int length, long life, long sequence) {
        /** Reads 24 octets; null if they begin no frame with at most {@code limit} octets of payload. */
        static Header read(ByteBuffer octets, int limit) {
            boolean isMarked = octets.getShort() == Frame.MARK;
            int form = octets.get();
            Frame.Kind kind = Frame.Kind.of(octets.get());
            int length = octets.getInt();
            long life = octets.getLong();
            long sequence = octets.getLong();
            boolean isSealed = form == SealedFrame.ENCRYPTED || form == SealedFrame.AUTHENTICATED;
            if (!isMarked || kind == null || life == 0 || !isSealed && form != Frame.PLAIN) return null;
            int tag = isSealed ? SealedFrame.TAG : 0;
            return length >= tag && length <= limit + tag ? new Header(form, kind, length, life, sequence) : null;
        }

        /** The octets of the header that follow the first 24. */
        int rest() {
            return form == Frame.PLAIN ? 0 : SealedFrame.HEADER - Frame.HEADER;
        }

        /** The frame, whose remaining header and payload come next. */
        WireFrame frame(ByteBuffer octets) {
            byte[] payload = new byte[length];
            if (form == Frame.PLAIN) {
                octets.get(payload);
                return new Frame(kind, life, sequence, payload);
            }
            int key = Short.toUnsignedInt(octets.getShort());
            int port = Short.toUnsignedInt(octets.getShort());
            long counter = octets.getLong();
            octets.get(payload);
            return new SealedFrame(form, kind, life, sequence, key, port, counter, payload);
        }
    }
}
