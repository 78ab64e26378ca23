package geminga.protocol;

import java.net.Inet6Address;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.security.GeneralSecurityException;
import java.time.Duration;
import javax.crypto.Mac;
import javax.crypto.spec.SecretKeySpec;

/**
 * The cookies of one publisher, which nobody keeps: whoever gives one back receives at the address that it was made for (src/client/CHANNELS.md, "The handshake"). The caller
 * gives the time, in nanoseconds.
 */
public final class Cookies {
    /** The octets that a publisher draws when it is made. */
    public static final int SECRET = 32;
    /** The time for which cookies have the same number. */
    static final long PERIOD = Duration.ofSeconds(8).toNanos();

    private final Mac mac;
    private final long begin;

    public Cookies(byte[] secret, long now) {
        begin = now;
        try {
            mac = Mac.getInstance("HmacSHA256");
            mac.init(new SecretKeySpec(secret, "HmacSHA256"));
        } catch (GeneralSecurityException fault) {
            throw new IllegalStateException(fault);
        }
    }

    /** The cookie of this address, life and challenge; not 0. */
    public long make(InetSocketAddress from, long life, long challenge, long now) {
        return of(from, life, challenge, period(now));
    }

    /** Whether the cookie was made for them in the present or the last 8 s. */
    public boolean isRight(long cookie, InetSocketAddress from, long life, long challenge, long now) {
        if (cookie == 0) return false;
        long period = period(now);
        return cookie == of(from, life, challenge, period) | cookie == of(from, life, challenge, period - 1);
    }

    private long period(long now) {
        return Math.floorDiv(now - begin, PERIOD);
    }

    private long of(InetSocketAddress from, long life, long challenge, long period) {
        byte[] address = from.getAddress().getAddress();
        int zone = from.getAddress() instanceof Inet6Address six ? six.getScopeId() : 0;
        ByteBuffer said = ByteBuffer.allocate(1 + address.length + 2 * Integer.BYTES + 3 * Long.BYTES);
        said.put((byte) address.length).put(address).putInt(zone).putInt(from.getPort()).putLong(life).putLong(challenge).putLong(period);
        long cookie = ByteBuffer.wrap(mac.doFinal(said.array())).getLong();
        return cookie == 0 ? 1 : cookie;
    }
}
