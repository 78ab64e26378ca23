// The index of an ontology: interned EL expressions, each with the rules that its occurrences need.
//
// Legend: A atom, C D E expressions, R S roles, C < D for "C SubClassOf D", T owl:Thing, F owl:Nothing. An expression
// occurs negatively left of <, where it must be recognised, and positively right of <, where it is asserted.
#ifndef GEMINGA_REASONING_EL_INDEX_INDEXED_ONTOLOGY_HPP
#define GEMINGA_REASONING_EL_INDEX_INDEXED_ONTOLOGY_HPP

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/interner.hpp"
#include "base/rows.hpp"
#include "reasoning/el/index/roles.hpp"

namespace geminga::el {

/// An interned expression. Dense; equal expressions have equal numbers.
enum class ExprId : std::uint32_t {};
inline constexpr ExprId top_expr{0};
inline constexpr ExprId bottom_expr{1};

[[nodiscard]] constexpr std::uint32_t number(ExprId id) { return static_cast<std::uint32_t>(id); }

enum class ExprKind : std::uint8_t {
  atom,         ///< a named class, owl:Thing, owl:Nothing, a data range, or a name for an expression without rules
  nominal,      ///< an atom with one instance
  conjunction,  ///< C and D
  existential,  ///< R some C
  self,         ///< R Self
};

struct Expr {
  ExprKind kind = ExprKind::atom;
  std::uint32_t first = 0;   ///< conjunct; role; for atoms unused
  std::uint32_t second = 0;  ///< conjunct; filler
};

/// C and partner are recognised as `conjunction`.
struct ConjunctionRule {
  ExprId partner{};
  ExprId conjunction{};
};
/// A link of `role` or a sub-role to something in the filler is recognised as `existential`.
struct ExistentialRule {
  RoleId role{};
  ExprId existential{};
  friend auto operator<=>(const ExistentialRule&, const ExistentialRule&) = default;
};
/// Each instance of the expression has a `role` successor in the atom `target`.
struct LinkRule {
  RoleId role{};
  ExprId target{};
  ExprId root{};  ///< the atom in whose context the link ends, which may be one above the target
  friend auto operator<=>(const LinkRule&, const LinkRule&) = default;
};

/// Each instance of the expression has `role` successors in the atom `target` only.
struct UniversalRule {
  RoleId role{};
  ExprId target{};
  friend auto operator<=>(const UniversalRule&, const UniversalRule&) = default;
};

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

/// The normaliser fills it, finish() is called once, and then any number of threads read it.
class IndexedOntology {
 public:
  IndexedOntology();

  // Building.
  ExprId add_atom() { return add({ExprKind::atom, 0, 0}); }
  ExprId add_nominal();
  /// The conjunction of any number of parts, sorted, without doubles and without T: T if nothing is left, F if F is in
  /// it.
  ExprId conjunction(std::vector<ExprId> parts);
  ExprId existential(RoleId role, ExprId filler);
  ExprId self(RoleId role);
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
  void add_functional(ExprId id, RoleId role);
  /// States that links of the role or a sub-role from an instance of the atom end in the filler. If the role leads to
  /// values, the filler is an atom of its own, and no literal or datatype.
  void add_universal(ExprId atom, RoleId role, ExprId filler) { universals_told_.push_back({atom, {role, filler}}); }
  /// Lets contexts have the atom as a subsumer although it has no rules.
  void watch(ExprId atom) { watched_.push_back(atom); }
  Roles& roles() { return roles_; }

  /// Lets every link end in the context of its own target, as expression_base.hpp needs it. Otherwise a link ends in
  /// the nearest context that has rules.
  void keep_link_targets() { keeps_link_targets_ = true; }

  /// Closes roles, finds told equivalents, sorts rules to their expressions. False if a closure has more than
  /// `max_pairs` pairs; then the index is of no use.
  [[nodiscard]] bool finish(std::size_t max_pairs);

  /// Drops the rules of functional properties and universals, for an ontology that they take over a limit.
  void forget_merging();

  // Reading, after finish().
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
  ExprId add(const Expr& expr);
  ExprId intern(const Expr& expr);
  void inherit_ranges();
  void flatten_told();
  /// Takes apart what is right of one told inclusion. `stack` is empty before and after.
  void flatten_one(ExprId sub, ExprId super, std::vector<ExprId>& stack);
  ExprId link_target(RoleId role, ExprId filler);
  ExprId atom_of(ExprId expr);
  void find_universal_targets();
  void find_representatives();
  void sort_rules();
  void find_functional();
  void find_nominals();
  void find_active();
  void find_rule_bits();
  void find_link_roots();
  [[nodiscard]] bool find_frontiers(std::size_t max_items);
  template <typename Item>
  base::Rows<Item> rows_of(std::vector<std::pair<std::uint32_t, Item>>& pairs) const;

  Roles roles_;
  std::vector<Expr> exprs_;
  base::NumberTable table_;
  std::vector<bool> is_negative_;
  std::vector<std::pair<ExprId, ExprId>> told_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> disjoint_pairs_;  ///< expression, number of the axiom
  std::size_t disjointness_count_ = 0;
  std::vector<ExprId> watched_;
  std::vector<std::pair<ExprId, UniversalRule>> universals_told_;  ///< the target is a filler
  std::vector<ExprId> range_atoms_;                                ///< by role; T: none
  bool has_nominals_ = false;
  bool keeps_link_targets_ = false;
  bool has_negative_self_ = false;

  std::vector<ExprId> target_atoms_;  ///< by complex expression: the atom that stands for it at the end of links
  std::vector<std::pair<std::uint32_t, ExprId>> atom_pairs_;
  std::vector<std::pair<std::uint32_t, LinkRule>> link_pairs_;
  std::vector<std::pair<std::uint32_t, RoleId>> self_pairs_;
  std::vector<bool> is_told_bottom_;
  std::vector<ExprId> representative_;
  std::vector<std::uint32_t> supers_first_;  ///< representatives, each behind those above it
  std::vector<bool> is_nominal_rep_;
  std::vector<bool> is_data_role_;  ///< by role, up to the last data role
  std::vector<ExprId> values_;      ///< atoms at the end of links of data roles
  std::vector<bool> is_value_rep_;
  std::vector<bool> is_active_;
  base::Rows<ExprId> told_atoms_;
  base::Rows<LinkRule> links_;
  base::Rows<RoleId> selfs_;
  base::Rows<ConjunctionRule> conjunctions_;
  base::Rows<ExistentialRule> existentials_;
  base::Rows<std::uint32_t> disjointness_;
  base::Rows<UniversalRule> universals_;
  std::vector<ExprId> negative_selfs_;  ///< by role
  std::vector<std::pair<std::uint32_t, RoleId>> functional_pairs_;
  std::vector<bool> may_be_functional_;  ///< by role; empty: none is
  std::vector<bool> is_functional_;
  base::Rows<ExprId> functional_in_;
  base::Rows<RoleId> functional_roles_;
  std::vector<ExprId> frontier_items_;
  std::vector<std::uint32_t> frontier_begin_;
  std::vector<std::uint32_t> frontier_count_;
  std::vector<std::uint8_t> rule_bits_;
};

}  // namespace geminga::el

#endif
