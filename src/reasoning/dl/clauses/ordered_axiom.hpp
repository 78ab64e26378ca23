// An axiom as the translation takes it: its sets are in canonical order.
#ifndef GEMINGA_REASONING_DL_CLAUSES_ORDERED_AXIOM_HPP
#define GEMINGA_REASONING_DL_CLAUSES_ORDERED_AXIOM_HPP

#include <cstdint>
#include <vector>

#include "reasoning/dl/clauses/literal.hpp"

namespace geminga::clauses {

struct OrderedAxiom {
  std::uint32_t axiom = 0;  ///< its number in the source
  owl::AxiomKind kind{};
  std::vector<owl::TermId> arguments;
};

constexpr Literal positive(owl::TermId term) { return {term, false, Part::whole}; }
constexpr Literal negative(owl::TermId term) { return {term, true, Part::whole}; }

}  // namespace geminga::clauses

#endif
