#include "reasoning/realization/told.hpp"

#include <map>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "reasoning/realization/facts.hpp"
#include "reasoning/realization/type_sets.hpp"

namespace geminga::realization {

using owl::AxiomKind;
using owl::TermKind;
using taxonomy::ClassNumber;

Realization realize_told(const owl::Ontology& source, const taxonomy::Classification& classification,
                         std::size_t most_fact_octets) {
  std::unordered_map<owl::NameId, ClassNumber> numbers;
  for (std::uint32_t at = 0; at < classification.class_count(); ++at)
    numbers.emplace(classification.classes[at], ClassNumber{at});
  std::map<std::string_view, owl::TermId> individuals;
  for (std::uint32_t term = 0; term < source.term_count(); ++term) {
    if (source.kind(owl::TermId{term}) == TermKind::individual)
      individuals.emplace(source.name_of(owl::TermId{term}), owl::TermId{term});
  }
  std::map<owl::TermId, Classes> types;
  FactList facts(source, most_fact_octets);
  for (std::uint32_t number = 0; number < source.axiom_count(); ++number) {
    const owl::Axiom axiom = source.axiom(number);
    const auto is = [&](std::size_t argument, TermKind kind) { return source.kind(axiom.arguments[argument]) == kind; };
    if (axiom.kind == AxiomKind::class_assertion && is(0, TermKind::named_class)) {
      const auto found = numbers.find(source.term(axiom.arguments[0]).name);
      if (found != numbers.end() && found->second != classification.thing)
        types[axiom.arguments[1]].push_back(classification.representative[static_cast<std::size_t>(found->second)]);
    }
    const bool is_link = axiom.kind == AxiomKind::object_property_assertion && is(0, TermKind::object_property) &&
                         is(1, TermKind::individual) && is(2, TermKind::individual);
    const bool is_value = axiom.kind == AxiomKind::data_property_assertion && is(1, TermKind::individual);
    if (most_fact_octets > 0 && (is_link || is_value))
      facts.add({axiom.arguments[1], axiom.arguments[0], axiom.arguments[2]});
  }
  Realization told;
  TypeSets sets(classification);
  for (const auto& [name, individual] : individuals) {
    const auto at = static_cast<std::uint32_t>(told.individuals.size());
    told.individuals.push_back(individual);
    told.representative.push_back(at);
    told.types.push_back(sets.number_of(types[individual]));
    told.undecided.push_back(at);
  }
  told.type_sets = sets.take();
  told.facts = facts.take();
  told.has_too_many_facts = facts.is_full();
  told.is_consistency_open = true;
  return told;
}

}  // namespace geminga::realization
