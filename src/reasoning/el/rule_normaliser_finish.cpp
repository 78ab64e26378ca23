// What can be said of an axiom only when all are known: whether datatypes overlap, and which properties are simple.
#include <algorithm>

#include "reasoning/el/rule_normaliser.hpp"

namespace geminga::el {

RuleNormaliser::Unused RuleNormaliser::finish(Universals universals) {
  Unused unused;
  // Where another engine has to do everything again, what inverses say is left to it.
  open_.is_mirrored = !open_.is_more;
  if (open_.is_mirrored) mirror_roles();
  use_keys(unused);
  relate_data();
  find_unused_data(unused);
  add_universals(universals, unused);
  return unused;
}

// A term adds its rules once, but each axiom that holds it stands for itself. Of what one axiom holds more than once,
// once is enough.
void RuleNormaliser::repeat_uses(owl::TermId term, bool is_positive) {
  const auto found = uses_of_term_.find({term, is_positive});
  if (found == uses_of_term_.end() || found->second.axiom == current_axiom_) return;
  found->second.axiom = current_axiom_;
  for (std::size_t at = found->second.begin; at < found->second.end; ++at) note_use(PendingUse(pending_uses_[at]).use);
}

// What is in a finite datatype is one of its values, which EL cannot say; it matters where a value is asked for. What
// is in two datatypes that overlap is in their intersection, which may be finite or a part of a third: the datatypes of
// OWL 2 EL are chosen so that this never happens. Of inexact literals nobody knows whether others have their value.
void RuleNormaliser::find_unused_data(Unused& unused) const {
  const auto overlap = [](owl::Datatype one, owl::Datatype other) {
    return one.family() == other.family() && !one.is_within(other) && !other.is_within(one) && !one.is_disjoint(other);
  };
  // Few datatypes are used by many axioms.
  std::vector<owl::Datatype> used;
  for (const PendingUse& later : pending_uses_) {
    const auto* type = std::get_if<owl::Datatype>(&later.use);
    if (type == nullptr) continue;
    const auto is_same = [&](owl::Datatype other) {
      return type->family() == other.family() && type->is_within(other) && other.is_within(*type);
    };
    if (std::ranges::none_of(used, is_same)) used.push_back(*type);
  }
  std::array<std::size_t, owl::data_family_count> value_counts{};
  for (const auto& [value, expr] : values_) ++value_counts[static_cast<std::size_t>(value.family)];
  for (const PendingUse& later : pending_uses_) {
    if (const auto* family = std::get_if<owl::DataFamily>(&later.use)) {
      if (value_counts[static_cast<std::size_t>(*family)] > 1)
        unused.emplace_back(later.axiom, owl::Construct::inexact_literal);
    } else if (const auto* type = std::get_if<owl::Datatype>(&later.use)) {
      if (type->is_finite() && has_negative_literal_[static_cast<std::size_t>(type->family())]) {
        unused.emplace_back(later.axiom, owl::Construct::finite_datatype);
      } else if (std::ranges::any_of(used, [&](owl::Datatype other) { return overlap(*type, other); })) {
        unused.emplace_back(later.axiom, owl::Construct::overlapping_datatypes);
      }
    }
  }
}

// OWL 2 DL's restriction: what counts or compares the successors of a property is for properties without chains. The
// rules derive nothing wrong from the others, but not all that follows.
void RuleNormaliser::find_not_simple(const Roles& closed, Unused& unused) const {
  std::vector<bool> is_simple(closed.count(), true);
  for (const Roles::Chain& chain : closed.chains()) {
    for (const RoleId super : closed.supers(chain.result)) is_simple[static_cast<std::size_t>(super)] = false;
  }
  for (const PendingUse& later : pending_uses_) {
    const auto* use = std::get_if<SimpleUse>(&later.use);
    if (use != nullptr && !is_simple[static_cast<std::size_t>(use->role)])
      unused.emplace_back(later.axiom, use->construct);
  }
}

}  // namespace geminga::el
