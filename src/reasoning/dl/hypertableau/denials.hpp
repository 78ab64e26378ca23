// Names that only say what a thing is not: of complements of classes and of their unions.
//
// Where the clauses speak of a name Q of the translation in bodies  Q(x), C(x) -> false  alone, a model stays one when
// everything that is in no such C is put into Q. So an at-least with the filler Q is satisfied by a neighbour that is
// in none of them, whether or not somebody has derived Q of it, and needs no neighbour of its own.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_DENIALS_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_DENIALS_HPP

#include <cstdint>
#include <span>
#include <vector>

#include "reasoning/dl/clauses/clause.hpp"

namespace geminga::hypertableau {

class Denials {
 public:
  explicit Denials(const clauses::ClauseSet& set);

  [[nodiscard]] bool is_denial(std::uint32_t id) const { return is_denial_[id]; }
  /// What the denial says that a thing is not, ascending.
  [[nodiscard]] std::span<const std::uint32_t> denied(std::uint32_t id) const { return denied_[id]; }

 private:
  void look(const clauses::ClauseSet& set, const clauses::Clause& clause);

  std::vector<bool> is_denial_;                     ///< by concept
  std::vector<std::vector<std::uint32_t>> denied_;  ///< by concept
};

}  // namespace geminga::hypertableau

#endif
