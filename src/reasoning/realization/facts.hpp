// The facts about named individuals that are certain.
#ifndef GEMINGA_REASONING_REALIZATION_FACTS_HPP
#define GEMINGA_REASONING_REALIZATION_FACTS_HPP

#include <cstddef>
#include <optional>
#include <unordered_map>
#include <utility>
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

/// Facts, each once, up to a limit of octets.
class FactList {
 public:
  /// Begins with facts that are within the limit. Borrows the source.
  FactList(const owl::Ontology& source, std::size_t most_octets, std::vector<Fact> facts = {})
      : source_(source), most_octets_(most_octets), facts_(std::move(facts)) {}

  void add(const Fact& fact);
  /// Whether more than the limit was added. Then nothing is kept, and nothing more is taken.
  [[nodiscard]] bool is_full() const { return is_full_; }
  /// The facts, ascending and each once; nothing where the list is full.
  [[nodiscard]] std::vector<Fact> take();

 private:
  [[nodiscard]] std::size_t octets_of(const Fact& fact) const;
  void drop_repeats();

  const owl::Ontology& source_;
  std::size_t most_octets_;
  std::vector<Fact> facts_;
  std::size_t added_octets_ = 0;  ///< with repeats, since they were dropped
  bool is_full_ = false;
};

/// Facts between nodes, of which those between rows count.
class FactNames {
 public:
  FactNames(const owl::Ontology& source, const clauses::ClauseSet& set, const std::vector<Row>& rows);

  /// Writes the facts of every name of a row with the literals of `certain`. Notes in `gaps` what may be missing.
  void write(const hypertableau::Individuals& individuals, const CertainFacts& certain, base::Budget* budget,
             FactList& facts, Gaps& gaps) const;

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
