// Annotations: read to the letter, used for labels, and otherwise counted.
#include <utility>

#include "reasoning/syntax/functional/parser.hpp"

namespace geminga::functional {
namespace {

constexpr std::string_view rdfs_label = "http://www.w3.org/2000/01/rdf-schema#label";
constexpr std::string_view skos_pref_label = "http://www.w3.org/2004/02/skos/core#prefLabel";
constexpr std::string_view property_name = "the name of an annotation property";

}  // namespace

bool Parser::annotations() {
  while (tokens_.is(TokenKind::word) && tokens_.token().text == "Annotation") {
    if (!annotation()) return false;
  }
  return true;
}

bool Parser::annotation() {
  if (!descend()) return false;
  tokens_.advance();
  bool is_read = expect(TokenKind::open, "'(' behind Annotation") && annotations() && iri(property_name);
  std::string property(annotations_.is_wanted() && is_read ? iri_ : std::string_view());
  const bool is_cost = is_read && iri_ == owl::conversion_cost;
  const TokenKind kind = tokens_.token().kind;
  const std::uint32_t line = tokens_.line();
  is_read = is_read && annotation_value();
  if (is_read && is_cost && kind == TokenKind::string) {
    cost_ = lexical_;
    cost_line_ = line;
  }
  if (is_read && annotations_.is_wanted()) {
    owl::Annotation read = owl::annotation_of({}, std::move(property));
    if (is_of_ontology_ && depth_ == 1) {
      read.of = owl::Annotation::Of::ontology;
      read.number = static_cast<std::uint32_t>(file_);
    }
    keep(std::move(read), kind, depth_);
  }
  is_read = is_read && expect(TokenKind::close, "')' behind the annotation");
  --depth_;
  ++document_.annotations;
  return is_read;
}

void Parser::keep(owl::Annotation annotation, TokenKind value, std::size_t level) {
  annotation.is_literal = value == TokenKind::string;
  annotation.value = annotation.is_literal ? lexical_ : iri_;
  if (annotation.is_literal) {
    annotation.datatype = iri_;
    annotation.language = language_;
  }
  annotations_.add(std::move(annotation), level);
}

bool Parser::annotation_value() {
  if (tokens_.is(TokenKind::string)) return literal();
  if (is_name()) return iri("an IRI");
  if (tokens_.is(TokenKind::node_id) && annotations_.is_wanted()) iri_ = blank_name(tokens_.token().text);
  return expect(TokenKind::node_id, "an IRI, a blank node or a literal");
}

bool Parser::annotation_assertion() {
  if (!iri(property_name)) return false;
  const bool is_label = iri_ == rdfs_label || iri_ == skos_pref_label;
  const bool is_conversion = iri_ == owl::converts_to;
  const owl::UnitWord unit_word = owl::unit_word(iri_);
  const bool is_of_unit = unit_word != owl::UnitWord::none;
  const bool is_cost = iri_ == owl::conversion_cost;
  const std::uint32_t line = tokens_.line();
  std::string property(annotations_.is_wanted() ? iri_ : std::string_view());
  std::string subject;
  const bool is_of_blank = tokens_.is(TokenKind::node_id);
  if (is_name()) {
    if (!iri("an IRI")) return false;
    if (is_label || is_conversion || is_of_unit || annotations_.is_wanted()) subject = iri_;
  } else {
    if (is_of_blank && annotations_.is_wanted()) subject = blank_name(tokens_.token().text);
    if (!expect(TokenKind::node_id, "an IRI or a blank node")) return false;
  }
  const TokenKind value = tokens_.token().kind;
  if (!annotation_value()) return false;
  if (is_label && !is_of_blank && value == TokenKind::string) source_.add_label(subject, lexical_, language_);
  const bool is_name_value = value == TokenKind::full_iri || value == TokenKind::prefixed_name;
  if (is_conversion && !is_of_blank && is_name_value) {
    source_.add_conversion(subject, iri_, cost_, file_, line, cost_line_);
  } else if (is_conversion) {
    const bool has_literal = value == TokenKind::string;
    source_.leave_out(has_literal ? owl::conversion_to_literal : owl::conversion_without_name, file_, line);
  } else if (is_cost) {
    source_.leave_out(owl::cost_of_nothing, file_, line);
  }
  if (is_of_unit && !is_of_blank && value != TokenKind::node_id) {
    source_.add_unit_statement(subject, unit_word, value == TokenKind::string ? lexical_ : iri_, file_, line);
  }
  if (annotations_.is_wanted()) keep(owl::annotation_of(std::move(subject), std::move(property)), value, 0);
  return true;
}

bool Parser::annotation_axiom(std::string_view word) {
  if (!iri(property_name)) return false;
  std::string subject(iri_);
  if (!iri("an IRI")) return false;
  if (annotations_.is_wanted())
    keep(owl::annotation_of(std::move(subject), owl::property_of_annotation_axiom(word)), TokenKind::full_iri, 0);
  return true;
}

}  // namespace geminga::functional
