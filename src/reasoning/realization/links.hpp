// The links of a model as facts of named properties: canonical properties, inverses, and chains.
#ifndef GEMINGA_REASONING_REALIZATION_LINKS_HPP
#define GEMINGA_REASONING_REALIZATION_LINKS_HPP

#include <functional>
#include <utility>
#include <vector>

#include "reasoning/realization/world.hpp"

namespace geminga::realization {

/// Takes property, subject and object: terms and nodes.
using UseLink = std::function<void(owl::TermId, hypertableau::NodeId, hypertableau::NodeId)>;

/// The state of the search for paths of properties that are not simple.
struct Paths {
  bool is_cut_off = false;  ///< the budget was spent
  /// Whether a path may lead through a thing without a name that the model does not write out.
  bool are_open = false;
};

/// The properties of a clause set by their canonical ones.
class LinkNames {
 public:
  LinkNames(const owl::Ontology& source, const clauses::ClauseSet& set);

  /// Calls `use` for each property that a link of a canonical property stands for, without those that are not simple.
  void name(const hypertableau::Individuals::Link& link, const UseLink& use) const;
  /// Calls `use` for all pairs that a property which is not simple connects, once or more for each.
  Paths follow(const std::vector<hypertableau::Individuals::Link>& links, const hypertableau::Individuals& individuals,
               base::Budget* budget, const UseLink& use) const;
  /// Whether chains or transitivity imply any property.
  [[nodiscard]] bool has_paths() const { return !composite_.empty(); }

 private:
  struct Name {
    owl::TermId property{};
    bool is_inverse = false;
  };
  const clauses::ClauseSet& set_;
  std::vector<std::vector<Name>> names_;                      ///< by canonical property
  std::vector<std::pair<owl::TermId, owl::Role>> composite_;  ///< with the canonical role of each
};

}  // namespace geminga::realization

#endif
