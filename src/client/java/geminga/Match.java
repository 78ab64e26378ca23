package geminga;

import geminga.protocol.Life;
import java.util.List;
import java.util.Map;

/**
 * The other side of a channel as the daemon tells of it: the provider of a subscriber, or a consumer of a publisher.
 *
 * @param word the service or subscription, as {@code PARTICIPANT/PEER/NUMBER}
 * @param owner its peer, as {@code PARTICIPANT/PEER}
 * @param name the peer's name; empty if it has none
 * @param host the name of its participant
 * @param life its life; 0 if it states none, because no library of this kind made it
 * @param identity the identity that it offers or asks for
 * @param degree the degree of match between the identities of both sides
 * @param distance edges of the taxonomy between the two
 * @param mode how messages flow
 * @param address its numeric address; empty if unstated
 * @param port its port; 0 if unstated
 * @param protocol of a provider, empty for a consumer
 * @param priority in an arbitration; the greater wins
 * @param conversion the representations from the offered one to the wanted one; empty if they are the same
 * @param cost the cost of the conversion; 0 if there is none
 * @param via the service of each conversion, with commas: {@code PROTOCOL://ADDRESS:PORT/SERVICE}, or {@code -} for the consumer; empty if the consumer does all
 * @param attributes the attributes that it states
 * @param hops relays on the way to its host; 0 if it is heard directly
 * @param path the names of those that are known, joined by {@code /}, the nearest to its host first
 * @param reachable whether nothing stands against its address being reached from this host
 */
public record Match(String word, String owner, String name, String host, long life, Identity identity, Degree degree, int distance, Mode mode, String address, int port,
        String protocol, int priority, List<String> conversion, long cost, String via, Map<String, String> attributes, int hops, String path, boolean reachable) {
    /** {@return the life in sixteen hexadecimal digits} */
    public String lifeText() {
        return Life.write(life);
    }
}
