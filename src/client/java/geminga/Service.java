package geminga;

import geminga.protocol.Words;
import java.util.Map;

/** The words of GCNP that offers and requests have alike. Functions that give another offer or request stand in each of the two, since a program that is compiled finds them by their result. */
abstract sealed class Service permits Offer, Request {
    final Words words;

    Service(Words words) {
        this.words = words;
    }

    static Words stated(Words words, Mode mode, Identity identity) {
        Words stated = words.with("mode", mode.word());
        if (identity instanceof Identity.Number number) return stated.with("id", Long.toString(number.value()));
        if (identity instanceof Identity.Text text) return stated.with("text", text.value());
        Identity.Concept named = (Identity.Concept) identity;
        return stated.with("concept", named.name()).with("representation", named.representation());
    }

    /** {@return the mode} */
    public Mode mode() {
        return Mode.of(words.get("mode"));
    }

    /** {@return the identity that is offered or requested} */
    public Identity identity() {
        if (!words.get("id").isEmpty()) return Identity.number(Long.parseLong(words.get("id")));
        if (!words.get("text").isEmpty()) return Identity.text(words.get("text"));
        return Identity.concept(words.get("concept"), words.get("representation"));
    }

    /** {@return the port of the channel, which a consumer has over UDP only; 0 for any} */
    public int port() {
        return words.get("port").isEmpty() ? 0 : Integer.parseInt(words.get("port"));
    }

    /** {@return the address in numbers, empty for each interface's own} */
    public String address() {
        return words.get("address");
    }

    /** {@return the attributes by their names} */
    public Map<String, String> attributes() {
        return words.attributes();
    }

    /** {@return all of it as {@code pub create} or {@code sub create} states it, in the order of GCNP} */
    public Map<String, String> parameters() {
        return words.parameters();
    }

    @Override
    public int hashCode() {
        return words.hashCode();
    }

    @Override
    public String toString() {
        return parameters().toString();
    }
}
