// The facts about named individuals that are certain.
#ifndef GEMINGA_REASONING_REALIZATION_FACTS_HPP
#define GEMINGA_REASONING_REALIZATION_FACTS_HPP

#include <optional>
#include <unordered_map>
#include <vector>

#include "reasoning/dl/hypertableau/fact_model.hpp"
#include "reasoning/realization/links.hpp"
#include "reasoning/realization/rows.hpp"

namespace geminga::realization {

/// The certain part of a model, copied before the search goes on.
struct CertainFacts {
  std::vector<hypertableau::Individuals::Link> links;
  std::vector<hypertableau::FactModel::Value> values;
};

/// Facts between nodes, of which those between rows count.
class FactNames {
 public:
  FactNames(const owl::Ontology& source, const clauses::ClauseSet& set, const std::vector<Row>& rows);

  /// Writes the facts of every name of a row, ascending and each once, with the literals of `certain`. Notes in `gaps`
  /// what may be missing.
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
/// A fact of individuals by the first names of their rows that holds in a model and is not certain: a value, or an
/// object of a property with chains.
struct UncertainFact {
  owl::TermId property{};
  clauses::IndividualId subject{};
  std::optional<clauses::IndividualId> object;  ///< of an object property
  owl::TermId literal{};                        ///< of a data property
};

/// The values of individuals in this model that are not certain.
[[nodiscard]] std::vector<UncertainFact> uncertain_values(hypertableau::FactModel& model, const clauses::ClauseSet& set,
                                                          const std::vector<Row>& rows);
/// The pairs of rows that properties with chains connect in this model, if some of its links are not certain.
[[nodiscard]] std::vector<UncertainFact> uncertain_paths(const hypertableau::Individuals& individuals,
                                                         const LinkNames& links, const std::vector<Row>& rows,
                                                         base::Budget* budget, Gaps& gaps);

}  // namespace geminga::realization

#endif
