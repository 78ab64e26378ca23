package geminga.protocol;

import java.nio.ByteBuffer;
import java.security.GeneralSecurityException;
import java.security.InvalidKeyException;
import java.util.Arrays;
import javax.crypto.Cipher;
import javax.crypto.SecretKey;
import javax.crypto.spec.IvParameterSpec;

/**
 * A frame of the forms 2 and 3, sealed by ChaCha20-Poly1305 of RFC 8439 (src/client/CHANNELS.md, "Sealed channels"). Nothing in it is believed until it was opened.
 *
 * @param form {@link #ENCRYPTED} or {@link #AUTHENTICATED}
 * @param key the id of the key that sealed it
 * @param port where a publisher takes hellos, if it is not the port that it sends from; otherwise 0
 * @param counter counts all frames of this life, from 1 on; unsigned
 * @param text the sealed payload, and a tag of 16 octets
 */
public record SealedFrame(int form, Frame.Kind kind, long life, long sequence, int key, int port, long counter, byte[] text) implements WireFrame {
    /** The octets of the header. */
    public static final int HEADER = 36;
    public static final int TAG = 16;
    public static final int ENCRYPTED = 2;
    public static final int AUTHENTICATED = 3;
    private static final int NONCE = 12;

    /** The sides of a channel, each with a key of its own. */
    public enum Direction {
        /** From a publisher to its consumers. */
        FORWARD,
        /** From a consumer to its publisher. */
        BACK;

        /** The counter after which a life can seal no more. */
        public long last() {
            return this == FORWARD ? -1L : 0xFFFF_FFFFL;
        }
    }

    @Override
    public int size() {
        return text.length;
    }

    /** The header, which is authentic with the payload. */
    private byte[] header() {
        ByteBuffer octets = ByteBuffer.allocate(HEADER);
        Frame.putHeader(octets, form, kind, text.length, life, sequence);
        return octets.putShort((short) key).putShort((short) port).putLong(counter).array();
    }

    /** The octets of the whole frame. */
    public byte[] write() {
        return ByteBuffer.allocate(HEADER + text.length).put(header()).put(text).array();
    }

    private byte[] nonce(Direction direction) {
        ByteBuffer octets = ByteBuffer.allocate(NONCE);
        if (direction == Direction.FORWARD) return octets.putInt(0).putLong(counter).array();
        return octets.putLong(life).putInt((int) counter).array();
    }

    /** Seals a frame. The caller never gives the same life and counter twice with a key. */
    static SealedFrame seal(Cipher cipher, SecretKey key, Direction direction, int form, Frame frame, int id, int port, long counter) {
        int length = frame.payload().length;
        SealedFrame empty = new SealedFrame(form, frame.kind(), frame.life(), frame.sequence(), id, port, counter, new byte[length + TAG]);
        try {
            cipher.init(Cipher.ENCRYPT_MODE, key, new IvParameterSpec(empty.nonce(direction)));
            cipher.updateAAD(empty.header());
            if (form == ENCRYPTED) {
                cipher.doFinal(frame.payload(), 0, length, empty.text, 0);
            } else {
                cipher.updateAAD(frame.payload());
                System.arraycopy(frame.payload(), 0, empty.text, 0, length);
                cipher.doFinal(new byte[0], 0, 0, empty.text, length);
            }
        } catch (GeneralSecurityException fault) {
            throw new IllegalStateException("a frame cannot be sealed", fault);
        }
        return empty;
    }

    /** The frame that was sealed, or null if it was not sealed with this key. An {@link InvalidKeyException} if this cipher opened the same frame last, which it refuses to do twice. */
    Frame open(Cipher cipher, SecretKey key, Direction direction) throws InvalidKeyException {
        boolean isWithin = direction == Direction.FORWARD || counter >>> 32 == 0;
        if (!isWithin || counter == 0) return null;
        try {
            cipher.init(Cipher.DECRYPT_MODE, key, new IvParameterSpec(nonce(direction)));
            cipher.updateAAD(header());
            byte[] payload;
            if (form == ENCRYPTED) {
                payload = cipher.doFinal(text);
            } else {
                payload = Arrays.copyOf(text, text.length - TAG);
                cipher.updateAAD(payload);
                cipher.doFinal(text, payload.length, TAG);
            }
            return new Frame(kind, life, sequence, payload);
        } catch (InvalidKeyException isSameAgain) {
            throw isSameAgain;
        } catch (GeneralSecurityException isForged) {
            return null;
        }
    }
}
