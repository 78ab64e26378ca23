#include "discovery/participant/air/dual_stack.hpp"

#include <algorithm>

#include "base/address.hpp"

namespace geminga::participant {

bool DualStack::is_said_twice(const announcement::Announcement& announcement, const env::Interface& on) {
  if ((announcement.link & announcement::ipv6_side_bit) == 0) return false;
  const auto is_ipv4 = [](const std::string& text) {
    const auto address = base::parse_address(text);
    return address && !address->is_ipv6();
  };
  return on.ipv6_side_of || std::ranges::any_of(on.addresses, is_ipv4);
}

void DualStack::hear(const announcement::Announcement& announcement, const env::Interface& on, base::Instant until) {
  if (!on.ipv6_side_of) return;
  auto& here = needed_until_[on.index];
  if (announcement.kind == announcement::Kind::goodbye) {
    here.erase(announcement.participant);
    return;
  }
  if (here.size() == most_remembered && !here.contains(announcement.participant)) {
    here.erase(std::ranges::min_element(here, {}, [](const auto& entry) { return entry.second; }));
  }
  here[announcement.participant] = until;
}

bool DualStack::speaks_on(const env::Interface& interface, sealing::Seal& seal, base::Instant now) const {
  if (!interface.ipv6_side_of) return true;
  const auto here = needed_until_.find(interface.index);
  const bool is_needed = here != needed_until_.end() &&
                         std::ranges::any_of(here->second, [&](const auto& entry) { return entry.second > now; });
  return is_needed || seal.asks_only_on(interface.index, *interface.ipv6_side_of, now);
}

}  // namespace geminga::participant
