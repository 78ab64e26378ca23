// The tables of predicates.
#include "reasoning/dl/clauses/vocabulary.hpp"

namespace geminga::clauses {
namespace {

template <typename Id, typename Record>
Id append(std::vector<Record>& table, Record record) {
  table.push_back(std::move(record));
  return Id{static_cast<std::uint32_t>(table.size() - 1)};
}

}  // namespace

Vocabulary::Vocabulary(const owl::Ontology& source, const owl::ContentHashes& hashes, ClauseSet& set)
    : source_(source), hashes_(hashes), set_(set) {
  set_.concepts = {{ConceptKind::named, owl::thing_term, {}}, {ConceptKind::named, owl::nothing_term, {}}};
  set_.data_ranges = {{no_term, false}, {no_term, true}};
  concepts_ = {{owl::thing_term, thing}, {owl::nothing_term, nothing}};
}

ConceptId Vocabulary::concept_of(owl::TermId term) {
  if (owl::is_individual(source_.kind(term))) return nominal(individual(term));
  const auto [found, is_new] = concepts_.try_emplace(term);
  if (is_new) found->second = append<ConceptId>(set_.concepts, Concept{ConceptKind::named, term, {}});
  return found->second;
}

ConceptId Vocabulary::nominal(IndividualId individual) {
  const auto [found, is_new] = nominals_.try_emplace(number(individual));
  if (is_new) {
    found->second = append<ConceptId>(set_.concepts,
                                      Concept{ConceptKind::nominal, set_.individuals[number(individual)], individual});
  }
  return found->second;
}

ConceptId Vocabulary::auxiliary(owl::TermId term) {
  return append<ConceptId>(set_.concepts, Concept{ConceptKind::auxiliary, term, {}});
}

IndividualId Vocabulary::individual(owl::TermId term) {
  const auto [found, is_new] = individuals_.try_emplace(term);
  if (is_new) found->second = append<IndividualId>(set_.individuals, owl::TermId{term});
  return found->second;
}

IndividualId Vocabulary::fresh_individual() { return append<IndividualId>(set_.individuals, owl::TermId{no_term}); }

Role Vocabulary::role(owl::TermId term) {
  const bool is_inverse = source_.kind(term) == owl::TermKind::object_inverse_of;
  if (is_inverse) term = source_.term(term).arguments[0];
  const auto [found, is_new] = properties_.try_emplace(term);
  if (is_new) found->second = append<PropertyId>(set_.properties, owl::TermId{term});
  return {found->second, is_inverse};
}

DataPropertyId Vocabulary::data_property(owl::TermId term) {
  const auto [found, is_new] = data_properties_.try_emplace(term);
  if (is_new) found->second = append<DataPropertyId>(set_.data_properties, owl::TermId{term});
  return found->second;
}

DataRangeId Vocabulary::data_range(const DataRange& range) {
  if (range.term == no_term) return DataRangeId{range.is_complement ? 1U : 0U};
  const auto [found, is_new] = data_ranges_.try_emplace({hashes_.hash_of(range.term), range.is_complement});
  if (is_new) found->second = append<DataRangeId>(set_.data_ranges, DataRange{range});
  return found->second;
}

}  // namespace geminga::clauses
