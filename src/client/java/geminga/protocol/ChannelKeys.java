package geminga.protocol;

import java.security.GeneralSecurityException;
import java.security.InvalidKeyException;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import javax.crypto.Cipher;
import javax.crypto.SecretKey;
import javax.crypto.spec.SecretKeySpec;

/**
 * The keys of the channel of one publisher, as the daemon gives them, and the mode of this host (src/client/CHANNELS.md, "Sealed channels"). The first key seals, all of them
 * open. Not for several threads at once. Its text shows no key.
 */
public final class ChannelKeys {
    /** The largest number of keys. */
    public static final int MOST = 8;
    /** A channel without keys. */
    public static final ChannelKeys NONE = new ChannelKeys(Mode.PLAIN, List.of());
    private static final int OCTETS = 32;

    /** The forms that a host sends, and those that it takes. */
    public enum Mode {
        PLAIN,
        PREPARED,
        MIXED,
        AUTHENTICATED,
        ENCRYPTED;

        /** Whether it sends sealed frames. */
        public boolean seals() {
            return this != PLAIN && this != PREPARED;
        }

        /** Whether it takes plain frames. */
        public boolean takesPlain() {
            return this == PLAIN || this == PREPARED || this == MIXED;
        }
    }

    private record Key(int id, SecretKey forward, SecretKey back) {
        SecretKey of(SealedFrame.Direction direction) {
            return direction == SealedFrame.Direction.FORWARD ? forward : back;
        }
    }

    private final Mode mode;
    private final List<Key> ring;
    private Cipher sealer;
    private Cipher opener;

    private ChannelKeys(Mode mode, List<Key> ring) {
        this.mode = mode;
        this.ring = ring;
    }

    /** Reads the keys of a line {@code pub keys}. The text of an error shows none of it. */
    public static ChannelKeys read(Statement line) throws LineException {
        Map<String, String> said = new LinkedHashMap<>();
        for (Parameter parameter : line.parameters()) said.put(parameter.key(), parameter.value());
        return read(said.getOrDefault("mode", ""), said.getOrDefault("ring", ""));
    }

    /** Reads a mode and a ring {@code ID:FORWARD:BACK,...}. */
    public static ChannelKeys read(String mode, String ring) throws LineException {
        Mode read = mode(mode);
        if (read == Mode.PLAIN) return NONE;
        if (read == null) throw fault();
        List<Key> keys = new ArrayList<>();
        for (String word : ring.split(",", -1)) keys.add(key(word));
        if (keys.size() > MOST) throw fault();
        return new ChannelKeys(read, List.copyOf(keys));
    }

    /** The mode of that name, or null. */
    public static Mode mode(String name) {
        for (Mode one : Mode.values()) {
            if (one.name().toLowerCase(Locale.ROOT).equals(name)) return one;
        }
        return null;
    }

    private static Key key(String word) throws LineException {
        String[] parts = word.split(":", -1);
        boolean isWhole = parts.length == 3 && parts[0].length() == 4 && parts[1].length() == 2 * OCTETS && parts[2].length() == 2 * OCTETS;
        if (!isWhole) throw fault();
        try {
            return new Key(HexFormat.fromHexDigits(parts[0]), secret(parts[1]), secret(parts[2]));
        } catch (IllegalArgumentException isNoNumber) {
            throw fault(); // whose text would show the key
        }
    }

    private static SecretKey secret(String digits) {
        return new SecretKeySpec(HexFormat.of().parseHex(digits), "ChaCha20");
    }

    private static LineException fault() {
        return new LineException("the keys of a channel cannot be read");
    }

    /** The life that a line {@code pub keys} is about; 0 if it is not readable. */
    public static long life(Statement line) {
        for (Parameter parameter : line.parameters()) {
            if (parameter.key().equals("life")) return Life.read(parameter.value());
        }
        return 0;
    }

    public Mode mode() {
        return mode;
    }

    /** Whether sealed frames can be opened. */
    public boolean hasRing() {
        return !ring.isEmpty();
    }

    /** Seals a frame in the form of the mode. Requires a mode that seals. */
    public SealedFrame seal(Frame frame, SealedFrame.Direction direction, int port, long counter) {
        int form = mode == Mode.AUTHENTICATED ? SealedFrame.AUTHENTICATED : SealedFrame.ENCRYPTED;
        Key first = ring.get(0);
        if (sealer == null) sealer = cipher();
        return SealedFrame.seal(sealer, first.of(direction), direction, form, frame, first.id(), port, counter);
    }

    /** The frame that can be read, or null if it cannot be opened, or is of a form that this mode does not take. */
    public Frame open(WireFrame frame, SealedFrame.Direction direction) {
        if (frame instanceof Frame plain) return mode.takesPlain() ? plain : null;
        SealedFrame sealed = (SealedFrame) frame;
        for (Key key : ring) {
            if (key.id() != sealed.key()) continue;
            Frame opened = open(sealed, key.of(direction), direction);
            if (opened != null) return opened;
        }
        return null;
    }

    /** A frame may come twice: early frames are opened again, and a group is heard on several interfaces. */
    private Frame open(SealedFrame frame, SecretKey key, SealedFrame.Direction direction) {
        for (int i = 0; i < 2; ++i) {
            try {
                if (opener == null) opener = cipher();
                return frame.open(opener, key, direction);
            } catch (InvalidKeyException isSameAgain) {
                opener = null;
            }
        }
        return null;
    }

    private static Cipher cipher() {
        try {
            return Cipher.getInstance("ChaCha20-Poly1305");
        } catch (GeneralSecurityException fault) {
            throw new IllegalStateException("this Java has no ChaCha20-Poly1305, so a sealed channel cannot be opened", fault);
        }
    }

    @Override
    public String toString() {
        return mode.name().toLowerCase(Locale.ROOT) + " with " + ring.size() + " keys";
    }
}
