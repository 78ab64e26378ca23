#include "ontology/loading/class_expressions.hpp"

#include <utility>

#include "base/text.hpp"
#include "ontology/command/words.hpp"
#include "ontology/loading/class_names.hpp"
#include "reasoning/owl/print.hpp"

namespace geminga::ontology {

std::optional<manchester::Expression> read_expression_or_say(const compiled::Ontology& ontology,
                                                             const owl::Names& names, const std::string& text,
                                                             bool as_json) {
  // A label may hold words that are operators of an expression.
  if (find_class(ontology, text) || !manchester::is_compound(text)) {
    const auto number = find_or_say(ontology, text, as_json);
    if (!number) return std::nullopt;
    manchester::Expression expression;
    expression.term = expression.source.named_class(ontology.iri(*number));
    return expression;
  }
  auto expression = manchester::parse(text, names);
  if (expression) return std::move(*expression);
  say_failure("'" + base::printable(text) + "': " + to_string(expression.error()), as_json);
  return std::nullopt;
}

std::optional<taxonomy::ClassNumber> class_of(const compiled::Ontology& ontology,
                                              const manchester::Expression& expression) {
  if (expression.source.kind(expression.term) != owl::TermKind::named_class) return std::nullopt;
  return ontology.find_iri(expression.source.name_of(expression.term));
}

std::string define_class(owl::Ontology& source, std::string_view name, owl::TermId expression, owl::FileId file) {
  std::string iri = source.unused_name(name);
  source.add(owl::AxiomKind::equivalent_classes, {source.named_class(iri), expression}, file, 0);
  return iri;
}

std::string words_of(const compiled::Ontology& ontology, const manchester::Expression& expression) {
  return owl::print(expression.source, expression.term, [&](std::string_view iri) { return ontology.short_name(iri); });
}

}  // namespace geminga::ontology
