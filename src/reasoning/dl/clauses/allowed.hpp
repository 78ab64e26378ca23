// Finds constructs in an axiom that OWL 2 DL forbids or that are beyond a limit. Such an axiom has no clauses.
#ifndef GEMINGA_REASONING_DL_CLAUSES_ALLOWED_HPP
#define GEMINGA_REASONING_DL_CLAUSES_ALLOWED_HPP

#include <cstdint>
#include <map>
#include <string_view>
#include <tuple>

#include "reasoning/dl/clauses/literal.hpp"
#include "reasoning/dl/clauses/vocabulary.hpp"
#include "reasoning/owl/role_box.hpp"

namespace geminga::clauses {

/// Looks through expressions with their signs (OWL 2 structural specification, section 11.2). A minimum cardinality of
/// a property that is not simple is allowed if its complement does not occur: it is exact, because edges are paths.
class Allowed {
 public:
  Allowed(Vocabulary& vocabulary, const owl::RoleBox& roles, std::uint32_t max_cardinality)
      : vocabulary_(vocabulary), roles_(roles), max_cardinality_(max_cardinality) {}

  /// Why the literal has no clauses where it is asserted. Empty if it has.
  [[nodiscard]] std::string_view problem(Literal literal);
  [[nodiscard]] bool is_simple(owl::TermId property);
  [[nodiscard]] bool is_top_data(owl::TermId property) const;

 private:
  [[nodiscard]] std::string_view problem_of(const Shape& shape);

  Vocabulary& vocabulary_;
  const owl::RoleBox& roles_;
  std::uint32_t max_cardinality_;
  std::map<std::tuple<owl::TermId, bool, Part>, std::string_view> known_;
};

}  // namespace geminga::clauses

#endif
