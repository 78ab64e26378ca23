// Annotations: checked in full, used for labels, and otherwise counted.
#include <utility>

#include "reasoning/syntax/frames/parser.hpp"

namespace geminga::frames {
namespace {

constexpr std::string_view rdfs_label = "http://www.w3.org/2000/01/rdf-schema#label";
constexpr std::string_view skos_pref_label = "http://www.w3.org/2004/02/skos/core#prefLabel";

}  // namespace

// annotations = "Annotations:" list, before what is annotated
void Parser::annotations() {
  if (annotation_depth_ == 0) annotations_.begin();
  while (!failed() && is_section("Annotations:")) {
    take();
    annotation_list({});
  }
}

// The same as a section of its own. OWL tools also write it without any member.
void Parser::own_annotations(std::string_view subject) {
  take();
  annotations_.begin();
  if (is_name() || is_section("Annotations:")) annotation_list(subject);
  if (subject.empty()) annotations_.drop();  // of an expression
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
    if (annotation_depth_ == 1) cost_.clear();
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
  owl::Annotation read = owl::annotation_of(std::string(subject), property);
  read.number = static_cast<std::uint32_t>(file_);
  if (subject == of_ontology) {
    read.of = owl::Annotation::Of::ontology;
    read.subject.clear();
  }
  if (is_literal()) {
    const std::uint32_t line = this->line();
    const bool is_text = tokens_.token().kind == manchester::TokenKind::string;
    const Term value = literal();
    if (failed()) return;
    if (!is_text) {  // a number, true or false
      const owl::Term written = source_.term(value);
      last_text_ = source_.name(written.name);
      last_datatype_ = source_.name_of(written.arguments[0]);
      last_language_.clear();
    }
    const bool is_label = property == rdfs_label || property == skos_pref_label;
    const bool is_of_name = !read.subject.empty() && !subject.starts_with("_:");
    if (is_label && is_text && is_of_name) source_.add_label(subject, last_text_, last_language_);
    if (property == owl::conversion_cost) {
      cost_ = last_text_;
      cost_line_ = line;
      if (!read.subject.empty()) source_.leave_out(owl::cost_of_nothing, file_, line);
    } else if (property == owl::converts_to) {
      source_.leave_out(owl::conversion_to_literal, file_, line);
    }
    if (is_of_name) source_.add_unit_statement(subject, owl::unit_word(property), last_text_, file_, line);
    if (!annotations_.is_wanted()) return;
    read.is_literal = true;
    read.value = last_text_;
    read.datatype = last_datatype_;
    read.language = last_language_;
  } else if (is_name() && tokens_.token().text.starts_with("_:")) {
    if (property == owl::converts_to) source_.leave_out(owl::conversion_without_name, file_, line());
    read.value = source_.name_of(individual());
  } else {
    const std::uint32_t line = this->line();
    read.value = iri("an IRI, a blank node or a literal");
    const bool is_of_name = !read.subject.empty() && !subject.starts_with("_:");
    if (!failed() && property == owl::converts_to && is_of_name) {
      source_.add_conversion(subject, read.value, cost_, file_, line, cost_line_);
    } else if (property == owl::converts_to) {
      source_.leave_out(owl::conversion_without_name, file_, line);
    }
    if (!failed() && is_of_name) {
      source_.add_unit_statement(subject, owl::unit_word(property), read.value, file_, line);
    }
  }
  if (!failed()) annotations_.add(std::move(read), annotation_depth_);
}

void Parser::annotation_axiom(std::string_view subject, std::string_view word, std::string object) {
  if (failed()) return;
  ++document_.annotations;
  const std::string of = "AnnotationProperty" + std::string(word.substr(0, word.size() - 1));
  owl::Annotation read = owl::annotation_of(std::string(subject), owl::property_of_annotation_axiom(of));
  read.value = std::move(object);
  annotations_.add(std::move(read), 0);
}

}  // namespace geminga::frames
