// The rules of an ontology as they were told: each is a pair of an expression and what it leads to.
#ifndef GEMINGA_REASONING_EL_INDEX_FLAT_RULES_HPP
#define GEMINGA_REASONING_EL_INDEX_FLAT_RULES_HPP

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "reasoning/el/index/expressions.hpp"
#include "reasoning/el/index/roles.hpp"

namespace geminga::el {

/// Pairs of the number of an expression and something that it leads to, in any order.
template <typename Item>
using Pairs = std::vector<std::pair<std::uint32_t, Item>>;

/// Collected by index_builder.hpp and sorted by indexed_ontology.hpp. Atoms have not been replaced by representatives.
struct FlatRules {
  Roles roles;  ///< closed
  std::vector<Expr> exprs;
  std::vector<bool> is_negative;     ///< by expression: the rules recognise it
  std::vector<bool> is_told_bottom;  ///< by expression
  Pairs<ExprId> atoms_above;
  Pairs<LinkRule> links;  ///< without roots
  Pairs<RoleId> selfs;
  Pairs<UniversalRule> universals;
  Pairs<RoleId> functional;
  Pairs<std::uint32_t> disjoint;  ///< the number of the axiom
  std::size_t disjointness_count = 0;
  std::vector<ExprId> range_atoms;  ///< by role; T: none
  std::vector<ExprId> values;       ///< atoms at the end of links of data roles
  std::vector<ExprId> watched;
  bool keeps_link_targets = false;
};

}  // namespace geminga::el

#endif
