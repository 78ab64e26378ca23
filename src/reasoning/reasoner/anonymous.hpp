// Anonymous individuals of a conclusion: "there is something such that", rolled up into one class expression.
#ifndef GEMINGA_REASONING_REASONER_ANONYMOUS_HPP
#define GEMINGA_REASONING_REASONER_ANONYMOUS_HPP

#include <expected>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reasoning/reasoner/excerpt.hpp"

namespace geminga::reasoner {

/// What facts about anonymous individuals say together.
struct RolledUp {
  /// An individual with a name that is in the expression; nothing: something is.
  std::optional<owl::TermId> individual;
  owl::TermId expression{};
  /// Facts that speak of named individuals only, once names were put in for blank nodes that are the same.
  std::vector<Statement> plain;
  bool has_expression = false;
};

/// Rolls up facts that hang together by their anonymous individuals, all of them terms of the excerpt (Horrocks,
/// Tessaris: Querying the Semantic Web: a formal approach, 2002). What is no tree of at most 400 levels has no such
/// expression; then the error says so in one line.
[[nodiscard]] std::expected<RolledUp, std::string> roll_up(Excerpt& excerpt, std::vector<Statement> facts);

/// The groups of facts that hang together: the numbers of those with anonymous individuals, each group ascending.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> find_groups(const owl::Ontology& source,
                                                                  std::span<const std::uint32_t> axioms);

}  // namespace geminga::reasoner

#endif
