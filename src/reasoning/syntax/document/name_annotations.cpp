#include "reasoning/syntax/document/name_annotations.hpp"

#include "reasoning/owl/conversion.hpp"
#include "reasoning/owl/outside_names.hpp"
#include "reasoning/owl/unit.hpp"

namespace geminga::document {
namespace {

using Form = AnnotationValue::Form;

bool is_label(std::string_view property) {
  return property == "http://www.w3.org/2000/01/rdf-schema#label" ||
         property == "http://www.w3.org/2004/02/skos/core#prefLabel" || owl::is_outside_name(property);
}

}  // namespace

bool NameAnnotations::is_of_interest(std::string_view property) {
  return is_label(property) || property == owl::converts_to || property == owl::conversion_cost ||
         owl::unit_word(property) != owl::UnitWord::none;
}

void NameAnnotations::add(std::string_view property, std::string_view subject, const AnnotationValue& value,
                          std::uint32_t line) {
  const bool has_name = !subject.empty() && !subject.starts_with("_:");
  if (property == owl::converts_to) return add_conversion(subject, has_name, value, line);
  if (property == owl::conversion_cost) return source_.leave_out(owl::cost_of_nothing, file_, line);
  if (!has_name) return;
  if (is_label(property) && value.form == Form::text) source_.add_label(subject, value.text, value.language);
  if (value.form != Form::blank) source_.add_unit_statement(subject, owl::unit_word(property), value.text, file_, line);
}

void NameAnnotations::add_conversion(std::string_view subject, bool has_name, const AnnotationValue& value,
                                     std::uint32_t line) {
  if (has_name && value.form == Form::iri)
    return source_.add_conversion(subject, value.text, cost_, file_, line, cost_line_);
  const bool has_literal = value.form == Form::text || value.form == Form::number;
  source_.leave_out(has_literal ? owl::conversion_to_literal : owl::conversion_without_name, file_, line);
}

void NameAnnotations::set_cost(std::string_view cost, std::uint32_t line) {
  cost_ = cost;
  cost_line_ = line;
}

}  // namespace geminga::document
