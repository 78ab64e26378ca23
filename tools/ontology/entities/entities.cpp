#include "ontology/entities/entities.hpp"

#include <algorithm>
#include <array>
#include <tuple>

#include "ontology/loading/classified_files.hpp"
#include "reasoning/owl/datatypes.hpp"
#include "reasoning/owl/loaded_file.hpp"
#include "reasoning/syntax/vocabulary.hpp"

namespace geminga::ontology {
namespace {

using owl::TermKind;

constexpr std::array<std::string_view, 3> definitions{"http://www.w3.org/2000/01/rdf-schema#comment",
                                                      "http://www.w3.org/2004/02/skos/core#definition",
                                                      "http://purl.obolibrary.org/obo/IAO_0000115"};
constexpr std::array<std::string_view, 2> labels{"http://www.w3.org/2000/01/rdf-schema#label",
                                                 "http://www.w3.org/2004/02/skos/core#prefLabel"};
constexpr std::array<std::string_view, 4> reserved{syntax::owl_namespace, syntax::rdf_namespace,
                                                   "http://www.w3.org/2000/01/rdf-schema#",
                                                   "http://www.w3.org/2001/XMLSchema#"};

bool is_reserved(std::string_view iri) {
  return std::ranges::any_of(reserved, [iri](std::string_view space) { return iri.starts_with(space); });
}

}  // namespace

std::string_view word_of(TermKind kind) {
  switch (kind) {
    case TermKind::named_class:
      return "class";
    case TermKind::object_property:
      return "object property";
    case TermKind::data_property:
      return "data property";
    case TermKind::annotation_property:
      return "annotation property";
    default:
      return "datatype";
  }
}

Entities::Entities(const rdf::Loaded& loaded) : short_name_(short_names(loaded.source)) {
  gather(loaded.source);
  annotate(loaded);
}

void Entities::gather(const owl::Ontology& source) {
  std::map<owl::TermId, std::uint32_t> place_of;  // the axiom that makes a name one of the files
  std::set<owl::TermId> used;
  std::vector<owl::TermId> roots;
  for (std::uint32_t number = 0; number < source.axiom_count(); ++number) {
    const owl::Axiom axiom = source.axiom(number);
    const owl::TermId subject = axiom.arguments[0];
    const bool is_entity = source.kind(subject) < TermKind::individual && !is_reserved(source.name_of(subject));
    const bool is_fact = axiom.kind >= owl::AxiomKind::same_individual;
    if (axiom.kind == owl::AxiomKind::declaration) {
      if (is_entity) place_of.insert_or_assign(subject, number);
      continue;
    }
    if (is_entity && !is_fact) place_of.emplace(subject, number);
    roots.insert(roots.end(), axiom.arguments.begin(), axiom.arguments.end());
  }
  for (const owl::TermId term : owl::terms_in(source, roots)) used.insert(term);
  for (const auto& [term, number] : place_of) {
    const owl::Axiom axiom = source.axiom(number);
    Entity entity;
    entity.kind = source.kind(term);
    entity.iri = source.name_of(term);
    entity.short_name = short_name_(entity.iri);
    entity.file = source.files()[static_cast<std::size_t>(axiom.file)].path;
    entity.line = axiom.line;
    entity.is_used = used.contains(term);
    all_.push_back(std::move(entity));
  }
  std::ranges::sort(all_, {}, [](const Entity& one) { return std::tie(one.iri, one.kind); });
  for (const auto& [term, number] : place_of) {
    const auto at = std::ranges::lower_bound(all_, std::pair(std::string(source.name_of(term)), source.kind(term)), {},
                                             [](const Entity& one) { return std::pair(one.iri, one.kind); });
    number_of_.emplace(term, static_cast<std::size_t>(at - all_.begin()));
  }
}

void Entities::annotate(const rdf::Loaded& loaded) {
  for (const owl::Annotation& one : loaded.annotations) {
    if (one.of != owl::Annotation::Of::name) continue;
    const auto [first, last] = std::ranges::equal_range(all_, one.subject, {}, &Entity::iri);
    for (Entity& entity : std::ranges::subrange(first, last)) {
      if (std::ranges::find(labels, one.property) != labels.end() && one.is_literal) entity.labels.push_back(&one);
      if (std::ranges::find(definitions, one.property) != definitions.end()) entity.has_definition = true;
      if (one.property == std::string(syntax::owl_namespace) + "deprecated" &&
          (one.value == "true" || one.value == "1"))
        entity.is_deprecated = true;
    }
  }
}

const Entity* Entities::find(owl::TermId term) const {
  const auto found = number_of_.find(term);
  return found == number_of_.end() ? nullptr : &all_[found->second];
}

}  // namespace geminga::ontology
