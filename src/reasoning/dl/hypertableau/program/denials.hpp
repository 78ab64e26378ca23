// Denials: names of complements of classes and of unions of complements.
//
// If a name Q of the translation occurs only in clauses  Q(x), C(x) -> false,  a model stays a model when
// everything that is in no such C is put into Q. So an at-least with the filler Q is satisfied by a neighbour that is
// in no such C, even if Q is not derived of it. It needs no neighbour of its own.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_PROGRAM_DENIALS_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_PROGRAM_DENIALS_HPP

#include <cstdint>
#include <span>
#include <vector>

#include "reasoning/dl/clauses/clause.hpp"

namespace geminga::hypertableau {

class Denials {
 public:
  explicit Denials(const clauses::ClauseSet& set);

  [[nodiscard]] bool is_denial(std::uint32_t id) const { return is_denial_[id]; }
  /// The concepts that the denial excludes, ascending.
  [[nodiscard]] std::span<const std::uint32_t> denied(std::uint32_t id) const { return denied_[id]; }

 private:
  void look(const clauses::ClauseSet& set, const clauses::Clause& clause);

  std::vector<bool> is_denial_;                     ///< by concept
  std::vector<std::vector<std::uint32_t>> denied_;  ///< by concept
};

}  // namespace geminga::hypertableau

#endif
