package geminga;

import geminga.protocol.Words;
import java.util.Map;

/** What a publisher offers, in the words of GCNP (src/discovery/gcnp/GCNP.md). Immutable: each method gives another offer. What cannot be stated is an {@link IllegalArgumentException}. */
public final class Offer {
    private final Words words;

    private Offer(Words words) {
        this.words = words;
    }

    /**
     * An offer over UDP at any port.
     *
     * @param mode how messages flow
     * @param identity what is offered
     * @return the offer
     */
    public static Offer of(Mode mode, Identity identity) {
        return new Offer(Request.state(Words.offer(), mode, identity));
    }

    /**
     * Reads an offer from the words behind {@code pub create}, as {@code mode=oto text=kick protocol=tcp rate=30}. The port may be left out.
     *
     * @param parameters as a line of GCNP has them, quotes and all
     * @return the offer
     */
    public static Offer read(String parameters) {
        return new Offer(Words.offer().read(parameters).complete());
    }

    /**
     * States what more parameters say, as those of {@code pub modify}.
     *
     * @param parameters as a line of GCNP has them, quotes and all
     * @return the offer
     */
    public Offer with(String parameters) {
        return new Offer(words.read(parameters).complete());
    }

    /**
     * Where the channel is offered.
     *
     * @param port 0 for any
     * @return the offer
     */
    public Offer port(int port) {
        return new Offer(words.with("port", Integer.toString(port)));
    }

    /**
     * The address of the channel: one of this host's, or a multicast address for {@link Mode#STREAM} over UDP.
     *
     * @param address in numbers; empty for each interface's own
     * @return the offer
     */
    public Offer address(String address) {
        return new Offer(words.with("address", address));
    }

    /**
     * Messages of up to 16 MiB in order, over TCP.
     *
     * @return the offer
     */
    public Offer tcp() {
        return new Offer(words.with("protocol", "tcp"));
    }

    /**
     * How the offer stands in arbitrations.
     *
     * @param priority the greater wins
     * @return the offer
     */
    public Offer priority(int priority) {
        return new Offer(words.with("priority", Integer.toString(priority)));
    }

    /**
     * On which hosts consumers may be (src/discovery/matching/conditions/SCOPE.md).
     *
     * @param scope as {@code host}, or {@code robot2/vision,!host}; empty for any
     * @return the offer
     */
    public Offer scope(String scope) {
        return new Offer(words.with("scope", scope));
    }

    /**
     * Which consumers may take it, by their attributes (src/discovery/matching/conditions/SCOPE.md).
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

    /** {@return how messages flow} */
    public Mode mode() {
        return Mode.of(words.get("mode"));
    }

    /** {@return what is offered} */
    public Identity identity() {
        return Request.identity(words);
    }

    /** {@return the port, 0 for any} */
    public int port() {
        return words.get("port").isEmpty() ? 0 : Integer.parseInt(words.get("port"));
    }

    /** {@return the address in numbers, empty for each interface's own} */
    public String address() {
        return words.get("address");
    }

    /** {@return {@code udp} or {@code tcp}} */
    public String protocol() {
        return words.get("protocol").isEmpty() ? "udp" : words.get("protocol");
    }

    /** {@return the attributes by their names} */
    public Map<String, String> attributes() {
        return words.attributes();
    }

    /** {@return all of it as {@code pub create} states it, in the order of GCNP} */
    public Map<String, String> parameters() {
        return words.parameters();
    }

    /**
     * What {@code pub modify} has to state to make another offer this one.
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
        return words.hashCode();
    }

    @Override
    public String toString() {
        return parameters().toString();
    }
}
