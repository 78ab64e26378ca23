#include "reasoning/placement/expression_meeting.hpp"

#include <algorithm>
#include <limits>

namespace geminga::placement {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

}  // namespace

MeetingPoint::MeetingPoint(const ExpressionOverlay& overlay, std::uint32_t context)
    : overlay_(overlay),
      base_(overlay.base()),
      index_(base_.index()),
      own_(side_of(context)),
      holds_(index_.size(), false),
      member_of_(index_.disjointness_count(), none),
      seen_in_(index_.size(), none) {
  for (const std::uint32_t subsumer : own_.subsumers) {
    if (subsumer >= index_.size()) continue;
    holds_[subsumer] = true;
    for (const std::uint32_t axiom : index_.disjointness(el::ExprId{subsumer})) member_of_[axiom] = subsumer;
  }
}

MeetingPoint::Side MeetingPoint::side_of(std::uint32_t context) const {
  Side side;
  if (context < overlay_.base_count()) {
    side.subsumers = base_.subsumers_of(context);
    side.selfs = base_.selfs_of(context);
    side.is_plain = !base_.is_conditional(context);
    return looked_through(side, base_.forward_of(context));
  }
  const OverlayContext& self = overlay_.own()[context - overlay_.base_count()];
  side.subsumers = self.subsumers.items();
  side.selfs = self.selfs;
  side.is_plain =
      self.universals.empty() && self.functional.empty() && self.negations.empty() && !overlay_.is_conditional();
  return looked_through(side, self.forward.items());
}

MeetingPoint::Side MeetingPoint::looked_through(Side side, std::span<const el::Link> forward) const {
  for (const std::uint32_t subsumer : side.subsumers) {
    if (subsumer >= index_.size()) continue;
    if (index_.is_nominal(el::ExprId{subsumer})) side.is_plain = false;
    if (index_.has_rules(el::ExprId{subsumer}, el::RuleBits::functional)) side.has_functional_rules = true;
  }
  const auto may_be_functional = [this](el::RoleId role) { return index_.may_be_functional(role); };
  side.has_functional_links = std::ranges::any_of(side.selfs, may_be_functional);
  for (const el::Link& link : forward) {
    if (may_be_functional(link.role)) side.has_functional_links = true;
    if (link.context < overlay_.base_count() && base_.is_conditional(link.context)) side.is_plain = false;
  }
  return side;
}

bool MeetingPoint::are_selfs_same(const Side& one, const Side& other) const {
  const auto is_in = [](std::span<const el::RoleId> selfs) {
    return [selfs](el::RoleId role) { return std::ranges::find(selfs, role) != selfs.end(); };
  };
  return one.selfs.size() == other.selfs.size() && std::ranges::all_of(one.selfs, is_in(other.selfs));
}

/// Whether the two contexts together have a conjunction that neither has alone. The other context's subsumers are
/// marked.
bool MeetingPoint::has_new_conjunction(std::uint32_t subsumer, std::uint32_t other) const {
  const auto is_new = [&](const el::ConjunctionRule& rule) {
    const std::uint32_t partner = number(rule.partner);
    const std::uint32_t both = number(rule.conjunction);
    return holds_[partner] && seen_in_[partner] != other && !holds_[both] && seen_in_[both] != other;
  };
  return std::ranges::any_of(index_.conjunctions(el::ExprId{subsumer}), is_new);
}

//  X < D   X < E
//  ------------- [D and E are different members of one disjointness axiom]
//  X < F
bool MeetingPoint::is_excluded(std::uint32_t subsumer) const {
  return std::ranges::any_of(index_.disjointness(el::ExprId{subsumer}), [&](std::uint32_t axiom) {
    return member_of_[axiom] != none && member_of_[axiom] != subsumer;
  });
}

Meeting MeetingPoint::with(std::uint32_t other) {
  const Side side = side_of(other);
  for (const std::uint32_t subsumer : side.subsumers) {
    if (subsumer >= index_.size()) continue;
    seen_in_[subsumer] = other;
    if (is_excluded(subsumer)) return Meeting::impossible;
  }
  if (!own_.is_plain || !side.is_plain || !are_selfs_same(own_, side)) return Meeting::unknown;
  const bool may_merge = (own_.has_functional_links && (side.has_functional_links || side.has_functional_rules)) ||
                         (side.has_functional_links && own_.has_functional_rules);
  if (may_merge) return Meeting::unknown;
  const auto is_new = [&](std::uint32_t subsumer) {
    return subsumer < index_.size() && !holds_[subsumer] && has_new_conjunction(subsumer, other);
  };
  return std::ranges::any_of(side.subsumers, is_new) ? Meeting::unknown : Meeting::possible;
}

}  // namespace geminga::placement
