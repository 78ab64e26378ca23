// The clauses of a ClauseSet in the form in which they are matched: for each predicate, the plans that its facts
// trigger.
//
// Number restrictions are taken out of the clauses: they are looked at when a node has too many neighbours, not matched
// in all combinations of these. Legend as in clauses/clause.hpp.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_PROGRAM_PROGRAM_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_PROGRAM_PROGRAM_HPP

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "reasoning/dl/clauses/clause.hpp"
#include "reasoning/dl/hypertableau/program/backward_looks.hpp"
#include "reasoning/dl/hypertableau/program/bound.hpp"
#include "reasoning/dl/hypertableau/program/burdens.hpp"
#include "reasoning/dl/hypertableau/program/covers.hpp"
#include "reasoning/dl/hypertableau/program/denials.hpp"
#include "reasoning/dl/hypertableau/program/directions.hpp"
#include "reasoning/dl/hypertableau/program/domains.hpp"
#include "reasoning/dl/hypertableau/program/number_order.hpp"
#include "reasoning/dl/hypertableau/program/parts.hpp"
#include "reasoning/dl/hypertableau/program/union_names.hpp"

namespace geminga::hypertableau {

/// guard -> alternatives or the bound; all of the centre. Looked at when the bound is exceeded.
struct ConditionalBound {
  std::vector<clauses::Atom> guard;
  std::vector<clauses::Atom> alternatives;
};

enum class StepKind : std::uint8_t {
  check_concept,
  check_role,
  each_out,
  each_in,
  check_data,
  each_value,
  each_subject
};
struct Step {
  StepKind kind = StepKind::check_concept;
  clauses::Variable first = 0;
  clauses::Variable second = 0;
  std::uint32_t predicate = 0;
};

/// One body atom as the trigger, the order in which the others are looked for, and the head.
struct Plan {
  clauses::Variable first = 0;
  clauses::Variable second = 0;
  std::uint32_t steps_begin = 0;
  std::uint32_t steps_end = 0;
  std::uint32_t head_begin = 0;
  std::uint32_t head_end = 0;
};

class Program {
 public:
  /// With `counts` false, number restrictions are not compared, and at-leasts need what they say.
  explicit Program(const clauses::ClauseSet& set, bool counts = true);

  [[nodiscard]] std::span<const Plan> of_concept(std::uint32_t id) const { return by_concept_[id]; }
  [[nodiscard]] std::span<const Plan> of_role(std::uint32_t id) const { return by_role_[id]; }
  [[nodiscard]] std::span<const Plan> of_data_role(std::uint32_t id) const { return by_data_role_[id]; }
  [[nodiscard]] std::span<const Step> steps(const Plan& plan) const {
    return std::span(steps_).subspan(plan.steps_begin, plan.steps_end - plan.steps_begin);
  }
  [[nodiscard]] std::span<const clauses::Atom> head(const Plan& plan) const {
    return std::span(heads_).subspan(plan.head_begin, plan.head_end - plan.head_begin);
  }

  [[nodiscard]] const clauses::AtLeast& at_least(std::uint32_t id) const { return set_.at_leasts[id]; }
  [[nodiscard]] const clauses::DataAtLeast& data_at_least(std::uint32_t id) const { return set_.data_at_leasts[id]; }
  /// The individual whose nominal the concept is; nothing if it is no nominal, or the mark of a question.
  [[nodiscard]] std::optional<clauses::IndividualId> nominal(std::uint32_t id) const {
    if (id >= set_.concepts.size() || set_.concepts[id].kind != clauses::ConceptKind::nominal) return std::nullopt;
    return set_.concepts[id].individual;
  }

  [[nodiscard]] const Bound& bound(std::uint32_t id) const { return bounds_[id]; }
  [[nodiscard]] bool is_global(std::uint32_t bound) const { return is_global_[bound]; }
  [[nodiscard]] const std::vector<ConditionalBound>& conditional(std::uint32_t bound) const {
    return conditional_[bound];
  }
  /// Whether the bound holds of every node in the concept.
  [[nodiscard]] bool brings(std::uint32_t id, std::uint32_t bound) const;
  [[nodiscard]] std::span<const std::uint32_t> bounds_of_role(std::uint32_t id) const { return bounds_of_role_[id]; }
  [[nodiscard]] std::span<const std::uint32_t> bounds_of_data_role(std::uint32_t id) const {
    return bounds_of_data_role_[id];
  }
  [[nodiscard]] std::span<const std::uint32_t> bounds_of_filler(std::uint32_t id) const {
    return bounds_of_filler_[id];
  }
  [[nodiscard]] std::span<const std::uint32_t> bounds_of_guard(std::uint32_t id) const { return bounds_of_guard_[id]; }
  /// Concepts that exclude this one by clauses about one node, ascending; of those that stand in disjunctions,
  /// and of fillers of several neighbours.
  [[nodiscard]] std::span<const std::uint32_t> disjoint_concepts(std::uint32_t id) const {
    return disjoint_concepts_[id];
  }
  /// The concepts of which a clause says A(x) -> B(x) for this B.
  [[nodiscard]] std::span<const std::uint32_t> told_below(std::uint32_t id) const { return told_below_[id]; }
  /// Data properties that share no value with this one.
  [[nodiscard]] std::span<const std::uint32_t> disjoint_with(std::uint32_t id) const { return disjoint_with_[id]; }
  /// Bounds whose guard has a loop of the role.
  [[nodiscard]] std::span<const std::uint32_t> bounds_of_loop(std::uint32_t id) const { return bounds_of_loop_[id]; }
  /// The bound of an at_most or data_at_most atom of the clauses.
  [[nodiscard]] std::uint32_t bound_of_atom(const clauses::Atom& atom) const;

  /// The concepts that follow from an at-least; see domains.hpp.
  [[nodiscard]] const Domains& domains() const { return domains_; }
  /// Along which properties concepts and at-leasts speak of neighbours; see directions.hpp.
  [[nodiscard]] const Directions& directions() const { return directions_; }
  /// Fillers that a neighbour may have without being told; see denials.hpp.
  [[nodiscard]] const Denials& denials() const { return denials_; }
  /// Fillers in which a neighbour is by being in another concept; see union_names.hpp.
  [[nodiscard]] const UnionNames& unions() const { return unions_; }
  /// Fillers that hold of a node when their parts do; see parts.hpp.
  [[nodiscard]] const Parts& parts() const { return parts_; }
  /// The requirements of facts; see burdens.hpp.
  [[nodiscard]] const Burdens& burdens() const { return burdens_; }
  [[nodiscard]] bool counts() const { return counts_; }
  /// Requires counts(). Which number restrictions imply or exclude which others.
  [[nodiscard]] const NumberOrder& numbers() const { return numbers_; }
  /// Requires counts(). Which bounds cover the neighbours of an at-least together.
  [[nodiscard]] const Covers& covers() const { return covers_; }
  /// How many neighbours an at-least needs (clauses/counted_neighbours.hpp).
  [[nodiscard]] std::uint32_t needed(std::uint32_t at_least) const { return needed_[at_least]; }
  /// The concept, in no clause, of the thing that a question asks to be outside of another concept.
  [[nodiscard]] std::uint32_t mark_of_question() const { return domains_.concept_count(); }
  /// Whether every node needs the fact that it is in owl:Thing.
  [[nodiscard]] bool needs_thing() const { return needs_thing_; }
  /// Along which edges a node sees its parent, so that blocking must compare pairs; see backward_looks.hpp.
  [[nodiscard]] const BackwardLooks& backward_looks() const { return backward_looks_; }
  [[nodiscard]] bool has_nominals() const { return has_nominals_; }

 private:
  void compare_numbers();
  void add_clause(const clauses::Clause& clause);
  bool take_bound(const clauses::Clause& clause);
  bool take_disjointness(const clauses::Clause& clause);
  void add_plans(const clauses::Clause& clause);
  void add_plan(const clauses::Clause& clause, std::size_t trigger, std::uint32_t head_begin, std::uint32_t head_end);
  std::uint32_t index_of(const Bound& bound);
  void find_disjoint_concepts();
  void find_excluded(std::uint32_t id, const std::vector<std::vector<std::uint32_t>>& above,
                     const std::vector<std::vector<std::uint32_t>>& excluded);

  const clauses::ClauseSet& set_;
  Domains domains_;
  Directions directions_;
  Denials denials_;
  BackwardLooks backward_looks_;
  UnionNames unions_;
  Parts parts_;
  Burdens burdens_;
  std::vector<Step> steps_;
  std::vector<clauses::Atom> heads_;
  std::vector<std::vector<Plan>> by_concept_;
  std::vector<std::vector<Plan>> by_role_;
  std::vector<std::vector<Plan>> by_data_role_;
  std::vector<Bound> bounds_;
  std::map<Bound, std::uint32_t> index_;
  std::vector<bool> is_global_;
  std::vector<std::vector<ConditionalBound>> conditional_;
  std::vector<std::vector<std::uint32_t>> bounds_of_role_;
  std::vector<std::vector<std::uint32_t>> bounds_of_data_role_;
  std::vector<std::vector<std::uint32_t>> bounds_of_filler_;
  std::vector<std::vector<std::uint32_t>> bounds_of_guard_;
  std::vector<std::vector<std::uint32_t>> bounds_of_loop_;
  std::vector<std::vector<std::uint32_t>> told_below_;
  std::vector<std::vector<std::uint32_t>> disjoint_concepts_;
  std::vector<std::vector<std::uint32_t>> disjoint_with_;
  std::vector<std::uint32_t> bound_of_at_most_;
  std::vector<std::uint32_t> bound_of_data_at_most_;
  bool counts_;
  NumberOrder numbers_;
  Covers covers_;
  std::vector<std::uint32_t> needed_;  ///< by at-least
  bool needs_thing_ = false;
  bool has_nominals_ = false;
};

}  // namespace geminga::hypertableau

#endif
