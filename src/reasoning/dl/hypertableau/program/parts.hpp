// Parts: what a filler without a name of its own consists of.
//
// Suppose that a name Q of the translation occurs in bodies only in clauses  Q(x) -> P  with one part P, which is a
// concept or an at-least of x. Then a model stays a model when everything of which all parts hold is put into Q. So an
// at-least with the filler Q is satisfied by a neighbour of which the parts hold, even if Q is not derived of it:
// cousin = has_parent some (person and (has_sibling some parent)) asks for no parent beside the one by which somebody
// is found to be a cousin.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_PROGRAM_PARTS_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_PROGRAM_PARTS_HPP

#include <cstdint>
#include <span>
#include <vector>

#include "reasoning/dl/clauses/clause.hpp"

namespace geminga::hypertableau {

class Parts {
 public:
  explicit Parts(const clauses::ClauseSet& set);

  /// Whether the concept may be put wherever its parts hold.
  [[nodiscard]] bool has_parts(std::uint32_t id) const { return !parts_[id].empty(); }
  /// Concepts and at-leasts of one node; none where the concept has other consequences.
  [[nodiscard]] std::span<const clauses::Atom> of(std::uint32_t id) const { return parts_[id]; }

 private:
  std::vector<std::vector<clauses::Atom>> parts_;  ///< by concept
};

}  // namespace geminga::hypertableau

#endif
