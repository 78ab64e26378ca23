package geminga;

import java.util.Locale;

/** How what is offered stands to what was asked for, the best first. */
public enum Degree {
    /** The same identity. */
    EXACT,
    /** Another name of the same class. */
    EQUIVALENT,
    /** A class below the one that was asked for. */
    NARROWER,
    /** The concept is right and the representation is turned into the one that was asked for. */
    CONVERTED,
    /** A class above the one that was asked for. */
    BROADER,
    /** Neither is below the other, and something can be both; the weakest. */
    OVERLAPPING;

    /** {@return the word of GCNP} */
    public String word() {
        return name().toLowerCase(Locale.ROOT);
    }

    /**
     * Finds a degree by its word.
     *
     * @param word the word of GCNP
     * @return the degree
     * @throws IllegalArgumentException where there is none
     */
    public static Degree of(String word) {
        for (Degree degree : values()) {
            if (degree.word().equals(word)) return degree;
        }
        throw new IllegalArgumentException("no degree of match: '" + word + "'");
    }
}
