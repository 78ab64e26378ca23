package geminga;

/** Modes of channels between a provider and its consumers. */
public enum Mode {
    /** One to one. */
    ONE_TO_ONE("oto"),
    /** One to many; consumers listen and the provider is not told of them. */
    STREAM("otm/stream"),
    /** One to many; the channel is opened for the first consumer and closed after the last. */
    PUBSUB("otm/pubsub");

    private final String word;

    Mode(String word) {
        this.word = word;
    }

    /** {@return the word of GCNP} */
    public String word() {
        return word;
    }

    /**
     * Finds a mode by its word.
     *
     * @param word the word of GCNP
     * @return the mode
     * @throws IllegalArgumentException if there is none
     */
    public static Mode of(String word) {
        for (Mode mode : values()) {
            if (mode.word.equals(word)) return mode;
        }
        throw new IllegalArgumentException("mode: oto, otm/stream or otm/pubsub, not '" + word + "'");
    }
}
