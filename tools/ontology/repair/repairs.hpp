// Least sets of axioms to take out so that nothing unwanted follows: one choice of each group.
//
// The reasons of what is unwanted are minimal sets of axioms. Those that share axioms make a group, whose least hitting
// sets are the choices. Reasons are looked for only while the choices do not undo everything, so that few of the
// exponentially many are found.
#ifndef GEMINGA_ONTOLOGY_REPAIR_REPAIRS_HPP
#define GEMINGA_ONTOLOGY_REPAIR_REPAIRS_HPP

#include <cstddef>
#include <string>
#include <vector>

#include "ontology/repair/unwanted.hpp"
#include "reasoning/explanation/explanations.hpp"

namespace geminga::ontology {

/// The limits of a search.
struct RepairLimits {
  std::size_t choices = 16;     ///< of one group
  std::size_t rounds = 1'000;   ///< in which reasons are looked for
  std::size_t reasons = 2'000;  ///< in all
  std::size_t in_a_round = 16;  ///< classes for which a reason is looked for in one round
  std::size_t nodes = 20'000;   ///< of the tree of hitting sets of one group
};

/// A group of reasons that share axioms.
struct RepairGroup {
  std::vector<taxonomy::ClassNumber> subs;     ///< of the subsumptions with these reasons, ascending
  std::vector<explanation::AxiomSet> choices;  ///< axioms of the module; the smallest first
  bool may_have_more = false;                  ///< there are other choices
};

/// One choice of each group, taken out together, undoes everything that is unwanted. This was asked of the engines for
/// every choice beside the first ones of the other groups.
struct Repairs {
  std::vector<RepairGroup> groups;
  /// Nothing unwanted is left with these choices. False: a limit was reached, or the engines left a question open.
  bool is_certain = true;
  std::string why_not{};  ///< where it is not certain: one line
};

[[nodiscard]] Repairs find_repairs(Unwanted& unwanted, const RepairLimits& limits, base::Budget& budget);

}  // namespace geminga::ontology

#endif
