package geminga;

/** The change of the other side of a channel. */
public enum Change {
    /** It was added. */
    ADDED,
    /** Its statement or its address has changed. */
    MODIFIED,
    /** It is gone. */
    REMOVED
}
