// From the axioms of an ontology to clauses: negation normal form, names for parts, automata for chains.
#ifndef GEMINGA_REASONING_DL_CLAUSES_CLAUSIFY_HPP
#define GEMINGA_REASONING_DL_CLAUSES_CLAUSIFY_HPP

#include <cstdint>
#include <expected>
#include <optional>
#include <span>
#include <string>

#include "base/budget.hpp"
#include "reasoning/dl/clauses/clause.hpp"

namespace geminga::owl {
class Ontology;
}

namespace geminga::clauses {

struct ClausifyLimits {
  std::size_t clauses = 4'000'000;
  std::size_t automaton_states = 100'000;  ///< of one property; a box of chains may need exponentially many
  std::uint32_t cardinality = 1'000'000;   ///< axioms with a greater number are left out and named
  base::Budget* budget = nullptr;          ///< pays a step for an axiom; borrowed, null: no limit
};

/// Why an ontology has no clauses: a limit was exceeded. `text` is one line.
struct ClausifyError {
  std::string text;
};

/// Translates the axioms with these numbers (nothing: all). Every construct of OWL 2 DL has a translation. What OWL 2
/// DL forbids (irregular chains, cardinalities of properties that are not simple) is left out and named in `unused`, so
/// the clauses never say more than the axioms. Characteristics of properties that are not simple are named, too, and
/// have the clauses that hold of derived edges. `queries` are class expressions of the source. Each gets a concept Q
/// with Q SubClassOf expression, so that Q is satisfiable exactly if the expression is. Each of `complements` gets one
/// with Q SubClassOf not expression. The result depends on the set of axioms, not on their order.
[[nodiscard]] std::expected<ClauseSet, ClausifyError> clausify(const owl::Ontology& source,
                                                               std::optional<std::span<const std::uint32_t>> axioms,
                                                               std::span<const owl::TermId> queries,
                                                               std::span<const owl::TermId> complements = {},
                                                               const ClausifyLimits& limits = {});

}  // namespace geminga::clauses

#endif
