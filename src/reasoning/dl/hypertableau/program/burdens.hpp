// Burdens: an estimate of the nodes that a fact will ask for, from the clauses alone.
//
// Where nothing is known of two alternatives, the one with the smaller burden is tried first. So a thing that is in a
// class or has a neighbour outside of it gets the neighbour if the class asks for many, and is in the class if the
// class asks for none. Both orders lead to models. The better one leads to a model of a few nodes instead of thousands.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_PROGRAM_BURDENS_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_PROGRAM_BURDENS_HPP

#include <cstdint>
#include <vector>

#include "reasoning/dl/clauses/clause.hpp"
#include "reasoning/dl/hypertableau/program/denials.hpp"
#include "reasoning/dl/hypertableau/program/domains.hpp"

namespace geminga::hypertableau {

/// Nodes that are asked for within a few levels, by clauses with one concept in the body. A union costs as much as its
/// cheapest part.
class Burdens {
 public:
  static constexpr std::uint32_t most = 1'000'000;

  Burdens(const clauses::ClauseSet& set, const Domains& domains, const Denials& denials);

  /// Of a concept, also of one of the domains.
  [[nodiscard]] std::uint32_t of_concept(std::uint32_t id) const { return of_concept_[id]; }
  /// Of an at-least restriction: its neighbours, and those that they ask for.
  [[nodiscard]] std::uint32_t of_at_least(std::uint32_t index) const { return of_at_least_[index]; }
  /// The same beside a neighbour of which they speak: a universal asks for what its filler does, and an at-least of a
  /// denial (denials.hpp) for nothing, because most neighbours satisfy it.
  [[nodiscard]] std::uint32_t of_concept_beside(std::uint32_t id) const { return of_concept_beside_[id]; }
  [[nodiscard]] std::uint32_t of_at_least_beside(std::uint32_t index) const { return of_at_least_beside_[index]; }

 private:
  void look(const clauses::Clause& clause, std::vector<std::uint64_t>& sums) const;
  void look_beside(const clauses::Clause& clause);
  void weigh_at_leasts(const clauses::ClauseSet& set, const Domains& domains);
  [[nodiscard]] std::uint64_t burden_of(const clauses::Atom& atom) const;

  std::vector<std::uint32_t> of_concept_;
  std::vector<std::uint32_t> of_at_least_;
  std::vector<std::uint32_t> of_concept_beside_;
  std::vector<std::uint32_t> of_at_least_beside_;
  std::vector<std::vector<std::uint32_t>>
      ranges_;  ///< by property, then that of its inverse: concepts of the neighbour
};

}  // namespace geminga::hypertableau

#endif
