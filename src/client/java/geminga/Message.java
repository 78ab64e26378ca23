package geminga;

import java.nio.charset.StandardCharsets;

/**
 * What a subscriber received.
 *
 * @param payload the octets, conversions applied; the receiver's own
 * @param life whose message it is; 0 where its sender states none
 * @param sequence its number among the messages of this life, from 1 on; unsigned
 * @param missed how many messages of this life are missing between the one before and this one
 * @param provider who sent it
 */
public record Message(byte[] payload, long life, long sequence, long missed, Match provider) {
    /** {@return the payload as UTF-8} */
    public String text() {
        return new String(payload, StandardCharsets.UTF_8);
    }
}
