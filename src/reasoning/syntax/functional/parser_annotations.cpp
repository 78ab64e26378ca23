// Annotations: read to the letter, used for labels, and otherwise counted.
#include <utility>

#include "reasoning/owl/unit.hpp"
#include "reasoning/syntax/functional/parser.hpp"

namespace geminga::functional {
namespace {

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
  if (is_read && is_cost && kind == TokenKind::string) names_.set_cost(lexical_, line);
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
  const bool is_of_interest = document::NameAnnotations::is_of_interest(iri_);
  const bool is_kept = is_of_interest || annotations_.is_wanted();
  const std::uint32_t line = tokens_.line();
  std::string property(is_kept ? iri_ : std::string_view());
  std::string subject;
  if (is_name()) {
    if (!iri("an IRI")) return false;
    if (is_kept) subject = iri_;
  } else {
    if (tokens_.is(TokenKind::node_id) && is_kept) subject = blank_name(tokens_.token().text);
    if (!expect(TokenKind::node_id, "an IRI or a blank node")) return false;
  }
  const TokenKind value = tokens_.token().kind;
  if (!annotation_value()) return false;
  if (is_of_interest) {
    using ValueForm = document::AnnotationValue::Form;
    const bool is_text = value == TokenKind::string;
    const ValueForm form = is_text ? ValueForm::text : value == TokenKind::node_id ? ValueForm::blank : ValueForm::iri;
    names_.add(property, subject, {form, is_text ? lexical_ : iri_, language_}, line);
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
