package geminga.protocol;

import geminga.Change;
import geminga.Degree;
import geminga.Identity;
import geminga.Match;
import geminga.Mode;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * An event of the daemon about one request, as {@code pub add}. Unknown keys are attributes, so a newer daemon may send more than its client knows.
 *
 * @param id the number of the request
 * @param isOfService whether a service was found ({@code pub}), or a consumer ({@code sub})
 * @param keys the values of reserved keys, in the order of the line
 * @param attributes the values of all other keys, in the order of the line
 */
public record Told(long id, boolean isOfService, Change change, Map<String, String> keys, Map<String, String> attributes) {
    private static final List<String> CHANGES = List.of("add", "modify", "del");
    /** Keys after {@code convert}, and otherwise names of attributes. */
    private static final List<String> OF_CHAIN = List.of("cost", "via");

    /** Keys that stand behind the attributes; {@code path} is the name of an attribute without {@code hops}. */
    private static final List<String> OF_WAY = List.of("hops", "path", "reachable");

    /** The event that a statement of the daemon is, or null if it is none. A part that cannot be read is an error. */
    public static Told read(Statement statement) throws LineException {
        boolean isOfService = statement.command().equals("pub");
        int change = CHANGES.indexOf(statement.subcommand());
        if (change < 0 || !isOfService && !statement.command().equals("sub")) return null;
        Map<String, String> keys = new LinkedHashMap<>();
        Map<String, String> attributes = new LinkedHashMap<>();
        for (Parameter parameter : statement.parameters()) {
            boolean isOfChain = OF_CHAIN.contains(parameter.key()) && keys.containsKey("convert") && !keys.containsKey(parameter.key());
            boolean isOfWay = parameter.key().equals("path") && keys.containsKey("hops") && !keys.containsKey("path");
            String name = isOfChain || isOfWay ? null : Keys.shown(parameter.key());
            if (name == null) {
                keys.put(parameter.key(), parameter.value());
            } else if (attributes.put(name, parameter.value()) != null) {
                throw new LineException(name + " is given twice");
            }
        }
        Told told = new Told(statement.id(), isOfService, Change.values()[change], keys, attributes);
        if (told.word().isEmpty()) throw new LineException("whom it is about is missing");
        if (told.change != Change.REMOVED) told.match();
        return told;
    }

    /** The statement that it was read from. */
    public Statement write() {
        List<Parameter> parameters = new ArrayList<>();
        keys.forEach((key, value) -> {
            if (!OF_WAY.contains(key)) parameters.add(new Parameter(key, value));
        });
        attributes.forEach((name, value) -> {
            boolean isTaken = OF_CHAIN.contains(name) && keys.containsKey("convert") || name.equals("path") && keys.containsKey("hops");
            parameters.add(new Parameter(isTaken ? Keys.PREFIX + name : Keys.showing(name), value));
        });
        for (String key : OF_WAY) if (keys.containsKey(key)) parameters.add(new Parameter(key, keys.get(key)));
        return new Statement(id, isOfService ? "pub" : "sub", CHANGES.get(change.ordinal()), parameters);
    }

    /** The key of the service or subscription. */
    public String word() {
        return text(isOfService ? "service" : "subscription");
    }

    /** The reason why it is gone. */
    public String reason() {
        return text("reason");
    }

    /** The other side. Not for {@link Change#REMOVED}. */
    public Match match() throws LineException {
        try {
            return new Match(word(), text(isOfService ? "provider" : "consumer"), text("name"), text("participant_name"), Life.read(attributes.get("channel")), identity(),
                    Degree.of(text("degree")), number("distance"), Mode.of(text("mode")), text("address"), (int) Values.number("port", orZero("port"), 0, 65535),
                    text("protocol"), number("priority"), chain(text("convert")), Values.number("cost", orZero("cost"), 0, Statement.MAX_ID), text("via"), Collections.unmodifiableMap(attributes),
                    number("hops"), text("path"), !text("reachable").equals("no"));
        } catch (IllegalArgumentException fault) {
            throw new LineException(fault.getMessage());
        }
    }

    /** The names of {@code A>B>C}. An IRI in angle brackets is one name. */
    static List<String> chain(String text) throws LineException {
        List<String> names = new ArrayList<>();
        for (int at = 0; at < text.length();) {
            int mark = text.indexOf('>', at);
            int end = mark < 0 ? text.length() : text.charAt(at) == '<' ? mark + 1 : mark;
            boolean isLast = end == text.length();
            boolean isRight = end > at && (isLast ? !names.isEmpty() : text.charAt(end) == '>' && end + 1 < text.length());
            if (!isRight) throw new LineException("no chain of conversions: " + text);
            names.add(text.substring(at, end));
            at = isLast ? end : end + 1;
        }
        return names;
    }

    private Identity identity() {
        if (keys.containsKey("id")) return Identity.number(Values.number("id", text("id"), 0, Statement.MAX_ID));
        if (keys.containsKey("text")) return Identity.text(text("text"));
        return Identity.concept(text("concept"), text("representation"));
    }

    private String text(String key) {
        return keys.getOrDefault(key, "");
    }

    private String orZero(String key) {
        return keys.getOrDefault(key, "0");
    }

    private int number(String key) {
        return (int) Values.number(key, orZero(key), Integer.MIN_VALUE, Integer.MAX_VALUE);
    }
}
