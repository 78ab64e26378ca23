package geminga;

import java.nio.charset.StandardCharsets;

/**
 * A message of a subscriber.
 *
 * @param payload the octets after conversions; they belong to the receiver
 * @param life the life of its publisher; 0 if that states none
 * @param sequence its number among the messages of this life, from 1 on; unsigned
 * @param missed how many messages of this life did not come, or were lost in a full inbox, between the one before and this one
 * @param provider the provider that sent it
 */
public record Message(byte[] payload, long life, long sequence, long missed, Match provider) {
    /** {@return the payload as UTF-8} */
    public String text() {
        return new String(payload, StandardCharsets.UTF_8);
    }
}
