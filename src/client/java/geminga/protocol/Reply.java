package geminga.protocol;

/** An error line of the daemon: {@code N EEE text}. */
public record Reply(long id, int code, String text) {
    /** The reply that the line is, or null if it is a statement. */
    public static Reply read(String line) {
        int space = line.indexOf(' ');
        if (space < 1 || space > 10 || line.length() < space + 4) return null;
        for (int i = 0; i < space + 4; ++i) {
            if (i != space && !isDigit(line.charAt(i))) return null;
        }
        boolean ends = line.length() == space + 4;
        if (!ends && line.charAt(space + 4) != ' ') return null;
        return new Reply(Long.parseLong(line, 0, space, 10), Integer.parseInt(line, space + 1, space + 4, 10), ends ? "" : line.substring(space + 5));
    }

    /** The line, without its end. */
    public String write() {
        return id + " " + code + (text.isEmpty() ? "" : " " + text);
    }

    private static boolean isDigit(char c) {
        return c >= '0' && c <= '9';
    }
}
