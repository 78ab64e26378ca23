// The rules that the saturation uses, indexed by the atoms of their bodies, without those that cannot matter.
#ifndef GEMINGA_REASONING_DL_CONSEQUENCE_RULES_RULES_HPP
#define GEMINGA_REASONING_DL_CONSEQUENCE_RULES_RULES_HPP

#include <cstdint>
#include <span>
#include <vector>

#include "base/rows.hpp"
#include "reasoning/dl/consequence/rules/rule.hpp"

namespace geminga::consequence {

/// An atom in the body of a rule.
struct Occurrence {
  std::uint32_t rule = 0;
  std::uint32_t atom = 0;
};

/// Constant once it is made, so that threads can share it.
///
/// Role inclusions are not rules. A rule with R(s,t) in its head stands for one with S(s,t) for each super-role S of R
/// that occurs in a body, because R(s,t) itself can do no more than that. A predicate that occurs in no body can be
/// true everywhere, so that a clause with it in the head says nothing (a pure literal): such rules are dropped. Open
/// predicates are kept, because the gaps depend on where they may hold.
class Rules {
 public:
  explicit Rules(RuleSet rule_set);

  [[nodiscard]] const Rule& rule(std::uint32_t index) const { return rule_set_.rules[index]; }
  /// A < L for one literal L over x.
  [[nodiscard]] std::span<const Literal> told(std::uint32_t predicate) const { return told_[predicate]; }
  /// All other rules whose body has A(x), R(x, y) or, if `is_incoming`, R(y, x), or R(x, x).
  [[nodiscard]] std::span<const Occurrence> with_unary(std::uint32_t predicate) const { return unary_[predicate]; }
  [[nodiscard]] std::span<const Occurrence> with_role(std::uint32_t role, bool is_incoming) const {
    return roles_[role * 2 + (is_incoming ? 1 : 0)];
  }
  [[nodiscard]] std::span<const Occurrence> with_reflexive(std::uint32_t role) const { return reflexive_[role]; }
  /// Rules with an empty body.
  [[nodiscard]] std::span<const std::uint32_t> always() const { return always_; }

  /// Whether a literal may be passed to a successor (Su(O) in the paper). It is in the names of the successor's
  /// context.
  [[nodiscard]] bool is_trigger(Literal literal) const {
    switch (literal.kind()) {
      case LiteralKind::unary:
        return is_unary_trigger_[literal.predicate()];
      case LiteralKind::incoming:
        return !roles_[std::size_t{literal.predicate()} * 2 + 1].empty();
      case LiteralKind::outgoing:
        return !roles_[std::size_t{literal.predicate()} * 2].empty();
      default:
        return true;
    }
  }
  /// The successors that an "at least" creates. nullptr for other predicates.
  [[nodiscard]] const Expansion* expansion(std::uint32_t predicate) const {
    const std::uint32_t index = predicate - rule_set_.first_marker;
    return index < rule_set_.expansions.size() ? &rule_set_.expansions[index] : nullptr;
  }
  /// Whether f and g come from the same "at least", so that f(x) and g(x) are different.
  [[nodiscard]] bool are_siblings(std::uint32_t f, std::uint32_t g) const { return marker_of_[f] == marker_of_[g]; }
  [[nodiscard]] std::uint32_t first_sibling(std::uint32_t f) const {
    return rule_set_.expansions[marker_of_[f]].first_function;
  }
  /// Whether f(x) is a value.
  [[nodiscard]] bool is_value(std::uint32_t f) const { return rule_set_.expansions[marker_of_[f]].is_value; }
  /// Whether the literal is a B(x) that may be asked for. In contexts that answer questions none of these is above
  /// another.
  [[nodiscard]] bool is_query(Literal literal) const {
    return literal.term() == x_term && literal.kind() == LiteralKind::unary &&
           literal.predicate() < rule_set_.query_count;
  }
  [[nodiscard]] bool is_open(std::uint32_t predicate) const { return rule_set_.is_open[predicate]; }
  [[nodiscard]] bool is_nominal(std::uint32_t predicate) const { return is_nominal_[predicate]; }
  [[nodiscard]] bool has_nominals() const { return !rule_set_.nominal_of.empty(); }
  [[nodiscard]] const RuleSet& vocabulary() const { return rule_set_; }

 private:
  void take_out_inclusions();
  void drop_pure();
  void mark_used();
  [[nodiscard]] bool is_used(const RuleAtom& atom);
  void expand_heads();
  void index();
  /// The super-roles of this role that occur in bodies, with whether they are inverted.
  [[nodiscard]] const std::vector<RuleAtom>& supers(std::uint32_t role);
  [[nodiscard]] std::vector<std::vector<RuleAtom>> expanded(const std::vector<RuleAtom>& head);

  RuleSet rule_set_;
  base::Rows<RuleAtom> inclusions_;  ///< of each role; predicate: what is above it, incoming: turned round
  std::vector<bool> is_used_unary_;
  std::vector<bool> is_used_role_;
  std::vector<std::vector<RuleAtom>> supers_;
  std::vector<bool> has_supers_;
  base::Rows<Literal> told_;
  base::Rows<Occurrence> unary_;
  std::vector<std::vector<Occurrence>> roles_;
  std::vector<std::vector<Occurrence>> reflexive_;
  std::vector<std::uint32_t> always_;
  std::vector<bool> is_unary_trigger_;
  std::vector<std::uint32_t> marker_of_;  ///< of each function, the index of its expansion
  std::vector<bool> is_nominal_;
};

}  // namespace geminga::consequence

#endif
