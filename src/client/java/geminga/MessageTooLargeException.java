package geminga;

import java.io.IOException;

/** A message that its channel cannot carry. */
public final class MessageTooLargeException extends IOException {
    private static final long serialVersionUID = 1;

    /**
     * Makes one.
     *
     * @param text the limit, and what to do
     */
    public MessageTooLargeException(String text) {
        super(text);
    }
}
