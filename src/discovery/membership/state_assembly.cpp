// Collects parts until a revision is complete.
#include "discovery/membership/state_assembly.hpp"

#include <algorithm>

namespace geminga::membership {

void StateAssembly::clear() { *this = StateAssembly(); }

bool StateAssembly::add(const announcement::Announcement& part) {
  if (!has_begun_ || part.revision != revision_ || part.part_count != part_count_) {
    clear();
    has_begun_ = true;
    revision_ = part.revision;
    part_count_ = part.part_count;
  }
  if (parts_.test(part.part)) return false;
  parts_.set(part.part);
  for (const auto& peer : part.peers) {
    for (const auto& entry : peer.publications) services_.push_back({peer.id, entry.number});
    for (const auto& entry : peer.subscriptions) services_.push_back({peer.id, entry.number});
    for (const auto number : peer.withheld) services_.push_back({peer.id, number});
  }
  if (services_.size() > announcement::max_services_per_participant) {
    // More than a participant may have: what is missing cannot be told, so nothing is withdrawn by this revision.
    is_overfull_ = true;
    services_.clear();
    services_.shrink_to_fit();
  }
  if (is_overfull_ || parts_.count() != part_count_) return false;
  std::ranges::sort(services_);
  return true;
}

}  // namespace geminga::membership
