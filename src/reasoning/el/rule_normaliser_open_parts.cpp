// Notes what has no rules, so that a model can be tested for it.
#include "reasoning/el/rule_normaliser.hpp"

namespace geminga::el {

owl::Construct RuleNormaliser::beyond(owl::Construct construct) {
  open_.is_more = open_.is_more || construct != owl::Construct::none;
  return construct;
}

//  X < C or D;  and C < X, D < X, which needs to be said only where X is tested for
void RuleNormaliser::open_union(ExprId whole, std::span<const ExprId> parts) {
  OpenUnion open{whole, {}, true};
  for (const ExprId part : parts) {
    // What is no atom is not looked for: then nothing is in it.
    if (!index_.is_atom(part)) open.has_all_parts = false;
    if (!index_.is_atom(part)) continue;
    index_.watch(part);
    index_.add_told(part, whole);
    open.parts.push_back(part);
  }
  index_.watch(whole);
  open_.unions.push_back(std::move(open));
}

void RuleNormaliser::open_count(std::vector<OpenCount>& counts, const OpenCount& count) {
  index_.watch(count.whole);
  counts.push_back(count);
}

//  sub R, super inverse S:  R(x,y) says S(y,x)
owl::Construct RuleNormaliser::open_inverse(const Property& sub, const Property& super, owl::Construct construct) {
  if (sub.is_top || super.is_top) return beyond(construct);
  open_.inverses.push_back({sub.role, super.role});
  return construct;
}

}  // namespace geminga::el
