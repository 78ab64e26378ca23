// Equality by ordered paramodulation: the smaller term replaces the greater one.
#ifndef GEMINGA_REASONING_DL_CONSEQUENCE_PARAMODULATION_HPP
#define GEMINGA_REASONING_DL_CONSEQUENCE_PARAMODULATION_HPP

#include <span>

#include "reasoning/dl/consequence/conclusions.hpp"
#include "reasoning/dl/consequence/effort.hpp"
#include "reasoning/dl/consequence/premise.hpp"
#include "reasoning/dl/consequence/rules/rules.hpp"
#include "reasoning/dl/consequence/successors.hpp"

namespace geminga::consequence {

/// L with t in place of f(x), which is L's greatest term. The other term of an equality must not be t.
[[nodiscard]] Literal with_replaced(Literal literal, Term by);

/// Of a store, Paramodulation only reads the clauses.
class Paramodulation {
 public:
  Paramodulation(const Rules& rules, Effort& effort, Conclusions& conclusions)
      : rules_(rules), effort_(effort), conclusions_(conclusions) {}

  /// Rewrites a premise about f(x) by true -> f(x) = t, which was derived while the premise waited.
  void rewrite(Premise premise, Term by, ClauseStore& store);
  /// Applies the rules to a premise about this successor and its other premises. Replaces the successor if the premise
  /// is true -> f(x) = t.
  void apply(Premise premise, Successor& successor, ClauseStore& store, Successors& successors);

 private:
  void paramodulate(Premise equation, Premise into, ClauseStore& store);
  void apply_equality(Premise premise, Successor& self, ClauseStore& store, Successors& successors);
  [[nodiscard]] std::span<const Premise> active(Pooled<Premise>& premises, const ClauseStore& store);
  void factor(Premise premise, ClauseStore& store);

  const Rules& rules_;
  Effort& effort_;
  Conclusions& conclusions_;
};

}  // namespace geminga::consequence

#endif
