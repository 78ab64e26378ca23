package geminga.protocol;

/** A line, or a part of one, that GCNP does not allow. */
public final class LineException extends Exception {
    private static final long serialVersionUID = 1;

    public LineException(String text) {
        super(text);
    }
}
