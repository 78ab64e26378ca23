// The index of an ontology: interned EL expressions, each with the rules that its occurrences need.
#ifndef GEMINGA_REASONING_EL_INDEX_INDEXED_ONTOLOGY_HPP
#define GEMINGA_REASONING_EL_INDEX_INDEXED_ONTOLOGY_HPP

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/rows.hpp"
#include "reasoning/el/index/expressions.hpp"
#include "reasoning/el/index/flat_rules.hpp"
#include "reasoning/el/index/roles.hpp"

namespace geminga::el {

/// The kinds of rules of an expression, as bits. Most expressions have one or two kinds. Reading this octet first saves
/// a cache miss for each table of rules.
enum class RuleBits : std::uint8_t {
  bottom = 1,
  above = 2,
  links = 4,
  selfs = 8,
  conjunctions = 16,
  existentials = 32,
  disjointness = 64,
  functional = 128,
};

/// Any number of threads read it. index_builder.hpp makes it.
class IndexedOntology {
 public:
  /// Of no expression.
  IndexedOntology() = default;
  /// Finds told equivalents, and sorts rules to the expressions that trigger them. Nothing if the closure of told atoms
  /// without rules has more than `max_pairs` pairs.
  [[nodiscard]] static std::optional<IndexedOntology> sorted(FlatRules rules, std::size_t max_pairs);

  /// Drops the rules of functional properties and universals, for an ontology that they take over a limit.
  void forget_merging();

  [[nodiscard]] std::size_t size() const { return exprs_.size(); }
  [[nodiscard]] const Expr& expr(ExprId id) const { return exprs_[number(id)]; }
  [[nodiscard]] bool is_atom(ExprId id) const { return expr(id).kind <= ExprKind::nominal; }
  [[nodiscard]] bool is_nominal(ExprId id) const { return is_nominal_rep_[number(id)]; }
  /// True if links of data roles end in the atom, so that its members are values and no individuals.
  [[nodiscard]] bool is_value(ExprId id) const { return is_value_rep_[number(id)]; }
  /// The atom that stands for all atoms that told axioms make equivalent to this one. Other expressions: themselves.
  [[nodiscard]] ExprId representative(ExprId id) const { return representative_[number(id)]; }
  /// True if the expression has a rule; the others never enter a context.
  [[nodiscard]] bool is_active(ExprId id) const { return is_active_[number(id)]; }
  /// Representatives of the atoms that axioms put right above.
  [[nodiscard]] std::span<const ExprId> told_atoms(ExprId id) const { return told_atoms_[number(id)]; }
  /// The nearest active atoms above an atom, reached through atoms without rules.
  [[nodiscard]] std::span<const ExprId> frontier(ExprId id) const {
    return std::span(frontier_items_).subspan(frontier_begin_[number(id)], frontier_count_[number(id)]);
  }
  [[nodiscard]] bool has_rules(ExprId id, RuleBits kind) const {
    return (rule_bits_[number(id)] & static_cast<std::uint8_t>(kind)) != 0;
  }
  [[nodiscard]] bool is_told_bottom(ExprId id) const { return is_told_bottom_[number(id)]; }
  [[nodiscard]] std::span<const LinkRule> links(ExprId id) const { return links_[number(id)]; }
  [[nodiscard]] std::span<const RoleId> selfs(ExprId id) const { return selfs_[number(id)]; }
  /// Ascending by partner.
  [[nodiscard]] std::span<const ConjunctionRule> conjunctions(ExprId id) const { return conjunctions_[number(id)]; }
  /// Ascending by role.
  [[nodiscard]] std::span<const ExistentialRule> existentials(ExprId id) const { return existentials_[number(id)]; }
  [[nodiscard]] std::span<const std::uint32_t> disjointness(ExprId id) const { return disjointness_[number(id)]; }
  [[nodiscard]] std::span<const UniversalRule> universals(ExprId id) const { return universals_[number(id)]; }
  [[nodiscard]] bool has_universals() const { return universals_.item_count() != 0; }
  [[nodiscard]] std::size_t disjointness_count() const { return disjointness_count_; }
  /// All rules that an expression has, as RuleBits.
  [[nodiscard]] std::uint8_t rule_bits(ExprId id) const { return rule_bits_[number(id)]; }
  /// True if some expression has at most one successor by some role.
  [[nodiscard]] bool has_functional() const { return !may_be_functional_.empty(); }
  /// True if that is so for the role or one of its super roles.
  [[nodiscard]] bool may_be_functional(RoleId role) const {
    return !may_be_functional_.empty() && may_be_functional_[static_cast<std::size_t>(role)];
  }
  [[nodiscard]] bool is_functional(RoleId role) const { return is_functional_[static_cast<std::size_t>(role)]; }
  /// The expressions whose instances have at most one successor by this role.
  [[nodiscard]] std::span<const ExprId> functional_in(RoleId role) const {
    return functional_in_[static_cast<std::size_t>(role)];
  }
  [[nodiscard]] std::span<const RoleId> functional_roles(ExprId id) const { return functional_roles_[number(id)]; }
  /// The negative R Self of a role, or bottom_expr if there is none.
  [[nodiscard]] ExprId negative_self(RoleId role) const;
  [[nodiscard]] bool has_negative_self() const { return has_negative_self_; }
  /// The atom of the range of a role, or T if it has none.
  [[nodiscard]] ExprId range_of(RoleId role) const;
  /// True if an expression is below a nominal or leads to one.
  [[nodiscard]] bool has_nominals() const { return has_nominals_; }
  [[nodiscard]] const Roles& roles() const { return roles_; }
  /// The atom in whose context a link to the atom `target` ends.
  [[nodiscard]] ExprId link_root(ExprId target) const;
  /// True if a context of this atom would have the subsumers of another context.
  [[nodiscard]] bool needs_no_context(ExprId atom) const { return !is_active(atom) && frontier(atom).size() <= 1; }
  /// True if a short search finds `super` above `sub` by told axioms. Requires representatives.
  [[nodiscard]] bool is_told_below(ExprId sub, ExprId super) const;

 private:
  /// The result is the representatives, each behind those above it.
  std::vector<std::uint32_t> find_representatives(const Pairs<ExprId>& atoms_above);
  /// Marks the representatives of values, of nominals, and of what is below F.
  void mark_representatives(std::span<const ExprId> values);
  /// Takes what was told of expressions.
  void sort_told(FlatRules& rules);
  /// Finds the rules by which expressions are recognised.
  void sort_negative(const std::vector<bool>& is_negative);
  void find_functional(Pairs<RoleId> told);
  void find_nominals();
  void find_active(std::span<const ExprId> watched);
  [[nodiscard]] bool find_frontiers(std::span<const std::uint32_t> supers_first, std::size_t max_items);
  void find_rule_bits();
  void find_link_roots();
  /// The items of each representative.
  template <typename Item>
  base::Rows<Item> rows_of(Pairs<Item> pairs) const;

  Roles roles_;
  std::vector<Expr> exprs_;
  std::vector<ExprId> range_atoms_;  ///< by role; T: none
  std::size_t disjointness_count_ = 0;
  bool has_nominals_ = false;
  bool keeps_link_targets_ = false;
  bool has_negative_self_ = false;

  // By expression.
  std::vector<ExprId> representative_;
  std::vector<bool> is_told_bottom_;
  std::vector<bool> is_nominal_rep_;
  std::vector<bool> is_value_rep_;
  std::vector<bool> is_active_;
  std::vector<std::uint8_t> rule_bits_;
  base::Rows<ExprId> told_atoms_;
  base::Rows<LinkRule> links_;
  base::Rows<RoleId> selfs_;
  base::Rows<ConjunctionRule> conjunctions_;
  base::Rows<ExistentialRule> existentials_;
  base::Rows<std::uint32_t> disjointness_;
  base::Rows<UniversalRule> universals_;
  base::Rows<RoleId> functional_roles_;
  std::vector<std::uint32_t> frontier_begin_;
  std::vector<std::uint32_t> frontier_count_;
  std::vector<ExprId> frontier_items_;

  // By role.
  std::vector<ExprId> negative_selfs_;
  std::vector<bool> may_be_functional_;  ///< empty: none is
  std::vector<bool> is_functional_;
  base::Rows<ExprId> functional_in_;
};

}  // namespace geminga::el

#endif
