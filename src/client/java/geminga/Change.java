package geminga;

/** What became of the other side of a channel. */
public enum Change {
    /** It is there. */
    ADDED,
    /** What it states about itself changed, or where it is reached. */
    MODIFIED,
    /** It is gone. */
    REMOVED
}
