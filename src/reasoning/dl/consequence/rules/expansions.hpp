// The expansions of a rule set, and the function symbols that they use.
#ifndef GEMINGA_REASONING_DL_CONSEQUENCE_RULES_EXPANSIONS_HPP
#define GEMINGA_REASONING_DL_CONSEQUENCE_RULES_EXPANSIONS_HPP

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "reasoning/dl/consequence/rules/rule.hpp"

namespace geminga::consequence {

class Expansions {
 public:
  /// Roles from `first_data_role` on lead to values.
  Expansions(std::uint32_t first_marker, std::uint32_t first_data_role)
      : first_marker_(first_marker), first_data_role_(first_data_role) {}

  /// Adds an expansion and returns its predicate. With too many function symbols it creates nothing, and is a gap.
  std::uint32_t add(std::uint32_t count, Atoms atoms) {
    Expansion& expansion = expansions_.emplace_back();
    const bool is_value = std::ranges::any_of(
        atoms, [this](const RuleAtom& atom) { return is_role_atom(atom) && atom.predicate >= first_data_role_; });
    if (count > max_functions - functions_) {
      gaps_.push_back("more than " + std::to_string(max_functions) + " successors are named");
    } else {
      expansion = {functions_, count, std::move(atoms), is_value};
      functions_ += count;
    }
    return first_marker_ + static_cast<std::uint32_t>(expansions_.size() - 1);
  }

  /// Moves expansions and gaps into the set.
  void move_to(RuleSet& set) {
    set.expansions = std::move(expansions_);
    set.gaps.insert(set.gaps.end(), gaps_.begin(), gaps_.end());
  }

 private:
  std::uint32_t first_marker_;
  std::uint32_t first_data_role_;
  std::uint32_t functions_ = 0;
  std::vector<Expansion> expansions_;
  std::vector<std::string> gaps_;
};

}  // namespace geminga::consequence

#endif
