// Annotations: read to the letter, used for labels, and otherwise counted.
#include "functional/parser.hpp"

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
  const std::string property(annotations_ != nullptr && is_read ? iri_ : std::string_view());
  const TokenKind kind = tokens_.token().kind;
  is_read = is_read && annotation_value();
  if (is_read && is_of_ontology_ && depth_ == 1 && kind != TokenKind::node_id)
    keep(document_.ontology_iri, property, kind == TokenKind::string);
  is_read = is_read && expect(TokenKind::close, "')' behind the annotation");
  --depth_;
  ++document_.annotations;
  return is_read;
}

void Parser::keep(const std::string& subject, const std::string& property, bool is_literal) {
  if (annotations_ == nullptr || subject.empty()) return;
  if (is_literal) {
    annotations_->push_back(
        {subject, property, true, std::string(lexical_), std::string(iri_), std::string(language_)});
  } else {
    annotations_->push_back({subject, property, false, std::string(iri_), {}, {}});
  }
}

bool Parser::annotation_value() {
  if (tokens_.is(TokenKind::string)) return literal();
  if (is_name()) return iri("an IRI");
  return expect(TokenKind::node_id, "an IRI, a blank node or a literal");
}

bool Parser::annotation_assertion() {
  if (!iri(property_name)) return false;
  const bool is_label = iri_ == rdfs_label || iri_ == skos_pref_label;
  const std::string property(annotations_ != nullptr ? iri_ : std::string_view());
  std::string subject;
  if (is_name()) {
    if (!iri("an IRI")) return false;
    if (is_label || annotations_ != nullptr) subject = iri_;
  } else if (!expect(TokenKind::node_id, "an IRI or a blank node")) {
    return false;
  }
  const bool is_text = tokens_.is(TokenKind::string);
  const bool is_blank = tokens_.is(TokenKind::node_id);
  if (!annotation_value()) return false;
  if (!is_blank) keep(subject, property, is_text);
  if (is_label && !subject.empty() && is_text) source_.add_label(subject, lexical_, language_);
  return true;
}

}  // namespace geminga::functional
