package geminga;

import geminga.protocol.Words;

/** Mode and identity in the words of GCNP, which offers and requests share. */
final class IdentityWords {
    private IdentityWords() {}

    static Words state(Words words, Mode mode, Identity identity) {
        Words stated = words.with("mode", mode.word());
        if (identity instanceof Identity.Number number) return stated.with("id", Long.toString(number.value()));
        if (identity instanceof Identity.Text text) return stated.with("text", text.value());
        Identity.Concept named = (Identity.Concept) identity;
        return stated.with("concept", named.name()).with("representation", named.representation());
    }

    static Identity read(Words words) {
        if (!words.get("id").isEmpty()) return Identity.number(Long.parseLong(words.get("id")));
        if (!words.get("text").isEmpty()) return Identity.text(words.get("text"));
        return Identity.concept(words.get("concept"), words.get("representation"));
    }
}
