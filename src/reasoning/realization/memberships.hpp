// Questions about individuals and concepts that a model leaves open, many individuals at a time.
//
// The first question is whether there is a model in which no candidate is in its concept. A yes answers for all of
// them. A no is asked again in halves, and each model that is found answers for other candidates, too (Haarslev,
// Moeller: On the scalability of description logic instance retrieval, 2008, section 4: binary instance retrieval).
#ifndef GEMINGA_REASONING_REALIZATION_MEMBERSHIPS_HPP
#define GEMINGA_REASONING_REALIZATION_MEMBERSHIPS_HPP

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "reasoning/realization/world.hpp"

namespace geminga::realization {

/// The individuals that may be in a concept.
struct Column {
  clauses::ConceptId of{};
  clauses::ConceptId complement{};           ///< of add_complement()
  std::vector<clauses::IndividualId> open;   ///< ascending; at last those that are not decided
  std::vector<clauses::IndividualId> found;  ///< those that are in it
  /// Columns whose concepts hold what this concept holds.
  std::vector<std::size_t> above;
};

/// Two individuals that may be the same.
struct Pair {
  clauses::IndividualId first{};
  clauses::IndividualId second{};
  hypertableau::Verdict are_same = hypertableau::Verdict::unknown;
};

/// A link between two individuals that may hold.
struct OpenLink {
  clauses::PropertyId property{};
  clauses::IndividualId first{};
  clauses::IndividualId second{};
  clauses::ConceptId of_first{};  ///< of add_unlinked()
  clauses::ConceptId of_second{};
  hypertableau::Verdict holds = hypertableau::Verdict::unknown;
};

/// Questions, and afterwards their answers.
struct OpenQuestions {
  std::vector<Column> columns;  ///< the columns above another stand before it
  std::vector<Pair> pairs;
  std::vector<OpenLink> links;

  [[nodiscard]] bool is_empty() const { return columns.empty() && pairs.empty() && links.empty(); }
};

/// Asks until everything is decided or a limit is reached, of which a gap tells. Requires that the model was built and
/// that no question was asked.
void decide(hypertableau::FactModel& model, OpenQuestions& open, const Options& options, Gaps& gaps);

}  // namespace geminga::realization

#endif
