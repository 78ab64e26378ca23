// The rules for universals: what restricts the successors of a context; the legend is in saturation.hpp.
//
// A successor that is restricted is another one than that of which the axiom speaks: its context is of some atoms
// together, as those of functional properties. The link to the unrestricted context stays where it was made first; it
// says less.
#include <algorithm>

#include "base/sorted.hpp"
#include "reasoning/el/saturation_worker.hpp"

namespace geminga::el {

//  C < D   C < Q
//  --------------- [D < R some E is told, Q < S only P, R <* S]
//  C -R-> E and P
std::uint32_t SaturationWorker::successor_of(std::uint32_t context, const LinkRule& link) {
  const Context& self = contexts_[context];
  if (self.restricting.empty()) return require(link.root);
  std::vector<ExprId> together;
  for (const ExprId restricting : self.restricting) {
    for (const UniversalRule& rule : index_.universals(restricting)) {
      if (!index_.roles().is_sub_role(link.role, rule.role)) continue;
      if (!index_.is_told_below(link.target, rule.target)) together.push_back(rule.target);
    }
  }
  if (together.empty()) return require(link.root);
  if (link.root != index_.representative(top_expr)) together.push_back(link.root);
  base::sort_unique(together);
  return require_together(together);
}

// The premise with the universal is new.
void SaturationWorker::process_universal(std::uint32_t context, ExprId subsumer) {
  const auto rules = index_.universals(subsumer);
  if (rules.empty()) return;
  const Context& self = contexts_[context];
  const auto is_concerned = [&](RoleId role) {
    return std::ranges::any_of(rules,
                               [&](const UniversalRule& rule) { return index_.roles().is_sub_role(role, rule.role); });
  };
  for (std::uint32_t at = 0; at < contexts_[context].subsumers_done; ++at) {
    const std::uint32_t known = self.subsumers[at];
    if (known >= index_.size() || !index_.has_rules(ExprId{known}, RuleBits::links)) continue;
    for (const LinkRule& link : index_.links(ExprId{known})) {
      if (is_concerned(link.role)) add_link(context, link.role, successor_of(context, link));
    }
  }
  for (std::uint32_t at = 0; at < contexts_[context].selfs_done; ++at) {
    process_universal_self(context, self.selfs[at]);
  }
}

//  C < R Self   C < Q
//  ------------------ [Q < S only P, R <* S]
//  C < P
void SaturationWorker::process_universal_self(std::uint32_t context, RoleId role) {
  std::vector<ExprId> found;
  for (const ExprId restricting : contexts_[context].restricting) {
    for (const UniversalRule& rule : index_.universals(restricting)) {
      if (index_.roles().is_sub_role(role, rule.role)) found.push_back(rule.target);
    }
  }
  for (const ExprId target : found) add_atom(context, target);
}

}  // namespace geminga::el
