// Facts, one after the other, and what follows from each.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_DERIVATION_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_DERIVATION_HPP

#include "reasoning/dl/hypertableau/bounds.hpp"
#include "reasoning/dl/hypertableau/clause_matches.hpp"
#include "reasoning/dl/hypertableau/expansion.hpp"
#include "reasoning/dl/hypertableau/facts/assertions.hpp"
#include "reasoning/dl/hypertableau/graph/graph.hpp"
#include "reasoning/dl/hypertableau/program/program.hpp"

namespace geminga::hypertableau {

/// Processes facts in the order in which they were added, and matches the clauses with each. A match is found once,
/// with the last of its facts.
class Derivation {
 public:
  Derivation(const Program& program, const Graph& graph, Assertions& facts, ClauseMatches& matches, Bounds& bounds,
             Expansion& expansion)
      : program_(program), graph_(graph), facts_(facts), matches_(matches), bounds_(bounds), expansion_(expansion) {}

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
  void keep_apart(const Fact& fact);

  const Program& program_;
  const Graph& graph_;
  Assertions& facts_;
  ClauseMatches& matches_;
  Bounds& bounds_;
  Expansion& expansion_;
  FactId processed_ = 0;
};

}  // namespace geminga::hypertableau

#endif
