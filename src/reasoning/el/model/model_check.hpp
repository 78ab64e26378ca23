// The model check: finds the classes whose subsumers are all known although the rules do not use every axiom.
//
// The contexts that have instances form a model of the axioms that the rules use. Each context is an element: it
// belongs to its subsumers and has its links; a tree grows from each, whose branches end in the individuals. If this
// model satisfies the other axioms as well, what was not derived does not follow. The check looks at what the other
// axioms demand of each element. A class whose context leads to one that fails is not settled. The check is on the safe
// side: what it does not look at counts as failing. SuccessorContexts of successors (copies.hpp) show what inverses say
// to successors; what inverses say back is derived.
//
// If x is in A or B but known in neither, the model may put x in either part that lies below all other subsumers of x.
// For a successor, one part suffices that tells its source nothing new. For a class, an atom that is not above all such
// parts is not above the class.
//
// README.md says on which ontologies the check pays.
#ifndef GEMINGA_REASONING_EL_MODEL_MODEL_CHECK_HPP
#define GEMINGA_REASONING_EL_MODEL_MODEL_CHECK_HPP

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "base/rows.hpp"
#include "reasoning/el/closure/atoms_above.hpp"
#include "reasoning/el/closure/saturation.hpp"
#include "reasoning/el/index/open_parts.hpp"
#include "reasoning/el/model/inverse_roles.hpp"
#include "reasoning/el/model/successor_contexts.hpp"

namespace geminga::el {

class ModelCheck {
 public:
  /// Requires a saturation that has ended within its limits and without contradiction, and that `open` holds all axioms
  /// that it does not use. Completeness is tested for `classes` (representatives) only.
  ModelCheck(const IndexedOntology& index, const Saturation& saturation, const OpenParts& open,
             std::span<const ExprId> classes, const SuccessorLimits& limits = {});

  /// True if all subsumers of the atom are known, provided that the ontology is consistent.
  [[nodiscard]] bool is_settled(ExprId atom);
  /// Conclusions from inverses that the saturation lacks; while there are any, nothing is settled.
  [[nodiscard]] SuccessorContexts::Derived derived() const {
    return successors_ ? successors_->derived() : SuccessorContexts::Derived{};
  }
  /// True if the budget ended the check; then nothing is settled.
  [[nodiscard]] bool is_cut_off() const { return successors_ && successors_->is_cut_off(); }
  /// True if everything that must have an instance is settled; then the ontology is consistent.
  [[nodiscard]] bool is_world_settled() const { return is_world_settled_; }

 private:
  void find_heard();
  void test_contexts();
  void test_link(std::uint32_t from, RoleId role, std::uint32_t to);
  [[nodiscard]] bool is_implied_satisfied(std::uint32_t from, RoleId role, std::uint32_t to);
  [[nodiscard]] bool is_backward_link_satisfied(std::uint32_t from, RoleId role, std::uint32_t to);
  [[nodiscard]] bool knows_what_it_learns(std::uint32_t from, RoleId role, std::uint32_t to);
  void make_successors();
  void spread_to_successors();
  [[nodiscard]] bool is_link_satisfied(std::uint32_t from, RoleId role, std::uint32_t to, bool is_backward);
  /// Defined for atoms that have rules or are watched.
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
  SuccessorLimits limits_;
  std::optional<SuccessorContexts> successors_;
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
