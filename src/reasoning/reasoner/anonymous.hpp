// Anonymous individuals of a conclusion ("there is something such that"), rolled up into one class expression.
#ifndef GEMINGA_REASONING_REASONER_ANONYMOUS_HPP
#define GEMINGA_REASONING_REASONER_ANONYMOUS_HPP

#include <expected>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reasoning/reasoner/excerpt.hpp"

namespace geminga::reasoner {

/// Facts about anonymous individuals, rolled up into one class expression.
struct RolledUp {
  /// A named individual that must be in the expression. None: the expression must have some instance.
  std::optional<owl::TermId> individual;
  owl::TermId expression{};
  /// Facts that are about named individuals only, after blank nodes were replaced by names that are the same.
  std::vector<Statement> plain;
  bool has_expression = false;
};

/// Rolls up facts that share anonymous individuals; all are terms of the excerpt (Horrocks, Tessaris: Querying the
/// Semantic Web: a formal approach, 2002). Only a tree of at most 400 levels has such an expression. Otherwise the
/// error says why in one line.
[[nodiscard]] std::expected<RolledUp, std::string> roll_up(Excerpt& excerpt, std::vector<Statement> facts);

/// Groups facts that share anonymous individuals. Each group is ascending numbers of facts; facts without anonymous
/// individuals are in none.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> find_groups(const owl::Ontology& source,
                                                                  std::span<const std::uint32_t> axioms);

}  // namespace geminga::reasoner

#endif
