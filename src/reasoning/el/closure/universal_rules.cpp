// The legend is in saturation.hpp.
#include "reasoning/el/closure/universal_rules.hpp"

#include <algorithm>
#include <vector>

#include "base/sorted.hpp"

namespace geminga::el {

//  C < D   C < Q
//  --------------- [D < R some E is told, Q < S only P, R <* S]
//  C -R-> E and P
std::uint32_t UniversalRules::successor_of(std::uint32_t context, const LinkRule& link) {
  const Context& self = contexts_[context];
  if (self.restricting.empty()) return conclusions_.require(link.root);
  std::vector<ExprId> together;
  for (const ExprId restricting : self.restricting) {
    for (const UniversalRule& rule : index_.universals(restricting)) {
      if (!index_.roles().is_sub_role(link.role, rule.role)) continue;
      if (!index_.is_told_below(link.target, rule.target)) together.push_back(rule.target);
    }
  }
  if (together.empty()) return conclusions_.require(link.root);
  if (link.root != index_.representative(top_expr)) together.push_back(link.root);
  base::sort_unique(together);
  return conclusions_.require_together(together);
}

// The second premise of successor_of() is new.
void UniversalRules::apply(std::uint32_t context, ExprId subsumer) {
  const auto rules = index_.universals(subsumer);
  if (rules.empty()) return;
  const Context& self = contexts_[context];
  const auto is_concerned = [&](RoleId role) {
    return std::ranges::any_of(rules,
                               [&](const UniversalRule& rule) { return index_.roles().is_sub_role(role, rule.role); });
  };
  for (std::uint32_t at = 0; at < self.subsumers_done; ++at) {
    const std::uint32_t known = self.subsumers[at];
    if (known >= index_.size() || !index_.has_rules(ExprId{known}, RuleBits::links)) continue;
    for (const LinkRule& link : index_.links(ExprId{known})) {
      if (is_concerned(link.role)) conclusions_.add_link(context, link.role, successor_of(context, link));
    }
  }
  for (std::uint32_t at = 0; at < self.selfs_done; ++at) apply_to_self(context, self.selfs[at]);
}

//  C < R Self   C < Q
//  ------------------ [Q < S only P, R <* S]
//  C < P
void UniversalRules::apply_to_self(std::uint32_t context, RoleId role) {
  std::vector<ExprId> found;
  for (const ExprId restricting : contexts_[context].restricting) {
    for (const UniversalRule& rule : index_.universals(restricting)) {
      if (index_.roles().is_sub_role(role, rule.role)) found.push_back(rule.target);
    }
  }
  for (const ExprId target : found) conclusions_.add_atom(context, target);
}

}  // namespace geminga::el
