// Brings rules into the form of the calculus, in which a body has concepts of the centre and roles to its neighbours.
//
// Only the neighbour's own context knows its concepts, so a body's atoms about a neighbour become a rule there (Bate et
// al., table 1). There are three ways, and the first that applies is taken:
//   B(y), R(x,y) -> H(x,y)          becomes  B(x), R(y,x) -> H(y,x)                    the neighbour is made the centre
//   A(x), B(y), R(x,y) -> H(x)      becomes  B(x), R(y,x) -> P(y)   A(x), P(x) -> H(x)         P names "some R.B"
//   A(x), B(y), R(x,y) -> H(x,y)    becomes  B(x), R(y,x) -> R'(y,x)   A(x), R'(x,y) -> H(x,y)  R' names "R into B"
#ifndef GEMINGA_REASONING_DL_CONSEQUENCE_RULES_CENTRED_RULES_HPP
#define GEMINGA_REASONING_DL_CONSEQUENCE_RULES_CENTRED_RULES_HPP

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "reasoning/dl/consequence/rules/rule.hpp"

namespace geminga::consequence {

/// Collects rules, and hands out numbers for new predicates and roles.
class CentredRules {
 public:
  /// New predicates and roles are numbered from these on.
  CentredRules(std::uint32_t predicate_count, std::uint32_t role_count)
      : predicate_count_(predicate_count), role_count_(role_count) {}

  /// Adds a rule whose body may speak of neighbours' concepts. A rule with a variable that is no neighbour is
  /// left out, and is a gap.
  void add(Atoms body, Atoms head);
  [[nodiscard]] std::uint32_t new_predicate() { return predicate_count_++; }

  /// Moves rules, counts and gaps into the set.
  void move_to(RuleSet& set);

 private:
  void add_rule(Atoms body, Atoms head);
  /// Replaces the centre's concepts in a long body by names for some of them.
  void shorten(Atoms& body);
  [[nodiscard]] std::uint32_t name_for(const Atoms& about_neighbour, bool is_role);

  std::uint32_t predicate_count_;
  std::uint32_t role_count_;
  std::vector<Rule> rules_;
  std::map<std::pair<Atoms, bool>, std::uint32_t> names_;
  std::vector<std::string> gaps_;
};

}  // namespace geminga::consequence

#endif
