// Clauses.
//
//   Hyp-rule:  B1, ..., Bm -> H1 or ... or Hn, and facts that match the body: one of the heads holds. With no head the
//   branch is closed, with one it is a fact, with more it is a choice.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_CLAUSE_MATCHES_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_CLAUSE_MATCHES_HPP

#include <span>
#include <vector>

#include "reasoning/dl/hypertableau/disjunctions.hpp"
#include "reasoning/dl/hypertableau/facts/assertions.hpp"
#include "reasoning/dl/hypertableau/facts/effort.hpp"
#include "reasoning/dl/hypertableau/graph/dependency.hpp"
#include "reasoning/dl/hypertableau/graph/graph.hpp"
#include "reasoning/dl/hypertableau/program/program.hpp"

namespace geminga::hypertableau {

/// Matches the bodies of clauses with facts, and adds the heads.
class ClauseMatches {
 public:
  ClauseMatches(const Program& program, const Graph& graph, Effort& effort, Assertions& facts,
                Disjunctions& disjunctions);

  /// Adds the heads of all matches in which the fact is the trigger of a plan, up to a clash or a limit. The other
  /// facts of a match are older. False: there is a clash.
  bool add_heads(std::span<const Plan> plans, FactId trigger);

 private:
  void fire(const Plan& plan, FactId id);
  void match(const Plan& plan, std::span<const Step> steps, FactId limit, DependencySet dependency);
  void match_each(const Plan& plan, std::span<const Step> steps, FactId limit, DependencySet dependency);
  void conclude(const Plan& plan, DependencySet dependency);

  const Program& program_;
  const Graph& graph_;
  Effort& effort_;
  Assertions& facts_;
  Disjunctions& disjunctions_;
  std::vector<NodeId> variables_;  ///< of the clause that is matched
};

}  // namespace geminga::hypertableau

#endif
