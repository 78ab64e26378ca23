// Clauses and facts.
//
//   Hyp-rule:  B1, ..., Bm -> H1 or ... or Hn, and facts that match the body: one of the heads holds. With no head the
//   branch is closed, with one it is a fact, with more it is a choice.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_DERIVATION_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_DERIVATION_HPP

#include <span>
#include <vector>

#include "reasoning/dl/hypertableau/assertions.hpp"
#include "reasoning/dl/hypertableau/bounds.hpp"
#include "reasoning/dl/hypertableau/disjunctions.hpp"
#include "reasoning/dl/hypertableau/effort.hpp"
#include "reasoning/dl/hypertableau/expansion.hpp"
#include "reasoning/dl/hypertableau/graph/dependency.hpp"
#include "reasoning/dl/hypertableau/graph/graph.hpp"
#include "reasoning/dl/hypertableau/numbers.hpp"
#include "reasoning/dl/hypertableau/program/program.hpp"

namespace geminga::hypertableau {

/// Processes facts in the order in which they were added, and matches the clauses with each. A match is found once,
/// with the last of its facts.
class Derivation {
 public:
  Derivation(const clauses::ClauseSet& set, const Program& program, const Graph& graph, DependencySets& sets,
             Effort& effort, Assertions& facts, const Numbers& numbers, Disjunctions& disjunctions, Bounds& bounds,
             Expansion& expansion);

  [[nodiscard]] bool has_next() const { return processed_ < graph_.facts().size(); }
  /// Derives what follows from the next fact and those before it.
  void process_next() { process(processed_++); }

  /// How many facts have been processed.
  [[nodiscard]] FactId sizes() const { return processed_; }
  void restore(FactId processed) { processed_ = processed; }

 private:
  void process(FactId id);
  void process_concept(const Fact& fact, FactId id);
  void process_role(const Fact& fact, FactId id);
  void process_at_least(const Fact& fact, FactId id);
  bool contradicts(const Choice& choice, DependencySet dependency);
  void keep_apart(const Fact& fact);
  void fire(const Plan& plan, FactId id);
  void match(const Plan& plan, std::span<const Step> steps, FactId limit, DependencySet dependency);
  void match_each(const Plan& plan, std::span<const Step> steps, FactId limit, DependencySet dependency);
  void conclude(const Plan& plan, DependencySet dependency);
  [[nodiscard]] DependencySet unite(DependencySet first, DependencySet second) { return sets_.unite(first, second); }

  const clauses::ClauseSet& set_;
  const Program& program_;
  const Graph& graph_;
  DependencySets& sets_;
  Effort& effort_;
  Assertions& facts_;
  const Numbers& numbers_;
  Disjunctions& disjunctions_;
  Bounds& bounds_;
  Expansion& expansion_;
  FactId processed_ = 0;
  std::vector<NodeId> variables_;  ///< of the clause that is matched
};

}  // namespace geminga::hypertableau

#endif
