// Union names: names of the translation of which clauses say only that an instance is in one of several concepts.
//
// Suppose that a name Q occurs in bodies only in one clause  Q(x) -> B1(x) or ... or Bn(x).  Then a model stays a model
// when everything in some Bi is put into Q. So a neighbour in Bi is one that an at-least with the filler Q asks for,
// even if Q is not derived of it.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_PROGRAM_UNION_NAMES_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_PROGRAM_UNION_NAMES_HPP

#include <cstdint>
#include <span>
#include <vector>

#include "reasoning/dl/clauses/clause.hpp"

namespace geminga::hypertableau {

class UnionNames {
 public:
  explicit UnionNames(const clauses::ClauseSet& set);

  /// The concepts B1, ..., Bn; none if the concept is no such name.
  [[nodiscard]] std::span<const std::uint32_t> alternatives(std::uint32_t id) const { return alternatives_[id]; }

 private:
  std::vector<std::vector<std::uint32_t>> alternatives_;  ///< by concept
};

}  // namespace geminga::hypertableau

#endif
