// Hyperresolution: a rule of the ontology fires if each atom of its body is maximal in some clause.
//
//  A1 and ... and An -> D in O    Gi -> Di v [Ai s] for each i
//  ----------------------------------------------------------- Hyper [s(x) = x]
//  G1 and ... and Gn -> D1 v ... v Dn v D s
#ifndef GEMINGA_REASONING_DL_CONSEQUENCE_HYPERRESOLUTION_HPP
#define GEMINGA_REASONING_DL_CONSEQUENCE_HYPERRESOLUTION_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include "reasoning/dl/consequence/conclusions.hpp"
#include "reasoning/dl/consequence/effort.hpp"
#include "reasoning/dl/consequence/premise.hpp"
#include "reasoning/dl/consequence/rules/rules.hpp"
#include "reasoning/dl/consequence/successors.hpp"

namespace geminga::consequence {

/// The parts of a context that matching reads.
struct MatchedContext {
  ClauseStore& store;  ///< changed only by Conclusions
  const Successors& successors;
};

class Hyperresolution {
 public:
  Hyperresolution(const Rules& rules, Effort& effort, Conclusions& conclusions)
      : rules_(rules), effort_(effort), conclusions_(conclusions) {}

  /// Fires a rule with an empty body.
  void fire(const Rule& rule, MatchedContext context);
  /// Concludes all that follows by the rule from the premise and other clauses, if the premise matches this atom of its
  /// body with `neighbour` for the variable.
  void apply(Premise premise, const Occurrence& occurrence, Term neighbour, MatchedContext context);
  /// Concludes the successors of the premise's "at least":
  ///
  ///  G -> D v [(>= n R.B)(x)]
  ///  ----------------------------------------------------------------------
  ///  G -> D v R(x, fi(x))   G -> D v B(fi(x))   for n functions f1 ... fn of its own
  ///
  /// Filing and Paramodulation know that fi(x) and fj(x) are different.
  void expand(Premise premise, const Expansion& expansion, ClauseStore& store);

 private:
  [[nodiscard]] static bool may_hold(const RuleAtom& atom, Term term, const ClauseStore& store);
  void join(const Rule& rule, MatchedContext context);
  void join_with(const Rule& rule, std::size_t atom, Literal literal, MatchedContext context);
  [[nodiscard]] bool may_bind(const Rule& rule, std::uint8_t variable, Term term, MatchedContext context) const;
  void conclude(const Rule& rule, ClauseStore& store);

  const Rules& rules_;
  Effort& effort_;
  Conclusions& conclusions_;
  // The match of a rule.
  std::vector<Premise> premises_;
  std::vector<Term> binding_;          ///< of each variable; unbound where none
  std::vector<std::uint8_t> is_done_;  ///< of each atom of the body
  std::vector<Literal> head_;          ///< room for the conclusion's
};

}  // namespace geminga::consequence

#endif
