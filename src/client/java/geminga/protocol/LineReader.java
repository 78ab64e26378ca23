package geminga.protocol;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;

/** Lines put together from the octets of a stream. A line that is too long is skipped to its end and counted. */
public final class LineReader {
    private final ByteArrayOutputStream line = new ByteArrayOutputStream();
    private boolean skips;
    private long skipped;

    /** The next whole line, without its end; null if more octets are needed. Takes its octets from {@code octets}. */
    public String next(ByteBuffer octets) {
        while (octets.hasRemaining()) {
            byte octet = octets.get();
            if (octet == '\n') {
                if (!skips) return take();
                skips = false;
            } else if (!skips) {
                line.write(octet);
                if (line.size() > Statement.MAX_OCTETS + 1) { // one for a CR
                    line.reset();
                    skips = true;
                    ++skipped;
                }
            }
        }
        return null;
    }

    /** How many lines were too long. */
    public long skipped() {
        return skipped;
    }

    private String take() {
        String text = line.toString(StandardCharsets.UTF_8);
        line.reset();
        return text.endsWith("\r") ? text.substring(0, text.length() - 1) : text;
    }
}
