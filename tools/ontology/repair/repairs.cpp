#include "ontology/repair/repairs.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

#include "reasoning/explanation/hitting_sets.hpp"

namespace geminga::ontology {
namespace {

using explanation::AxiomSet;

AxiomSet joined(AxiomSet one, const AxiomSet& other) {
  one.insert(one.end(), other.begin(), other.end());
  std::ranges::sort(one);
  return one;
}

/// The search, round by round.
class Search {
 public:
  Search(Unwanted& unwanted, const RepairLimits& limits, base::Budget& budget)
      : unwanted_(unwanted), limits_(limits), budget_(budget) {}

  Repairs run() {
    if (learn({}) != Learned::a_reason) return std::move(repairs_);
    for (std::size_t round = 0; round < limits_.rounds && reasons_.size() <= limits_.reasons; ++round) {
      group();
      if (!is_open()) return std::move(repairs_);
    }
    doubt("there are too many reasons");
    return std::move(repairs_);
  }

 private:
  void doubt(std::string why) {
    repairs_.is_certain = false;
    repairs_.why_not = std::move(why);
  }

  enum class Learned : std::uint8_t {
    nothing_left,  ///< nothing unwanted is known to follow
    a_reason,      ///< something follows, for a reason that was not known
    no_reason,     ///< something follows, and no reason was found
  };

  /// Looks for reasons that these axioms do not hit.
  Learned learn(const AxiomSet& removed) {
    const Following following = unwanted_.following_without(removed);
    const std::size_t known = reasons_.size();
    std::size_t asked = 0;
    for (const Subsumption& one : following.certain) {
      if (asked++ == limits_.in_a_round || budget_.is_spent()) break;
      auto reason = unwanted_.reason_without(one, removed);
      if (!reason || reason->empty() || budget_.is_spent()) continue;
      subs_[*reason].insert(one.sub);
      if (std::ranges::find(reasons_, *reason) == reasons_.end()) reasons_.push_back(std::move(*reason));
    }
    if (reasons_.size() > known) return Learned::a_reason;
    if (budget_.is_spent()) {
      doubt(*budget_.reason());
    } else if (!following.certain.empty()) {
      doubt("no engine found within its limits which axioms are the reasons");
    } else if (following.may_be_more) {
      doubt("the engines leave open whether there are others");
    }
    return following.certain.empty() ? Learned::nothing_left : Learned::no_reason;
  }

  /// Makes the groups of the known reasons, with their choices.
  void group() {
    repairs_.groups.clear();
    for (const std::vector<AxiomSet>& reasons : explanation::groups_of(reasons_)) {
      auto choices = explanation::find_hitting_sets(reasons, {.sets = limits_.choices, .nodes = limits_.nodes});
      RepairGroup& made = repairs_.groups.emplace_back();
      made.choices = std::move(choices.sets);
      std::erase_if(made.choices, [&](const AxiomSet& choice) { return useless_.contains(choice); });
      made.may_have_more = choices.may_have_more;
      std::set<taxonomy::ClassNumber> subs;
      for (const AxiomSet& reason : reasons) subs.insert(subs_[reason].begin(), subs_[reason].end());
      made.subs.assign(subs.begin(), subs.end());
    }
  }

  /// Whether the groups are to be made anew, because some choice leaves something unwanted.
  bool is_open() {
    for (const RepairGroup& one : repairs_.groups) {
      if (one.choices.empty()) {
        doubt("no choice undoes one of the groups, or it has too many reasons");
        return false;
      }
    }
    for (std::size_t at = 0; at < repairs_.groups.size(); ++at) {
      for (const AxiomSet& choice : repairs_.groups[at].choices) {
        AxiomSet removed = choice;
        for (std::size_t other = 0; other < repairs_.groups.size(); ++other) {
          if (other != at) removed = joined(std::move(removed), repairs_.groups[other].choices.front());
        }
        if (!asked_.insert(removed).second) continue;
        const Learned learned = learn(removed);
        if (budget_.is_spent()) return false;
        if (learned == Learned::no_reason) useless_.insert(choice);
        if (learned != Learned::nothing_left) return true;
      }
    }
    return false;
  }

  Unwanted& unwanted_;
  const RepairLimits& limits_;
  base::Budget& budget_;
  std::vector<AxiomSet> reasons_;
  std::map<AxiomSet, std::set<taxonomy::ClassNumber>> subs_;
  std::set<AxiomSet> asked_;    ///< sets that were taken out
  std::set<AxiomSet> useless_;  ///< choices with which something unwanted is left
  Repairs repairs_;
};

}  // namespace

Repairs find_repairs(Unwanted& unwanted, const RepairLimits& limits, base::Budget& budget) {
  return Search(unwanted, limits, budget).run();
}

}  // namespace geminga::ontology
