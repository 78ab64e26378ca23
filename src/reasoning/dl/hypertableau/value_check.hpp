// Whether the values of a model under construction exist: constants, ranges, and which must differ.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_VALUE_CHECK_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_VALUE_CHECK_HPP

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "reasoning/dl/clauses/clause.hpp"
#include "reasoning/dl/hypertableau/graph.hpp"

namespace geminga::owl {
class Ontology;
}

namespace geminga::hypertableau {

/// As many attempts are made to give values that must differ to the nodes of one group; beyond, it is not known
/// whether there are enough.
inline constexpr std::size_t max_value_attempts = 100'000;

/// Knows the value spaces of one ClauseSet.
class ValueCheck {
 public:
  ValueCheck(const owl::Ontology& source, const clauses::ClauseSet& set);
  ~ValueCheck();

  /// Whether a literal is in a data range; nothing where it cannot be known.
  [[nodiscard]] std::optional<bool> is_in(owl::TermId literal, std::uint32_t range);
  /// Whether two literals certainly have different values.
  [[nodiscard]] bool are_different(owl::TermId first, owl::TermId second);
  /// The first literal that was asked about with the same value.
  [[nodiscard]] owl::TermId representative(owl::TermId literal);
  /// The facts because of which the values that are active cannot all exist; nothing where they can. `unknown` is set
  /// to a reason where that could not be found out.
  [[nodiscard]] std::optional<DependencySet> clash(const Graph& graph, DependencySets& sets, std::string& unknown);

 private:
  class Problem;
  std::unique_ptr<Problem> problem_;
};

}  // namespace geminga::hypertableau

#endif
