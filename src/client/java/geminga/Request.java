package geminga;

import geminga.protocol.Words;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** The request of a subscriber, in the words of GCNP (src/discovery/gcnp/GCNP.md). Immutable: each method gives another request, and throws {@link IllegalArgumentException} for a value that cannot be stated. */
public final class Request extends Service {
    private final Map<String, Conversion> conversions;

    private Request(Words words, Map<String, Conversion> conversions) {
        super(words);
        this.conversions = conversions;
    }

    /**
     * A request for all that matches, over UDP and TCP.
     *
     * @param mode the mode of the channel
     * @param identity the requested identity
     * @return the request
     */
    public static Request of(Mode mode, Identity identity) {
        return new Request(stated(Words.request(), mode, identity), Map.of());
    }

    /**
     * Reads a request from the words behind {@code sub create}, as {@code mode=otm/stream concept=soccer:BallInfo where="rate > 10"}.
     *
     * @param parameters as in a line of GCNP, with quotes
     * @return the request
     */
    public static Request read(String parameters) {
        return new Request(Words.request().read(parameters).complete(), Map.of());
    }

    /**
     * States more parameters, as {@code sub modify} does.
     *
     * @param parameters as in a line of GCNP, with quotes
     * @return the request
     */
    public Request with(String parameters) {
        return new Request(words.read(parameters).complete(), conversions);
    }

    /**
     * States the weakest degree of match that counts.
     *
     * @param weakest any but {@link Degree#CONVERTED}, which {@link #convert} asks for
     * @return the request
     */
    public Request match(Degree weakest) {
        return with("match", weakest.word());
    }

    /**
     * States the providers that count.
     *
     * @param providers {@code PARTICIPANT[/PEER]} each, by identifier or by name; none for all
     * @return the request
     */
    public Request providers(String... providers) {
        return with("provider", String.join(",", providers));
    }

    /**
     * States the providers that come first (src/discovery/matching/arbitration/PREFERENCES.md).
     *
     * @param providers {@code PARTICIPANT[/PEER]} each, in this order; none for no preference
     * @return the request
     */
    public Request favour(String... providers) {
        return with("favour", String.join(",", providers));
    }

    /**
     * States the attributes by which a provider is better (src/discovery/matching/arbitration/PREFERENCES.md).
     *
     * @param wishes {@code KEY asc} or {@code KEY desc} each, perhaps with {@code by NUMBER [UNIT]}
     * @return the request
     */
    public Request prefer(String... wishes) {
        return with("prefer", String.join(", ", wishes));
    }

    /**
     * States the order of the criteria of ranking.
     *
     * @param order of {@code favour}, {@code priority}, {@code prefer}, {@code degree} and {@code distance}
     * @return the request
     */
    public Request rank(String... order) {
        return with("rank", String.join(",", order));
    }

    /**
     * States a condition over attributes (src/discovery/matching/conditions/WHERE.md).
     *
     * @param condition as {@code rate >= 30 and camera = 'front'}; empty for none
     * @return the request
     */
    public Request where(String condition) {
        return with("where", condition);
    }

    /**
     * States the hosts on which providers may be (src/discovery/matching/conditions/SCOPE.md).
     *
     * @param scope as {@code host}, or {@code robot2/vision,!host}; empty for any
     * @return the request
     */
    public Request scope(String scope) {
        return with("scope", scope);
    }

    /**
     * States what the robots of providers must be known to be, by their descriptions (src/discovery/gcnp/GCNP.md).
     *
     * @param expression a class or a class expression, as {@code soccer:Robot and (soccer:hasPart some soccer:Mast)}; empty for any
     * @return the request
     */
    public Request on(String expression) {
        return with("on", expression);
    }

    /**
     * States which services count by whether their address can be reached from this host (src/discovery/gcnp/GCNP.md, "Reach").
     *
     * @param reach {@code routed}, as by default, or {@code any}
     * @return the request
     */
    public Request reach(String reach) {
        return with("reach", reach);
    }

    /**
     * States the protocols over which messages may come.
     *
     * @param protocols {@code udp}, {@code tcp}; none for both
     * @return the request
     */
    public Request protocols(String... protocols) {
        return with("protocol", String.join(",", protocols));
    }

    /**
     * States the largest number of providers, the best ones.
     *
     * @param limit 0 for all
     * @return the request
     */
    public Request limit(int limit) {
        return with("limit", Integer.toString(limit));
    }

    /**
     * States the priority of the consumer at a provider that can serve few.
     *
     * @param priority the greater wins
     * @return the request
     */
    public Request priority(int priority) {
        return with("priority", Integer.toString(priority));
    }

    /**
     * States the port for messages over UDP.
     *
     * @param port 0 for any
     * @return the request
     */
    public Request port(int port) {
        return with("port", Integer.toString(port));
    }

    /**
     * States the address for messages over UDP.
     *
     * @param address in numbers; empty for each interface's own
     * @return the request
     */
    public Request address(String address) {
        return with("address", address);
    }

    /**
     * Asks also for services whose representation can be converted into the requested one (src/discovery/matching/conversions/CONVERSIONS.md).
     *
     * @param cost {@code yes}, {@code no}, or the largest cost
     * @return the request
     */
    public Request convert(String cost) {
        return with("convert", cost);
    }

    /**
     * Adds the function for one conversion, by the names that events use. It is called when messages are taken.
     *
     * @param from the representation that it takes
     * @param to the representation that it makes
     * @param function converts a payload
     * @return the request
     */
    public Request conversion(String from, String to, Conversion function) {
        Map<String, Conversion> more = new LinkedHashMap<>(conversions);
        more.put(from + '>' + to, function);
        return new Request(words, Map.copyOf(more));
    }

    /**
     * States an attribute, on which providers may have a condition.
     *
     * @param name 1 to 64 letters, digits, {@code _}, {@code .} or {@code -}
     * @param value up to 255 octets
     * @return the request
     */
    public Request attribute(String name, String value) {
        return new Request(words.withAttribute(name, value), conversions);
    }

    /** {@return the protocols over which messages may come} */
    public List<String> protocols() {
        return words.get("protocol").isEmpty() ? List.of("udp", "tcp") : List.of(words.get("protocol").split(","));
    }

    /** {@return how many providers at most; 0 for all} */
    public long limit() {
        if (words.get("limit").isEmpty()) return mode() == Mode.ONE_TO_ONE ? 1 : 0;
        return Long.parseLong(words.get("limit"));
    }

    /** {@return the functions by {@code FROM>TO}} */
    public Map<String, Conversion> conversions() {
        return conversions;
    }

    /**
     * The parameters of {@code sub modify} that turn another request into this one.
     *
     * @param before the other one
     * @return keys and values in the order of GCNP
     */
    public Map<String, String> changesFrom(Request before) {
        return words.changesFrom(before.words);
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Request request && words.equals(request.words) && conversions.equals(request.conversions);
    }

    @Override
    public int hashCode() {
        return super.hashCode();
    }

    private Request with(String key, String value) {
        return new Request(words.with(key, value), conversions);
    }
}
