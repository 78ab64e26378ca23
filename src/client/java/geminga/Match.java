package geminga;

import geminga.protocol.Life;
import java.util.List;
import java.util.Map;

/**
 * The other side of a channel as the daemon tells of it: the provider of a subscriber, or a consumer of a publisher.
 *
 * @param word the service or subscription, as {@code PARTICIPANT/PEER/NUMBER}
 * @param owner its peer, as {@code PARTICIPANT/PEER}
 * @param name the peer's name, empty where it has none
 * @param host the name of its participant
 * @param life its life; 0 where it states none, because no library of this kind made it
 * @param identity what it offers or asks for
 * @param degree how that stands to the other side's identity
 * @param distance edges of the taxonomy between the two
 * @param mode how messages flow
 * @param address where it can be reached, in numbers; empty where unstated
 * @param port the same; 0 where unstated
 * @param protocol of a provider, empty for a consumer
 * @param priority in an arbitration; the greater wins
 * @param conversion representations from the offered one to the wanted one; empty where they are the same
 * @param cost what the conversion costs; 0 where there is none
 * @param via who does each conversion, with commas: {@code PROTOCOL://ADDRESS:PORT/SERVICE}, or {@code -} where the consumer does; empty where it does all
 * @param attributes what it states about itself
 */
public record Match(String word, String owner, String name, String host, long life, Identity identity, Degree degree, int distance, Mode mode, String address, int port,
        String protocol, int priority, List<String> conversion, long cost, String via, Map<String, String> attributes) {
    /** {@return the life in sixteen hexadecimal digits} */
    public String lifeText() {
        return Life.write(life);
    }
}
