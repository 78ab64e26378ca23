package geminga;

import java.util.Locale;

/** Degrees of match between an offered identity and a requested one, the best first. */
public enum Degree {
    /** The same identity. */
    EXACT,
    /** Another name of the same class. */
    EQUIVALENT,
    /** A class below the requested one. */
    NARROWER,
    /** The concept matches, and the representation can be converted into the requested one. */
    CONVERTED,
    /** A class above the requested one. */
    BROADER,
    /** Neither class is below the other, and something can be in both. The weakest degree. */
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
     * @throws IllegalArgumentException if there is none
     */
    public static Degree of(String word) {
        for (Degree degree : values()) {
            if (degree.word().equals(word)) return degree;
        }
        throw new IllegalArgumentException("no degree of match: '" + word + "'");
    }
}
