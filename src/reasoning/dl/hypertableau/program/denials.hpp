// Denials: names of complements of classes, of restrictions, and of unions of both.
//
// Suppose that a name Q of the translation occurs in bodies only in clauses  Q(x), G -> false  where G speaks of x and
// one neighbour of x, and of no other name. Then a model stays a model when everything of which no such G holds is put
// into Q. So an at-least with the filler Q is satisfied by a neighbour of which no such G holds, even if Q is not
// derived of it. It needs no neighbour of its own.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_PROGRAM_DENIALS_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_PROGRAM_DENIALS_HPP

#include <cstdint>
#include <span>
#include <vector>

#include "reasoning/dl/clauses/clause.hpp"

namespace geminga::hypertableau {

/// A combination that a clause of a denial forbids: concepts of a node together, or with a neighbour.
struct Forbidden {
  std::vector<std::uint32_t> concepts;            ///< of the node
  std::vector<clauses::Atom> roles;               ///< from or to the neighbour, which is the variable 1; may be empty
  std::vector<std::uint32_t> neighbour_concepts;  ///< none without roles
};

class Denials {
 public:
  explicit Denials(const clauses::ClauseSet& set);

  [[nodiscard]] bool is_denial(std::uint32_t id) const { return is_denial_[id]; }
  /// The concepts that the denial excludes, ascending.
  [[nodiscard]] std::span<const std::uint32_t> denied(std::uint32_t id) const { return denied_[id]; }
  /// The combinations that it excludes besides.
  [[nodiscard]] std::span<const Forbidden> forbidden(std::uint32_t id) const { return forbidden_[id]; }
  /// Whether a denial looks at neighbours.
  [[nodiscard]] bool look_around() const;

 private:
  void look(const clauses::ClauseSet& set, const clauses::Clause& clause);
  void add(std::uint32_t id, const clauses::Clause& clause);

  std::vector<bool> is_denial_;                     ///< by concept
  std::vector<std::vector<std::uint32_t>> denied_;  ///< by concept
  std::vector<std::vector<Forbidden>> forbidden_;   ///< by concept
};

}  // namespace geminga::hypertableau

#endif
