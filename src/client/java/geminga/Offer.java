package geminga;

import geminga.protocol.Words;
import java.util.Map;

/** The offer of a publisher, in the words of GCNP (src/discovery/gcnp/GCNP.md). Immutable: each method gives another offer, and throws {@link IllegalArgumentException} for a value that cannot be stated. */
public final class Offer extends Service {
    private Offer(Words words) {
        super(words);
    }

    /**
     * An offer over UDP at any port.
     *
     * @param mode the mode of the channel
     * @param identity the identity of the service
     * @return the offer
     */
    public static Offer of(Mode mode, Identity identity) {
        return new Offer(stated(Words.offer(), mode, identity));
    }

    /**
     * Reads an offer from the words behind {@code pub create}, as {@code mode=oto text=kick protocol=tcp rate=30}. The port may be left out.
     *
     * @param parameters as in a line of GCNP, with quotes
     * @return the offer
     */
    public static Offer read(String parameters) {
        return new Offer(Words.offer().read(parameters).complete());
    }

    /**
     * States more parameters, as {@code pub modify} does.
     *
     * @param parameters as in a line of GCNP, with quotes
     * @return the offer
     */
    public Offer with(String parameters) {
        return new Offer(words.read(parameters).complete());
    }

    /**
     * States the port of the channel.
     *
     * @param port 0 for any
     * @return the offer
     */
    public Offer port(int port) {
        return new Offer(words.with("port", Integer.toString(port)));
    }

    /**
     * States the address of the channel: one of this host's, or a multicast address for {@link Mode#STREAM} over UDP.
     *
     * @param address in numbers; empty for each interface's own
     * @return the offer
     */
    public Offer address(String address) {
        return new Offer(words.with("address", address));
    }

    /**
     * States TCP: messages of up to 16 MiB, in order.
     *
     * @return the offer
     */
    public Offer tcp() {
        return new Offer(words.with("protocol", "tcp"));
    }

    /**
     * States the priority of the offer in arbitrations.
     *
     * @param priority the greater wins
     * @return the offer
     */
    public Offer priority(int priority) {
        return new Offer(words.with("priority", Integer.toString(priority)));
    }

    /**
     * States the hosts on which consumers may be (src/discovery/matching/conditions/SCOPE.md).
     *
     * @param scope as {@code host}, or {@code robot2/vision,!host}; empty for any
     * @return the offer
     */
    public Offer scope(String scope) {
        return new Offer(words.with("scope", scope));
    }

    /**
     * States a condition on the attributes of consumers (src/discovery/matching/conditions/SCOPE.md).
     *
     * @param condition as {@code rate in (10, 30)}; empty for all
     * @return the offer
     */
    public Offer audience(String condition) {
        return new Offer(words.with("for", condition));
    }

    /**
     * States an attribute, which is announced and can be asked for.
     *
     * @param name 1 to 64 letters, digits, {@code _}, {@code .} or {@code -}
     * @param value up to 255 octets
     * @return the offer
     */
    public Offer attribute(String name, String value) {
        return new Offer(words.withAttribute(name, value));
    }

    /** {@return {@code udp} or {@code tcp}} */
    public String protocol() {
        return words.get("protocol").isEmpty() ? "udp" : words.get("protocol");
    }

    /**
     * The parameters of {@code pub modify} that turn another offer into this one.
     *
     * @param before the other one
     * @return keys and values in the order of GCNP
     */
    public Map<String, String> changesFrom(Offer before) {
        return words.changesFrom(before.words);
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Offer offer && words.equals(offer.words);
    }

    @Override
    public int hashCode() {
        return super.hashCode();
    }
}
