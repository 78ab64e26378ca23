// Which classes a saturation says everything of, though some axioms are not used in full.
//
// The contexts that have instances are a model of what the rules use: each is an element, in what subsumes it, with its
// links; a tree grows from each, whose branches end in the individuals. Where that is a model of the other axioms, too,
// what was not derived does not follow. So each context is tested for what the other axioms ask of its element, and of
// what leads to one that fails nothing is known. The test is on the safe side: it takes for failing what it does not
// look at. What inverses tell successors of what leads to them is looked at in copies of their own (copies.hpp), and
// what they tell back is derived.
//
// What is in a union of which it is in no part can be any of the parts that are in all that it is in. If it is the
// successor of something, one part suffices that shows that something nothing new; of a class, what is not above all
// of these parts is not above the class.
#ifndef GEMINGA_REASONING_EL_SETTLEMENT_HPP
#define GEMINGA_REASONING_EL_SETTLEMENT_HPP

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "base/rows.hpp"
#include "reasoning/el/atoms_above.hpp"
#include "reasoning/el/copies.hpp"
#include "reasoning/el/inverse_roles.hpp"
#include "reasoning/el/open_parts.hpp"
#include "reasoning/el/saturation.hpp"

namespace geminga::el {

class Settlement {
 public:
  /// Requires a saturation that has ended within its limits and without contradiction, and that the rest of the axioms
  /// is all in `open`.
  /// Only what is missing of `classes`, representatives, counts.
  Settlement(const IndexedOntology& index, const Saturation& saturation, const OpenParts& open,
             std::span<const ExprId> classes, const CopyLimits& limits = {});

  /// Whether nothing is missing above an atom, if the ontology is consistent.
  [[nodiscard]] bool is_settled(ExprId atom);
  /// What follows from inverses besides what the saturation derived; while there is something, nothing is settled.
  [[nodiscard]] Copies::Derived derived() const { return copies_ ? copies_->derived() : Copies::Derived{}; }
  /// Whether the budget was spent before all was looked at. Then nothing is settled.
  [[nodiscard]] bool is_cut_off() const { return copies_ && copies_->is_cut_off(); }
  /// Whether everything that must have an instance is settled: then the ontology is consistent.
  [[nodiscard]] bool is_world_settled() const { return is_world_settled_; }

 private:
  void find_heard();
  void test_contexts();
  void test_link(std::uint32_t from, RoleId role, std::uint32_t to);
  [[nodiscard]] bool is_implied_satisfied(std::uint32_t from, RoleId role, std::uint32_t to);
  [[nodiscard]] bool is_backward_link_satisfied(std::uint32_t from, RoleId role, std::uint32_t to);
  [[nodiscard]] bool knows_what_it_learns(std::uint32_t from, RoleId role, std::uint32_t to);
  void make_copies();
  void spread_to_copies();
  [[nodiscard]] bool is_link_satisfied(std::uint32_t from, RoleId role, std::uint32_t to, bool is_backward);
  /// Of what has rules, or is watched.
  [[nodiscard]] bool is_in(std::uint32_t context, ExprId atom) const;
  [[nodiscard]] bool has(std::uint32_t context, ExprId atom, bool is_only_successor);
  [[nodiscard]] bool has_what_is_told(std::uint32_t context, ExprId named, bool is_only_successor);
  [[nodiscard]] bool may_be_linked(std::uint32_t from, RoleId role, std::uint32_t to, bool is_backward);
  void fail(std::uint32_t context);
  void spread();
  void follow();

  // Unions (settlement_unions.cpp).
  [[nodiscard]] bool may_be(std::uint32_t context, std::uint32_t part);
  void index_unions();
  void find_union(std::uint32_t context);
  template <typename Visit>
  bool visit_parts(std::uint32_t context, Visit&& visit);
  [[nodiscard]] bool can_lead_to_a_part(Link from, std::uint32_t context, unsigned depth);
  void test_links_to_unions();
  [[nodiscard]] bool is_root_settled(std::uint32_t context, unsigned depth);
  [[nodiscard]] bool has_nothing_more(std::uint32_t context, unsigned depth);

  const IndexedOntology& index_;
  const Saturation& saturation_;
  const OpenParts& open_;
  InverseRoles inverses_;
  CopyLimits copy_limits_;
  std::optional<Copies> copies_;
  std::vector<bool> is_heard_;     ///< by role: a rule or a test may tell whether there is a link of it
  std::vector<bool> is_composed_;  ///< by role: one of a chain whose result is heard
  std::vector<bool> is_failing_;   ///< by context
  std::vector<std::uint32_t> failing_;
  bool is_world_settled_ = true;
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  base::Rows<std::uint32_t> unions_of_;  ///< by atom: unions of which it is the whole
  std::vector<bool> is_plain_;           ///< by atom: nothing follows from it but what is told to be above it
  std::vector<std::vector<std::uint32_t>> parts_of_;  ///< by union: the representatives of its parts, ascending
  std::vector<std::uint32_t> union_of_;               ///< by context: the first open union of which it is in no part
  enum class Root : std::uint8_t { unknown, busy, open, settled };
  std::vector<Root> roots_;     ///< by context
  std::vector<bool> is_class_;  ///< by atom
  AtomsAbove above_;
  std::size_t steps_ = 0;
};

}  // namespace geminga::el

#endif
