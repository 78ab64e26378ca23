package geminga.protocol;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/** The keys and attributes of an offer or a request. Immutable. A wrong one is an {@link IllegalArgumentException}. */
public final class Words {
    public static final int MAX_ATTRIBUTES = 32;
    public static final int MAX_NAME = 64;
    public static final int MAX_VALUE = 255;

    private static final List<String> OFFER = List.of("mode id text concept representation port address protocol priority scope for".split(" "));
    private static final List<String> REQUEST = List.of(("mode id text concept representation match provider where protocol favour prefer rank scope convert on reach limit "
            + "priority port address").split(" "));
    private static final List<String> OFFER_CHANGE = List.of("id text concept representation mode address port priority protocol scope for".split(" "));
    private static final List<String> REQUEST_CHANGE = List.of(("id text concept representation mode address port priority match provider where protocol favour prefer "
            + "rank scope convert on reach limit").split(" "));
    private static final List<String> IDENTITY = List.of("id", "text", "concept", "representation");

    private final boolean isOffer;
    private final Map<String, String> keys;
    private final TreeMap<String, String> attributes;

    private Words(boolean isOffer, Map<String, String> keys, TreeMap<String, String> attributes) {
        this.isOffer = isOffer;
        this.keys = keys;
        this.attributes = attributes;
    }

    public static Words offer() {
        return new Words(true, Map.of(), attributes(Map.of()));
    }

    public static Words request() {
        return new Words(false, Map.of(), attributes(Map.of()));
    }

    /** Reads the parameters of {@code pub create} or {@code sub create}. */
    public Words read(String text) {
        try {
            return read(Statement.readParameters(text));
        } catch (LineException fault) {
            throw new IllegalArgumentException(fault.getMessage(), fault);
        }
    }

    /** States all of these parameters, each of which may stand once. */
    public Words read(List<Parameter> parameters) {
        Words words = this;
        Words fresh = isOffer ? offer() : request();
        for (Parameter parameter : parameters) {
            int stated = fresh.keys.size() + fresh.attributes.size();
            fresh = fresh.put(parameter.key(), parameter.value());
            if (!isKey(parameter.key()) && fresh.keys.size() + fresh.attributes.size() == stated) throw new IllegalArgumentException(parameter.key() + " is given twice");
            words = words.with(parameter.key(), parameter.value());
        }
        if (fresh.kinds() > 1) throw new IllegalArgumentException("one of id, text and concept");
        return words;
    }

    /** States one key of GCNP, or an attribute as a client writes it. An empty value takes a key back. Another kind of identity takes the place of the former. */
    public Words with(String key, String value) {
        Words words = this;
        if (IDENTITY.contains(key)) {
            boolean isConcept = key.equals("concept") || key.equals("representation");
            for (String other : IDENTITY) {
                if (!other.equals(key) && !(isConcept && (other.equals("concept") || other.equals("representation")))) words = words.put(other, null);
            }
        }
        return words.put(key, value);
    }

    /** States an attribute of any name. */
    public Words withAttribute(String name, String value) {
        if (!Statement.isKey(name) || name.length() > MAX_NAME) throw new IllegalArgumentException("the name of an attribute has 1 to 64 letters, digits, '_', '.' or '-'");
        Values.writable("attribute " + name, value);
        Values.text("attribute " + name, value, 0, MAX_VALUE);
        TreeMap<String, String> changed = attributes(attributes);
        changed.put(name, value);
        if (changed.size() > MAX_ATTRIBUTES) throw new IllegalArgumentException("at most " + MAX_ATTRIBUTES + " attributes");
        return new Words(isOffer, keys, changed);
    }

    /** The value of a key; empty if it is not stated. */
    public String get(String key) {
        return keys.getOrDefault(key, "");
    }

    public Map<String, String> attributes() {
        return Map.copyOf(attributes);
    }

    /** The parameters of {@code create}, in the order of GCNP. */
    public Map<String, String> parameters() {
        Map<String, String> found = new LinkedHashMap<>();
        for (String key : isOffer ? OFFER : REQUEST) {
            if (keys.containsKey(key)) found.put(key, keys.get(key));
        }
        attributes.forEach((name, value) -> found.put(Keys.stating(name), value));
        return found;
    }

    /** The parameters of {@code modify} that turn {@code before} into this. An attribute cannot be taken back. */
    public Map<String, String> changesFrom(Words before) {
        Map<String, String> found = new LinkedHashMap<>();
        for (String key : isOffer ? OFFER_CHANGE : REQUEST_CHANGE) {
            if (get(key).equals(before.get(key))) continue;
            boolean isOtherKind = key.equals("id") || key.equals("text") || key.equals("concept") || key.equals("representation") && get("concept").isEmpty();
            if (!get(key).isEmpty() || !isOtherKind) found.put(key, get(key).isEmpty() ? usual(key) : get(key));
        }
        attributes.forEach((name, value) -> {
            if (!value.equals(before.attributes.get(name))) found.put(Keys.stating(name), value);
        });
        return found;
    }

    /** Throws if something is missing that must be stated. */
    public Words complete() {
        if (get("mode").isEmpty()) throw new IllegalArgumentException("mode must be said");
        if (kinds() == 0) throw new IllegalArgumentException(get("representation").isEmpty() ? "one of id, text and concept must be said" : "a representation belongs to a concept");
        return this;
    }

    private int kinds() {
        return (int) List.of("id", "text", "concept").stream().filter(keys::containsKey).count();
    }

    private Words put(String key, String value) {
        if (!isKey(key)) return withAttribute(attribute(key), value);
        String written = value == null ? "" : Values.of(key, value, isOffer);
        Map<String, String> changed = new LinkedHashMap<>(keys);
        if (written.isEmpty()) {
            changed.remove(key);
        } else {
            changed.put(key, written);
        }
        return new Words(isOffer, changed, attributes);
    }

    private boolean isKey(String key) {
        return (isOffer ? OFFER : REQUEST).contains(key);
    }

    private static String attribute(String key) {
        try {
            return Keys.stated(key);
        } catch (LineException fault) {
            throw new IllegalArgumentException(fault.getMessage(), fault);
        }
    }

    /** The value by which a modify takes a key back. */
    private String usual(String key) {
        return switch (key) {
            case "priority" -> "0";
            case "match" -> "narrower";
            case "convert" -> "no";
            case "limit" -> get("mode").equals("oto") ? "1" : "0";
            default -> "";
        };
    }

    private static TreeMap<String, String> attributes(Map<String, String> from) {
        TreeMap<String, String> made = new TreeMap<>((a, b) -> Arrays.compareUnsigned(a.getBytes(StandardCharsets.UTF_8), b.getBytes(StandardCharsets.UTF_8)));
        made.putAll(from);
        return made;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Words words && isOffer == words.isOffer && keys.equals(words.keys) && attributes.equals(words.attributes);
    }

    @Override
    public int hashCode() {
        return keys.hashCode() * 31 + attributes.hashCode();
    }
}
