package geminga;

import geminga.protocol.Xxh32;
import java.nio.charset.StandardCharsets;
import java.util.Objects;

/** The identity of a service: a number, a text, or a concept, perhaps with a representation. Identities of different kinds never match. */
public sealed interface Identity {
    /**
     * A number as identity.
     *
     * @param value 0 to 4294967295
     */
    record Number(long value) implements Identity {
        /**
         * Checks the range.
         *
         * @param value 0 to 4294967295
         */
        public Number {
            if (value < 0 || value > 0xFFFF_FFFFL) throw new IllegalArgumentException("id: 0 to 4294967295, not " + value);
        }

        @Override
        public long id32() {
            return value;
        }
    }

    /**
     * A text, compared octet by octet.
     *
     * @param value 1 to 255 octets of UTF-8
     */
    record Text(String value) implements Identity {
        /**
         * Checks the length.
         *
         * @param value 1 to 255 octets of UTF-8
         */
        public Text {
            int octets = value.getBytes(StandardCharsets.UTF_8).length;
            if (octets == 0 || octets > 255) throw new IllegalArgumentException("text: 1 to 255 octets, not " + octets);
        }

        @Override
        public long id32() {
            return hash(value);
        }
    }

    /**
     * A concept of the ontology, and in a request a class expression in Manchester syntax as well.
     *
     * @param name {@code prefix:Name}, {@code <IRI>}, a label, or an expression
     * @param representation the form of the data, written like the name; empty for none
     */
    record Concept(String name, String representation) implements Identity {
        /**
         * Checks that there is a name, and the lengths.
         *
         * @param name {@code prefix:Name}, {@code <IRI>}, a label, or an expression
         * @param representation the same; empty for none
         */
        public Concept {
            Objects.requireNonNull(representation);
            if (name.isEmpty()) throw new IllegalArgumentException("concept: a name is missing");
            if (name.getBytes(StandardCharsets.UTF_8).length > 1024 || representation.getBytes(StandardCharsets.UTF_8).length > 1024) {
                throw new IllegalArgumentException("concept, representation: at most 1024 octets each");
            }
        }

        @Override
        public long id32() {
            boolean isIri = isIri(name);
            if (!isIri && name.indexOf('<') < 0 || !representation.isEmpty() && !isIri(representation)) {
                throw new IllegalStateException("only the daemon knows the IRI of a short name: write <IRI>");
            }
            return hash((isIri ? name : '(' + name + ')') + representation);
        }

        private static boolean isIri(String name) {
            return name.length() > 2 && name.charAt(0) == '<' && name.indexOf('>') == name.length() - 1;
        }
    }

    /**
     * A number as an identity.
     *
     * @param value 0 to 4294967295
     * @return the identity
     */
    static Identity number(long value) {
        return new Number(value);
    }

    /**
     * A text as an identity.
     *
     * @param value 1 to 255 octets of UTF-8
     * @return the identity
     */
    static Identity text(String value) {
        return new Text(value);
    }

    /**
     * A concept without a representation.
     *
     * @param name {@code prefix:Name}, {@code <IRI>}, a label, or in a request a class expression
     * @return the identity
     */
    static Identity concept(String name) {
        return new Concept(name, "");
    }

    /**
     * A concept in one representation.
     *
     * @param name {@code prefix:Name}, {@code <IRI>}, a label, or in a request a class expression
     * @param representation another class, written in the same ways
     * @return the identity
     */
    static Identity concept(String name, String representation) {
        return new Concept(name, representation);
    }

    /**
     * The 32-bit form (src/identity/IDENTITY.md), the same in every language.
     *
     * @return 0 to 4294967295
     * @throws IllegalStateException for a concept with short names, because only the daemon knows their IRIs
     */
    long id32();

    private static long hash(String form) {
        return Integer.toUnsignedLong(Xxh32.hash(form.getBytes(StandardCharsets.UTF_8)));
    }
}
