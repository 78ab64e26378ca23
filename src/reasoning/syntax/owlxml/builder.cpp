// The document: which elements may stand where, its head, and the stack of open elements.
#include "reasoning/syntax/owlxml/builder.hpp"

#include <algorithm>
#include <array>

#include "base/text.hpp"

namespace geminga::owlxml {
namespace {

using functional::Form;

constexpr std::string_view owl = "http://www.w3.org/2002/07/owl#";
constexpr std::string_view xml = "http://www.w3.org/XML/1998/namespace";

/// The attributes of the syntax. The functions that read an element ask for those that it needs.
constexpr std::array<std::string_view, 9> known_attributes{
    "IRI", "abbreviatedIRI", "cardinality", "datatypeIRI", "facet", "name", "nodeID", "ontologyIRI", "versionIRI"};

std::string_view value_of(std::span<const Attribute> attributes, std::string_view name, std::string_view space = {}) {
  for (const Attribute& attribute : attributes) {
    if (attribute.name == name && attribute.space == space) return attribute.value;
  }
  return {};
}

}  // namespace

Builder::Builder(std::string_view bytes, owl::FileId file, owl::Ontology& source, const XmlLimits& limits,
                 std::vector<owl::Annotation>* annotations)
    : bytes_(bytes),
      file_(file),
      source_(source),
      limits_(limits),
      annotations_(annotations),
      head_(limits.prefixes, limits.imports),
      names_(source, file) {}

Listener::Refusal Builder::begin(std::string_view space, std::string_view name, std::span<const Attribute> attributes,
                                 std::uint32_t line) {
  Open open{.line = line};
  if (!open_.empty()) open.is_annotation = open_.back().is_annotation;
  open.first = operands_.size();
  open.bases = bases_.size();
  text_.clear();
  const bool is_left_out = !open_.empty() && open_.back().role == Role::left_out;
  if (is_left_out) {
    open.role = Role::left_out;
    open_.push_back(open);
    return std::nullopt;
  }
  if (space != owl) return "expected an element of OWL, found <" + base::printable(name, 60) + '>';
  if (auto refusal = check_attributes(name, attributes)) return refusal;
  if (const std::string_view base = value_of(attributes, "base", xml); !base.empty()) {
    if (base.size() > limits_.iri_bytes) return "an IRI of more than " + std::to_string(limits_.iri_bytes) + " bytes";
    bases_.push_back(bases_.empty() ? std::string(base) : resolve(base, bases_.back()));
  }
  if (open_.empty()) {
    if (name != "Ontology") return "expected <Ontology>, found <" + base::printable(name, 60) + '>';
    open.role = Role::ontology;
    open_.push_back(open);
    return begin_ontology(attributes);
  }
  if (auto refusal = open_element(name, attributes, open)) return refusal;
  open_.push_back(open);
  return std::nullopt;
}

Listener::Refusal Builder::check_attributes(std::string_view name, std::span<const Attribute> attributes) {
  for (const Attribute& attribute : attributes) {
    if (attribute.space.empty() && std::ranges::find(known_attributes, attribute.name) == known_attributes.end())
      return "the attribute " + base::printable(attribute.name, 60) + " of <" + base::printable(name, 60) +
             "> is none of OWL/XML";
  }
  return std::nullopt;
}

Listener::Refusal Builder::begin_ontology(std::span<const Attribute> attributes) {
  const std::string_view name = value_of(attributes, "ontologyIRI");
  if (!name.empty()) {
    if (auto refusal = full_iri(name, document_.ontology_iri)) return refusal;
    source_.set_ontology_iri(file_, document_.ontology_iri);
    // The base if xml:base does not name one. The file's own IRI would differ from host to host.
    if (bases_.empty()) bases_.push_back(document_.ontology_iri);
  }
  const std::string_view version = value_of(attributes, "versionIRI");
  return version.empty() ? std::nullopt : full_iri(version, document_.version_iri);
}

Listener::Refusal Builder::begin_prefix(std::span<const Attribute> attributes) {
  std::string iri;
  if (auto refusal = full_iri(value_of(attributes, "IRI"), iri)) return refusal;
  return head_.declare(value_of(attributes, "name"), iri, document_);
}

Listener::Refusal Builder::open_element(std::string_view name, std::span<const Attribute> attributes, Open& open) {
  const bool is_top = open_.size() == 1;
  if (name == "Prefix" && is_top) {
    open.role = Role::prefix;
    return begin_prefix(attributes);
  }
  if (name == "Literal") {
    open.role = Role::literal;
    literal_language_ = value_of(attributes, "lang", xml);
    literal_datatype_.clear();
    const std::string_view datatype = value_of(attributes, "datatypeIRI");
    return datatype.empty() ? std::nullopt : full_iri(datatype, literal_datatype_);
  }
  if (name == "FacetRestriction") {
    open.role = Role::facet;
    return full_iri(value_of(attributes, "facet"), facet_iri_);
  }
  if (name == "IRI" || name == "AbbreviatedIRI") {
    open.role = name == "IRI" ? Role::iri : Role::short_iri;
    return std::nullopt;
  }
  if (name == "AnonymousIndividual") {
    open.role = Role::blank;
    return blank(open, attributes);
  }
  open.production = functional::find_production(name);
  const Form form = form_of(open);
  if (form == Form::document) return "<" + base::printable(name, 60) + "> is no element of OWL/XML";
  const bool is_outermost = form >= Form::axiom || form == Form::import;
  if (is_outermost != is_top && form != Form::annotation)
    return is_top ? "expected an axiom, found <" + std::string(name) + '>'
                  : "the axiom <" + std::string(name) + "> within another element";
  if (is_top) {
    obstacle_ = nullptr;
    names_.forget_cost();
    annotations_.begin();
  }
  switch (form) {
    case Form::extension:
      open.role = Role::left_out;
      source_.leave_out(name, file_, open.line);
      return std::nullopt;
    case Form::variable:
    case Form::built_in:
      return named_part(open, attributes);
    case Form::annotation:
    case Form::annotation_assertion:
    case Form::annotation_axiom:
      open.is_annotation = true;
      return std::nullopt;
    case Form::entity:
      return entity(open, attributes);
    default:
      break;
  }
  if (!open.production->is_counted) return std::nullopt;
  std::string_view digits = value_of(attributes, "cardinality");
  if (digits.empty() || digits.find_first_not_of("0123456789") != std::string_view::npos)
    return "expected a number as the cardinality of <" + std::string(name) + '>';
  digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size() - 1));
  const auto number = base::parse_number<std::uint32_t>(digits);
  if (!number) obstacle_ = "a cardinality above 4294967295";
  open.number = number.value_or(0);
  return std::nullopt;
}

Listener::Refusal Builder::text(std::string_view part) {
  const Open* open = open_.empty() ? nullptr : &open_.back();
  const bool is_import = open != nullptr && form_of(*open) == Form::import;
  const bool may_have_text = open != nullptr && (open->role == Role::literal || open->role == Role::iri ||
                                                 open->role == Role::short_iri || is_import);
  if (may_have_text) {
    if (text_.size() + part.size() > limits_.literal_bytes)
      return "a text of more than " + std::to_string(limits_.literal_bytes) + " bytes";
    text_ += part;
    return std::nullopt;
  }
  const bool is_passed_over = open != nullptr && open->role == Role::left_out;
  if (is_passed_over || base::trimmed(part).empty()) return std::nullopt;
  return "text that stands in no <Literal>: " + base::printable(base::trimmed(part), 60);
}

Listener::Refusal Builder::end() {
  const Open open = open_.back();
  open_.pop_back();
  if (operands_.size() - open.first > limits_.operands)
    return "more than " + std::to_string(limits_.operands) + " operands";
  // An entity and a blank node are operands from their start tag on.
  const bool is_leaf = open.role == Role::blank || form_of(open) == Form::entity;
  const bool is_empty = operands_.size() == open.first + (is_leaf ? 1 : 0);
  const bool must_be_empty = is_leaf || open.role == Role::prefix || form_of(open) == Form::import;
  if (must_be_empty && !is_empty) return "an element where none may stand";
  Refusal refusal;
  switch (open.role) {
    case Role::literal:
      refusal = end_literal(open);
      break;
    case Role::facet:
      refusal = end_facet(open);
      break;
    case Role::iri:
    case Role::short_iri:
      refusal = end_iri(open);
      break;
    case Role::production:
      switch (form_of(open)) {
        case Form::import:
          refusal = end_import(open);
          break;
        case Form::annotation:
          refusal = end_annotation(open);
          break;
        case Form::expression:
        case Form::n_ary_data:
          refusal = end_expression(open);
          break;
        case Form::variable:
        case Form::built_in:
        case Form::atoms:
          refusal = end_part_of_rule(open);
          break;
        case Form::entity:
          break;
        default:
          refusal = end_axiom(open);
          break;
      }
      break;
    default:
      break;
  }
  // The base that begin_ontology() sets stays until the end.
  if (open.role != Role::ontology) bases_.resize(std::min(bases_.size(), open.bases));
  text_.clear();
  return refusal;
}

Listener::Refusal Builder::end_import(const Open& open) {
  std::string iri;
  if (auto refusal = full_iri(base::trimmed(text_), iri)) return refusal;
  return head_.import(iri, open.line, document_);
}

}  // namespace geminga::owlxml
