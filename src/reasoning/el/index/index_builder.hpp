// The making of an index: expressions are interned, and what axioms say of them is noted, in any order.
#ifndef GEMINGA_REASONING_EL_INDEX_INDEX_BUILDER_HPP
#define GEMINGA_REASONING_EL_INDEX_INDEX_BUILDER_HPP

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/interner.hpp"
#include "reasoning/el/index/flat_rules.hpp"
#include "reasoning/el/index/indexed_ontology.hpp"
#include "reasoning/el/index/roles.hpp"

namespace geminga::el {

/// The normaliser fills it, and finish() makes an index of it. Legend: expressions.hpp.
class IndexBuilder {
 public:
  IndexBuilder();

  // Expressions.
  ExprId add_atom() { return add({ExprKind::atom, 0, 0}); }
  ExprId add_nominal() { return add({ExprKind::nominal, 0, 0}); }
  /// The conjunction of any number of parts, sorted, without doubles and without T: T if nothing is left, F if F is in
  /// it.
  ExprId conjunction(std::vector<ExprId> parts);
  ExprId existential(RoleId role, ExprId filler);
  ExprId self(RoleId role);
  [[nodiscard]] bool is_atom(ExprId id) const { return rules_.exprs[number(id)].kind <= ExprKind::nominal; }
  Roles& roles() { return rules_.roles; }

  // Statements of axioms.
  /// Adds C < D. Requires mark_negative(C) if C is complex.
  void add_told(ExprId sub, ExprId super);
  /// Lets the rules recognise the expression, and conjuncts in it, but not fillers.
  void mark_negative(ExprId id);
  /// Adds C and D < F for every two members.
  void add_disjoint(std::span<const ExprId> members);
  /// The atom of the range of a role: the end of each link of the role is in it.
  ExprId range_atom(RoleId role);
  /// States that the links of the role end in values. To be called before the role is used.
  void mark_data(RoleId role);
  /// States that each instance of the expression has at most one successor by the role. For T the role is functional.
  void add_functional(ExprId id, RoleId role) { rules_.functional.emplace_back(number(id), role); }
  /// States that links of the role or a sub-role from an instance of the atom end in the filler. If the role leads to
  /// values, the filler is an atom of its own, and no literal or datatype.
  void add_universal(ExprId atom, RoleId role, ExprId filler) {
    rules_.universals.emplace_back(number(atom), UniversalRule{role, filler});
  }

  // Wishes of the readers of the index.
  /// Lets contexts have the atom as a subsumer although it has no rules.
  void watch(ExprId atom) { rules_.watched.push_back(atom); }
  /// Lets every link end in the context of its own target, as expression_base.hpp needs it. Otherwise a link ends in
  /// the nearest context that has rules.
  void keep_link_targets() { rules_.keeps_link_targets = true; }

  /// Closes roles, takes what was told apart, and sorts rules to their expressions. Nothing if a closure has more than
  /// `max_pairs` pairs. To be called once; nothing else may be called then.
  [[nodiscard]] std::optional<IndexedOntology> finish(std::size_t max_pairs);

 private:
  ExprId add(const Expr& expr);
  ExprId intern(const Expr& expr);
  [[nodiscard]] ExprId range_of(RoleId role) const;
  [[nodiscard]] bool is_data_role(RoleId role) const;
  void inherit_ranges();
  void flatten_told();
  /// Takes apart what is right of one told inclusion. `stack` is empty before and after.
  void flatten_one(ExprId sub, ExprId super, std::vector<ExprId>& stack);
  void add_link(ExprId sub, RoleId role, ExprId filler);
  /// The atom that stands for an expression at the end of links.
  ExprId atom_of(ExprId target);
  void find_universal_targets();

  FlatRules rules_;
  base::NumberTable table_;                      ///< of complex expressions
  std::vector<std::pair<ExprId, ExprId>> told_;  ///< sub, super
  std::vector<ExprId> target_atoms_;             ///< by complex expression; T: none
  std::vector<bool> is_data_role_;               ///< by role, up to the last data role
};

}  // namespace geminga::el

#endif
