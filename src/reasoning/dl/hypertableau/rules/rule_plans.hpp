// The orders in which the atoms of rules are matched.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_RULES_RULE_PLANS_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_RULES_RULE_PLANS_HPP

#include <cstdint>
#include <span>
#include <vector>

#include "reasoning/dl/clauses/clause.hpp"

namespace geminga::hypertableau {

/// Looks at an atom of the body, or lets a variable be each named individual.
struct RuleStep {
  bool is_enumeration = false;
  std::uint16_t number = 0;  ///< of the atom or variable
};

/// A rule, the atom that a new fact matches, and what is left to match.
struct RulePlan {
  std::uint32_t rule = 0;
  std::uint32_t trigger = 0;
  std::vector<RuleStep> steps;
};

/// The plans of all rules of a clause set.
class RulePlans {
 public:
  explicit RulePlans(const clauses::ClauseSet& set);

  [[nodiscard]] std::span<const RulePlan> of_concept(std::uint32_t id) const { return at(by_concept_, id); }
  [[nodiscard]] std::span<const RulePlan> of_role(std::uint32_t id) const { return at(by_role_, id); }
  [[nodiscard]] std::span<const RulePlan> of_data_role(std::uint32_t id) const { return at(by_data_role_, id); }
  /// By rule: all of its atoms.
  [[nodiscard]] const RulePlan& whole(std::uint32_t rule) const { return whole_[rule]; }
  /// Whether no atom of the rule's body is unknown.
  [[nodiscard]] bool is_known(std::uint32_t rule) const { return is_known_[rule]; }
  /// Rules without triggers. They are matched when it changes which individuals there are.
  [[nodiscard]] std::span<const std::uint32_t> untriggered() const { return untriggered_; }
  /// Rules about properties that are not simple. They are matched again after every new fact.
  [[nodiscard]] std::span<const std::uint32_t> about_paths() const { return about_paths_; }

 private:
  using Table = std::vector<std::vector<RulePlan>>;
  [[nodiscard]] static std::span<const RulePlan> at(const Table& table, std::uint32_t id) {
    return id < table.size() ? std::span<const RulePlan>(table[id]) : std::span<const RulePlan>();
  }

  Table by_concept_;
  Table by_role_;
  Table by_data_role_;
  std::vector<RulePlan> whole_;
  std::vector<bool> is_known_;  ///< by rule
  std::vector<std::uint32_t> untriggered_;
  std::vector<std::uint32_t> about_paths_;
};

}  // namespace geminga::hypertableau

#endif
