// The predicates of a ClauseSet while it is made. Each term gets a dense number when it is first asked for.
#ifndef GEMINGA_REASONING_DL_CLAUSES_VOCABULARY_HPP
#define GEMINGA_REASONING_DL_CLAUSES_VOCABULARY_HPP

#include <cstdint>
#include <map>
#include <unordered_map>

#include "reasoning/dl/clauses/clause.hpp"
#include "reasoning/dl/clauses/literal.hpp"
#include "reasoning/owl/canonical.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::clauses {

/// Fills the tables of `set`. Terms that differ only in the order of a set are the same.
class Vocabulary {
 public:
  Vocabulary(const owl::Ontology& source, const owl::ContentHashes& hashes, ClauseSet& set);

  [[nodiscard]] const owl::Ontology& source() const { return source_; }
  [[nodiscard]] const owl::ContentHashes& hashes() const { return hashes_; }

  /// The concept of a named class, or the nominal of an individual.
  ConceptId concept_of(owl::TermId term);
  ConceptId nominal(IndividualId individual);
  ConceptId auxiliary(owl::TermId term);
  IndividualId individual(owl::TermId term);
  /// A new individual that no axiom names.
  IndividualId fresh_individual();
  /// The role of a property expression.
  Role role(owl::TermId term);
  DataPropertyId data_property(owl::TermId term);
  DataRangeId data_range(const DataRange& range);
  std::uint32_t index(const AtLeast& at_least) { return indexed(at_least, at_leasts_, set_.at_leasts); }
  std::uint32_t index(const DataAtLeast& at_least) { return indexed(at_least, data_at_leasts_, set_.data_at_leasts); }
  std::uint32_t index(const AtMost& at_most) { return indexed(at_most, at_mosts_, set_.at_mosts); }
  std::uint32_t index(const DataAtMost& at_most) { return indexed(at_most, data_at_mosts_, set_.data_at_mosts); }

 private:
  template <typename Record>
  static std::uint32_t indexed(const Record& record, std::map<Record, std::uint32_t>& index,
                               std::vector<Record>& table) {
    const auto [found, is_new] = index.try_emplace(record, static_cast<std::uint32_t>(table.size()));
    if (is_new) table.push_back(record);
    return found->second;
  }

  const owl::Ontology& source_;
  const owl::ContentHashes& hashes_;
  ClauseSet& set_;
  std::unordered_map<owl::TermId, ConceptId> concepts_;
  std::unordered_map<std::uint32_t, ConceptId> nominals_;
  std::unordered_map<owl::TermId, IndividualId> individuals_;
  std::unordered_map<owl::TermId, PropertyId> properties_;
  std::unordered_map<owl::TermId, DataPropertyId> data_properties_;
  std::map<std::pair<owl::ContentHashes::Hash, bool>, DataRangeId> data_ranges_;
  std::map<AtLeast, std::uint32_t> at_leasts_;
  std::map<DataAtLeast, std::uint32_t> data_at_leasts_;
  std::map<AtMost, std::uint32_t> at_mosts_;
  std::map<DataAtMost, std::uint32_t> data_at_mosts_;
};

}  // namespace geminga::clauses

#endif
