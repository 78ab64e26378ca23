// Annotations: checked in full, used for labels, and otherwise counted.
#include <utility>

#include "reasoning/owl/unit.hpp"
#include "reasoning/syntax/frames/parser.hpp"

namespace geminga::frames {

using Form = document::AnnotationValue::Form;

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
    if (annotation_depth_ == 1) names_.forget_cost();
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
    const bool is_cost = property == owl::conversion_cost;
    if (is_cost) names_.set_cost(last_text_, line);
    // The cost of a conversion annotates that annotation and no name.
    if (!is_cost || !read.subject.empty())
      names_.add(property, read.subject, {is_text ? Form::text : Form::number, last_text_, last_language_}, line);
    if (!annotations_.is_wanted()) return;
    read.is_literal = true;
    read.value = last_text_;
    read.datatype = last_datatype_;
    read.language = last_language_;
  } else if (is_name() && tokens_.token().text.starts_with("_:")) {
    if (property == owl::converts_to) names_.add(property, read.subject, {.form = Form::blank}, line());
    read.value = source_.name_of(individual());
  } else {
    const std::uint32_t line = this->line();
    read.value = iri("an IRI, a blank node or a literal");
    if (!failed() && property != owl::conversion_cost)
      names_.add(property, read.subject, {.form = Form::iri, .text = read.value}, line);
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
