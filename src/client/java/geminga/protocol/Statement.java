package geminga.protocol;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** One line of GCNP by its grammar (src/discovery/gcnp/GCNP.md, "Lines"), without its meaning. */
public record Statement(long id, String command, String subcommand, List<Parameter> parameters) {
    /** Octets of a line, its end not counted. */
    public static final int MAX_OCTETS = 65536;
    /** Parameters of a line. */
    public static final int MAX_PARAMETERS = 256;
    /** The greatest number that a request can have. */
    public static final long MAX_ID = 0xFFFF_FFFFL;

    private static final String ESCAPES = "\"\\nrt";
    private static final String ESCAPED = "\"\\\n\r\t";

    public Statement {
        parameters = List.copyOf(parameters);
    }

    /** Reads a line without its end. */
    public static Statement read(String line) throws LineException {
        if (line.getBytes(StandardCharsets.UTF_8).length > MAX_OCTETS) throw new LineException("the line is too long");
        return new Cursor(line).statement();
    }

    /** Reads parameters alone, as they follow the subcommand. */
    public static List<Parameter> readParameters(String text) throws LineException {
        return new Cursor(text).parameters();
    }

    /** The line, without its end. A control character that the grammar cannot express is an {@link IllegalArgumentException}. */
    public String write() {
        StringBuilder line = new StringBuilder();
        line.append(id).append(' ').append(command).append(' ').append(subcommand);
        for (Parameter parameter : parameters) {
            line.append(' ').append(parameter.key()).append('=');
            append(line, parameter.value());
        }
        return line.toString();
    }

    private static void append(StringBuilder line, String value) {
        if (!value.isEmpty() && value.chars().allMatch(Statement::isBare)) {
            line.append(value);
            return;
        }
        line.append('"');
        for (int i = 0; i < value.length(); ++i) {
            char c = value.charAt(i);
            int escape = ESCAPED.indexOf(c);
            if (escape >= 0) {
                line.append('\\').append(ESCAPES.charAt(escape));
            } else if (isControl(c)) {
                throw new IllegalArgumentException("a value cannot hold the control character " + (int) c);
            } else {
                line.append(c);
            }
        }
        line.append('"');
    }

    /** Whether a line can hold the value. */
    public static boolean isWritable(String value) {
        return value.chars().noneMatch(c -> isControl(c) && ESCAPED.indexOf(c) < 0);
    }

    private static boolean isControl(int c) {
        return c < 32 || c == 127;
    }

    private static boolean isBare(int c) {
        return c != ' ' && c != '"' && !isControl(c);
    }

    /** Whether the word may be a key. */
    public static boolean isKey(String word) {
        return !word.isEmpty() && word.chars().allMatch(Statement::isKeyCharacter);
    }

    private static boolean isKeyCharacter(int c) {
        return c >= 'A' && c <= 'Z' || c >= 'a' && c <= 'z' || c >= '0' && c <= '9' || c == '_' || c == '.' || c == '-';
    }

    /** Walks one line from left to right. */
    private static final class Cursor {
        private final String line;
        private int at;

        Cursor(String line) {
            this.line = line;
        }

        Statement statement() throws LineException {
            String digits = word();
            if (digits.isEmpty() || digits.length() > 10 || !digits.chars().allMatch(c -> c >= '0' && c <= '9')) throw fault("a statement begins with an id");
            long id = Long.parseLong(digits);
            if (id > MAX_ID) throw fault("the id is too great");
            String command = spacedKey();
            String subcommand = spacedKey();
            if (at < line.length() && line.charAt(at) != ' ') throw fault("a space is missing");
            return new Statement(id, command, subcommand, parameters());
        }

        List<Parameter> parameters() throws LineException {
            List<Parameter> found = new ArrayList<>();
            Set<String> keys = new HashSet<>();
            for (skipSpaces(); at < line.length(); skipSpaces()) {
                if (found.size() == MAX_PARAMETERS) throw fault("too many parameters");
                Parameter parameter = parameter();
                if (!keys.add(parameter.key())) throw fault(parameter.key() + " is given twice");
                found.add(parameter);
            }
            return found;
        }

        private Parameter parameter() throws LineException {
            String key = word();
            if (key.isEmpty()) throw fault("a key is missing");
            if (at == line.length() || line.charAt(at) == ' ') return new Parameter(key, "");
            if (line.charAt(at) != '=') throw fault("no character of a key");
            ++at;
            if (at < line.length() && line.charAt(at) == '"') return new Parameter(key, quoted());
            int begin = at;
            while (at < line.length() && isBare(line.charAt(at))) ++at;
            if (at < line.length() && line.charAt(at) != ' ') throw fault("a character that belongs into quotes");
            return new Parameter(key, line.substring(begin, at));
        }

        private String quoted() throws LineException {
            StringBuilder value = new StringBuilder();
            for (++at; ; ++at) {
                if (at == line.length()) throw fault("the closing quote is missing");
                char c = line.charAt(at);
                if (c == '"') break;
                if (isControl(c)) throw fault("a control character");
                if (c != '\\') {
                    value.append(c);
                    continue;
                }
                ++at;
                int escape = at == line.length() ? -1 : ESCAPES.indexOf(line.charAt(at));
                if (escape < 0) throw fault("no escape");
                value.append(ESCAPED.charAt(escape));
            }
            ++at;
            if (at < line.length() && line.charAt(at) != ' ') throw fault("a space is missing behind the quote");
            return value.toString();
        }

        private String spacedKey() throws LineException {
            if (at == line.length() || line.charAt(at) != ' ') throw fault("a space is missing");
            skipSpaces();
            String key = word();
            if (key.isEmpty()) throw fault("a word is missing");
            return key;
        }

        private String word() {
            int begin = at;
            while (at < line.length() && isKeyCharacter(line.charAt(at))) ++at;
            return line.substring(begin, at);
        }

        private void skipSpaces() {
            while (at < line.length() && line.charAt(at) == ' ') ++at;
        }

        private LineException fault(String text) {
            return new LineException("character " + (at + 1) + ": " + text);
        }
    }
}
