// Annotations: read to the letter, used for labels, and otherwise counted.
#include <utility>

#include "frames/parser.hpp"

namespace geminga::frames {
namespace {

constexpr std::string_view rdfs_label = "http://www.w3.org/2000/01/rdf-schema#label";
constexpr std::string_view skos_pref_label = "http://www.w3.org/2004/02/skos/core#prefLabel";

}  // namespace

// annotations = "Annotations:" list, before what is annotated
void Parser::annotations() {
  while (!failed() && is_section("Annotations:")) {
    take();
    annotation_list({});
  }
}

// The same as a section of its own. OWL tools write it without any, too.
void Parser::own_annotations(std::string_view subject) {
  take();
  if (is_name() || is_section("Annotations:")) annotation_list(subject);
}

// list = annotations annotation *( "," annotations annotation )
void Parser::annotation_list(std::string_view subject) {
  if (annotation_depth_ >= frame_limits_.annotation_levels) {
    fail(manchester::ParseError::Kind::too_large, tokens_.token().begin,
         "more than " + std::to_string(frame_limits_.annotation_levels) + " levels of annotations");
    return;
  }
  ++annotation_depth_;
  do {
    parts_ = 0;
    if (is_section("Annotations:")) annotations();
    annotation(subject);
  } while (!failed() && take_comma());
  --annotation_depth_;
}

// annotation = property ( literal / iri / blank node )
void Parser::annotation(std::string_view subject) {
  if (failed()) return;
  const std::string property = iri("the name of an annotation property");
  if (failed()) return;
  ++document_.annotations;
  if (is_literal()) {
    const bool is_text = tokens_.token().kind == manchester::TokenKind::string;
    const Term value = literal();
    if (!failed() && !is_text) {  // a number, true or false
      const el::Term written = source_.term(value);
      last_text_ = source_.name(written.name);
      last_datatype_ = source_.name_of(written.arguments[0]);
      last_language_.clear();
    }
    const bool is_label = property == rdfs_label || property == skos_pref_label;
    if (failed() || subject.empty()) return;
    if (is_label && is_text) source_.add_label(subject, last_text_, last_language_);
    if (annotations_ != nullptr)
      annotations_->push_back({std::string(subject), property, true, last_text_, last_datatype_, last_language_});
  } else if (is_name() && tokens_.token().text.starts_with("_:")) {
    take();
  } else {
    std::string value = iri("an IRI, a blank node or a literal");
    if (!failed() && annotations_ != nullptr && !subject.empty())
      annotations_->push_back({std::string(subject), property, false, std::move(value), {}, {}});
  }
}

}  // namespace geminga::frames
