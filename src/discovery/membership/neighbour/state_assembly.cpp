#include "discovery/membership/neighbour/state_assembly.hpp"

#include <algorithm>

namespace geminga::membership {

namespace {

void add_services(const announcement::Announcement& part, std::vector<ServiceNumber>& services) {
  for (const auto& peer : part.peers) {
    for (const auto& entry : peer.publications) services.push_back({peer.id, entry.number});
    for (const auto& entry : peer.subscriptions) services.push_back({peer.id, entry.number});
    for (const auto number : peer.withheld) services.push_back({peer.id, number});
  }
}

}  // namespace

bool update_services(std::vector<ServiceNumber>& services, const announcement::Announcement& change) {
  for (const auto& peer : change.peers) {
    for (const auto number : peer.removed) std::erase(services, ServiceNumber{peer.id, number});
  }
  add_services(change, services);
  std::ranges::sort(services);
  const auto repeated = std::ranges::unique(services);
  services.erase(repeated.begin(), repeated.end());
  return services.size() <= announcement::max_services_per_participant;
}

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
  add_services(part, services_);
  if (services_.size() > announcement::max_services_per_participant) {
    // A participant may not have so many. What is missing cannot be told, so this revision withdraws nothing.
    is_overfull_ = true;
    services_.clear();
    services_.shrink_to_fit();
  }
  if (is_overfull_ || parts_.count() != part_count_) return false;
  std::ranges::sort(services_);
  return true;
}

}  // namespace geminga::membership
