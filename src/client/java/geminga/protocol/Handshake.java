package geminga.protocol;

import java.nio.ByteBuffer;

/**
 * The payload of a hello, a floor, a full, and the end of a listener (src/client/CHANNELS.md, "Frames").
 *
 * @param life the life of the publisher in what a consumer says, of the consumer in what a publisher answers
 * @param challenge drawn by the consumer, and given back
 * @param cookie drawn by the publisher, and given back; 0 for none
 */
public record Handshake(long life, long challenge, long cookie) {
    /** The octets of it. */
    public static final int OCTETS = 24;

    /** Reads a payload; null if it has another size. */
    public static Handshake read(byte[] payload) {
        if (payload.length != OCTETS) return null;
        ByteBuffer octets = ByteBuffer.wrap(payload);
        return new Handshake(octets.getLong(), octets.getLong(), octets.getLong());
    }

    /** The payload. */
    public byte[] write() {
        return ByteBuffer.allocate(OCTETS).putLong(life).putLong(challenge).putLong(cookie).array();
    }
}
