// Domains: concepts of a node that follow from its at-least restrictions, before it has a neighbour.
//
// A clause  A(x), R(x,y) -> H(x)  does not care which y. An at-least of R or of a role below it is enough for it, so a
// concept "has an R-neighbour" is derived from the restriction itself and stands for R(x,y) in a copy of the clause:
// clashes and choices are seen before neighbours are made.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_PROGRAM_DOMAINS_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_PROGRAM_DOMAINS_HPP

#include <compare>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "reasoning/dl/clauses/clause.hpp"

namespace geminga::hypertableau {

class Domains {
 public:
  /// The new concepts are numbered behind those of the set.
  explicit Domains(const clauses::ClauseSet& set);

  [[nodiscard]] std::uint32_t concept_count() const { return concept_count_; }
  [[nodiscard]] const std::vector<clauses::Clause>& clauses() const { return clauses_; }
  [[nodiscard]] std::span<const std::uint32_t> of_at_least(std::uint32_t index) const { return of_at_least_[index]; }
  [[nodiscard]] std::span<const std::uint32_t> of_data_at_least(std::uint32_t index) const {
    return of_data_at_least_[index];
  }

 private:
  struct Direction {
    bool is_data = false;
    std::uint32_t property = 0;
    bool is_inverse = false;
    friend auto operator<=>(const Direction&, const Direction&) = default;
  };
  void copy(const clauses::Clause& clause);
  void note_hierarchy(const clauses::Clause& clause);
  [[nodiscard]] std::vector<std::uint32_t> implied_by(const Direction& start) const;

  std::uint32_t concept_count_;
  std::map<Direction, std::uint32_t> concepts_;
  std::map<Direction, std::vector<Direction>> above_;
  std::vector<clauses::Clause> clauses_;
  std::vector<std::vector<std::uint32_t>> of_at_least_;
  std::vector<std::vector<std::uint32_t>> of_data_at_least_;
};

}  // namespace geminga::hypertableau

#endif
