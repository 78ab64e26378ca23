package geminga.protocol;

/** XXH32 with seed 0, as the xxHash project specifies it: the hash of identities (src/identity/IDENTITY.md). */
public final class Xxh32 {
    private static final int PRIME1 = 0x9E3779B1;
    private static final int PRIME2 = 0x85EBCA77;
    private static final int PRIME3 = 0xC2B2AE3D;
    private static final int PRIME4 = 0x27D4EB2F;
    private static final int PRIME5 = 0x165667B1;

    private Xxh32() {}

    /** The hash of all octets; an unsigned number in the bits of an int. */
    public static int hash(byte[] data) {
        int at = 0;
        int hash;
        if (data.length >= 16) {
            int a = PRIME1 + PRIME2;
            int b = PRIME2;
            int c = 0;
            int d = -PRIME1;
            for (; at <= data.length - 16; at += 16) {
                a = round(a, word(data, at));
                b = round(b, word(data, at + 4));
                c = round(c, word(data, at + 8));
                d = round(d, word(data, at + 12));
            }
            hash = Integer.rotateLeft(a, 1) + Integer.rotateLeft(b, 7) + Integer.rotateLeft(c, 12) + Integer.rotateLeft(d, 18);
        } else {
            hash = PRIME5;
        }
        hash += data.length;
        for (; at <= data.length - 4; at += 4) hash = Integer.rotateLeft(hash + word(data, at) * PRIME3, 17) * PRIME4;
        for (; at < data.length; ++at) hash = Integer.rotateLeft(hash + (data[at] & 0xFF) * PRIME5, 11) * PRIME1;
        hash = (hash ^ (hash >>> 15)) * PRIME2;
        hash = (hash ^ (hash >>> 13)) * PRIME3;
        return hash ^ (hash >>> 16);
    }

    private static int round(int lane, int word) {
        return Integer.rotateLeft(lane + word * PRIME2, 13) * PRIME1;
    }

    private static int word(byte[] data, int at) {
        return (data[at] & 0xFF) | (data[at + 1] & 0xFF) << 8 | (data[at + 2] & 0xFF) << 16 | (data[at + 3] & 0xFF) << 24;
    }
}
