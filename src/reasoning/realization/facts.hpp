// The facts about named individuals that are certain.
#ifndef GEMINGA_REASONING_REALIZATION_FACTS_HPP
#define GEMINGA_REASONING_REALIZATION_FACTS_HPP

#include <unordered_map>
#include <vector>

#include "reasoning/realization/links.hpp"
#include "reasoning/realization/rows.hpp"

namespace geminga::realization {

/// The certain part of a model, copied before the search goes on.
struct CertainFacts {
  std::vector<hypertableau::Individuals::Link> links;
  std::vector<hypertableau::Individuals::Value> values;
};

/// Facts between nodes, of which those between rows count.
class FactNames {
 public:
  FactNames(const owl::Ontology& source, const clauses::ClauseSet& set, const std::vector<Row>& rows);

  /// Writes the facts of every name of a row, ascending and each once. Notes in `gaps` what may be missing.
  [[nodiscard]] std::vector<Fact> write(const hypertableau::Individuals& individuals, const CertainFacts& certain,
                                        base::Budget* budget, Gaps& gaps) const;

 private:
  [[nodiscard]] const Row* row_of(hypertableau::NodeId node) const;

  const owl::Ontology& source_;
  const clauses::ClauseSet& set_;
  std::unordered_map<hypertableau::NodeId, const Row*> rows_;
  LinkNames links_;
};

/// A link of a canonical property between the first names of two rows.
struct UncertainLink {
  clauses::PropertyId property{};
  clauses::IndividualId first{};
  clauses::IndividualId second{};
};

/// The links between rows that hold in this model and are not certain.
[[nodiscard]] std::vector<UncertainLink> uncertain_links(const hypertableau::Individuals& individuals,
                                                         const std::vector<Row>& rows);
/// Whether the model has values of individuals that are not certain.
[[nodiscard]] bool has_uncertain_values(const hypertableau::Individuals& individuals, const std::vector<Row>& rows);

}  // namespace geminga::realization

#endif
