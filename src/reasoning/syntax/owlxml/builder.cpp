// The document: which elements may stand where, its head, and the stack of open elements.
#include "reasoning/syntax/owlxml/builder.hpp"

#include <algorithm>
#include <array>

#include "base/text.hpp"
#include "reasoning/owl/loaded_file.hpp"
#include "reasoning/syntax/base_iri.hpp"
#include "reasoning/syntax/count.hpp"

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
  open.annotations = annotations_.place();
  text_.clear();
  const bool is_passed_over = fault_ || (!open_.empty() && open_.back().role == Role::left_out);
  if (is_passed_over) {
    open.role = Role::left_out;
    open_.push_back(open);
    return std::nullopt;
  }
  if (open_.empty()) {
    if (name != "Ontology") return "expected <Ontology>, found <" + base::printable(name, 60) + '>';
    if (space != owl) remark("an Ontology in another namespace than OWL's, read as OWL/XML", line);
    space_ = space;
    open.role = Role::ontology;
  }
  Refusal refusal = begin_element(space, name, attributes, open);
  open_.push_back(open);
  return settle(std::move(refusal), line);
}

Listener::Refusal Builder::begin_element(std::string_view space, std::string_view name,
                                         std::span<const Attribute> attributes, Open& open) {
  if (space != owl && space != space_) return "<" + base::printable(name, 60) + "> is no element of OWL/XML";
  for (const Attribute& attribute : attributes) {
    if (attribute.space.empty() && std::ranges::find(known_attributes, attribute.name) == known_attributes.end())
      remark("an attribute that OWL/XML does not have", open.line);
    if (attribute.space != xml || attribute.name != "base") continue;
    if (attribute.value.size() > limits_.iri_bytes)
      return beyond_limit("an IRI of more than " + std::to_string(limits_.iri_bytes) + " bytes");
    bases_.emplace_back(attribute.value);
  }
  if (open.role == Role::ontology) return begin_ontology(attributes, open.line);
  return open_element(name, attributes, open);
}

Listener::Refusal Builder::begin_ontology(std::span<const Attribute> attributes, std::uint32_t line) {
  const auto read = [&](std::string_view attribute, std::string& iri) -> Refusal {
    const std::string_view written = value_of(attributes, attribute);
    Refusal refusal = written.empty() ? std::nullopt : full_iri(written, iri);
    if (!refusal || is_beyond_limit_) return refusal;
    remark("an ontologyIRI or versionIRI with a character that no IRI has", line);
    iri.clear();
    return std::nullopt;
  };
  if (auto refusal = read("ontologyIRI", document_.ontology_iri)) return refusal;
  if (!document_.ontology_iri.empty()) source_.set_ontology_iri(file_, document_.ontology_iri);
  // The base where xml:base names none. The place of the file would differ from host to host.
  const std::string& path = source_.files()[static_cast<std::size_t>(file_)].path;
  if (bases_.empty())
    bases_.push_back(document_.ontology_iri.empty() ? syntax::base_iri(path) : document_.ontology_iri);
  return read("versionIRI", document_.version_iri);
}

Listener::Refusal Builder::begin_prefix(std::span<const Attribute> attributes, std::uint32_t line) {
  const std::string_view iri = value_of(attributes, "IRI");
  std::string_view name = value_of(attributes, "name");
  if (name.ends_with(':')) name.remove_suffix(1);
  if (iri.size() > limits_.iri_bytes || name.size() > limits_.iri_bytes)
    return beyond_limit("an IRI of more than " + std::to_string(limits_.iri_bytes) + " bytes");
  const std::string* known = head_.iri_of(name);
  if (known != nullptr && *known != iri) {
    remark("a prefix with several IRIs, of which the last is used", line);
    head_.change(name, iri, document_);
    return std::nullopt;
  }
  auto refusal = head_.declare(name, iri, document_);
  return refusal ? beyond_limit(std::move(*refusal)) : std::nullopt;
}

bool Builder::is_leaf(std::string_view name) {
  constexpr auto leaves =
      std::to_array<std::string_view>({"Literal", "FacetRestriction", "IRI", "AbbreviatedIRI", "AnonymousIndividual"});
  return std::ranges::find(leaves, name) != leaves.end();
}

Listener::Refusal Builder::open_leaf(std::string_view name, std::span<const Attribute> attributes, Open& open) {
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
  if (name == "AnonymousIndividual") {
    open.role = Role::blank;
    return blank(open, attributes);
  }
  open.role = name == "IRI" ? Role::iri : Role::short_iri;
  return std::nullopt;
}

Listener::Refusal Builder::open_element(std::string_view name, std::span<const Attribute> attributes, Open& open) {
  const bool is_top = open_.size() == 1;
  if (name == "Prefix" && is_top) {
    open.role = Role::prefix;
    return begin_prefix(attributes, open.line);
  }
  if (is_leaf(name)) return open_leaf(name, attributes, open);
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
  return open_production(name, attributes, open);
}

Listener::Refusal Builder::open_production(std::string_view name, std::span<const Attribute> attributes, Open& open) {
  switch (form_of(open)) {
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
      return open.production->is_counted ? cardinality(name, attributes, open) : std::nullopt;
  }
}

Listener::Refusal Builder::cardinality(std::string_view name, std::span<const Attribute> attributes, Open& open) {
  const auto count = syntax::read_count(value_of(attributes, "cardinality"));
  if (!count && count.error() == syntax::CountFault::not_a_count)
    return "expected a number as the cardinality of <" + std::string(name) + '>';
  if (!count) obstacle_ = "a cardinality above 4294967295";
  open.number = count.value_or(0);
  return std::nullopt;
}

Listener::Refusal Builder::text(std::string_view part, std::uint32_t /*line*/) {
  const Open* open = open_.empty() ? nullptr : &open_.back();
  const bool is_import = open != nullptr && form_of(*open) == Form::import;
  const bool may_have_text = open != nullptr && (open->role == Role::literal || open->role == Role::iri ||
                                                 open->role == Role::short_iri || is_import);
  if (may_have_text) {
    if (text_.size() + part.size() > limits_.literal_bytes)
      return beyond_limit("a text of more than " + std::to_string(limits_.literal_bytes) + " bytes");
    text_ += part;
    return std::nullopt;
  }
  const bool is_passed_over = fault_ || (open != nullptr && open->role == Role::left_out);
  if (open != nullptr && !is_passed_over && !base::trimmed(part).empty())
    remark("text that stands in no <Literal>", open->line);
  return std::nullopt;
}

Listener::Refusal Builder::end(std::uint32_t /*line*/) {
  const Open open = open_.back();
  Refusal refusal;
  if (!fault_) {
    open_.pop_back();
    refusal = close_element(open);
    open_.push_back(open);
    refusal = settle(std::move(refusal), open.line);
  }
  open_.pop_back();
  if (fault_ && fault_->depth == open_.size()) end_fault(open);
  // The base that begin_ontology() sets stays until the end.
  if (open.role != Role::ontology) bases_.resize(std::min(bases_.size(), open.bases));
  text_.clear();
  return refusal;
}

Listener::Refusal Builder::close_element(const Open& open) {
  if (operands_.size() - open.first > limits_.operands)
    return beyond_limit("more than " + std::to_string(limits_.operands) + " operands");
  // An entity and a blank node are operands from their start tag on.
  const bool is_leaf = open.role == Role::blank || form_of(open) == Form::entity;
  const bool is_empty = operands_.size() == open.first + (is_leaf ? 1 : 0);
  const bool must_be_empty = is_leaf || open.role == Role::prefix || form_of(open) == Form::import;
  if (must_be_empty && !is_empty) return "an element where none may stand";
  switch (open.role) {
    case Role::literal:
      return end_literal(open);
    case Role::facet:
      return end_facet(open);
    case Role::iri:
    case Role::short_iri:
      return end_iri(open);
    case Role::production:
      break;
    default:
      return std::nullopt;
  }
  switch (form_of(open)) {
    case Form::import:
      return end_import(open);
    case Form::annotation:
      return end_annotation(open);
    case Form::expression:
    case Form::n_ary_data:
      return end_expression(open);
    case Form::variable:
    case Form::built_in:
    case Form::atoms:
      return end_part_of_rule(open);
    case Form::entity:
      return std::nullopt;
    default:
      return end_axiom(open);
  }
}

Listener::Refusal Builder::end_import(const Open& open) {
  std::string iri;
  if (auto refusal = full_iri(base::trimmed(text_), iri)) return refusal;
  auto refusal = head_.import(iri, open.line, document_);
  return refusal ? beyond_limit(std::move(*refusal)) : std::nullopt;
}

}  // namespace geminga::owlxml
