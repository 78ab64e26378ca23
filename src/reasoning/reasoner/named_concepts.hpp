// Which class of a classification is which concept of its clauses.
#ifndef GEMINGA_REASONING_REASONER_NAMED_CONCEPTS_HPP
#define GEMINGA_REASONING_REASONER_NAMED_CONCEPTS_HPP

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "reasoning/dl/clauses/clause.hpp"
#include "reasoning/owl/source.hpp"
#include "reasoning/taxonomy/classification.hpp"

namespace geminga::reasoner {

/// Two tables. Classes are numbers of the classification. A class that no clause mentions has no concept.
class NamedConcepts {
 public:
  NamedConcepts(const owl::Ontology& source, const taxonomy::Classification& classification,
                const clauses::ClauseSet& clauses);

  [[nodiscard]] std::optional<std::uint32_t> class_of(clauses::ConceptId of) const {
    return known(classes_[clauses::number(of)]);
  }
  [[nodiscard]] std::optional<clauses::ConceptId> concept_of(std::uint32_t of) const {
    const auto found = known(concepts_[of]);
    return found ? std::optional(clauses::ConceptId{*found}) : std::nullopt;
  }

 private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  static std::optional<std::uint32_t> known(std::uint32_t entry) {
    return entry == none ? std::nullopt : std::optional(entry);
  }

  std::vector<std::uint32_t> classes_;   ///< by concept
  std::vector<std::uint32_t> concepts_;  ///< by class
};

}  // namespace geminga::reasoner

#endif
