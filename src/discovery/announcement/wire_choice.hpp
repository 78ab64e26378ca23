// What a consumer's host has chosen, as it stands in the message of a subscription.
#ifndef GEMINGA_DISCOVERY_ANNOUNCEMENT_WIRE_CHOICE_HPP
#define GEMINGA_DISCOVERY_ANNOUNCEMENT_WIRE_CHOICE_HPP

#include <optional>
#include <vector>

#include "discovery/announcement/announcement.pb.h"
#include "geminga/service.hpp"

namespace geminga::announcement {

/// Requires ascending keys. Up to max_listed_choice are listed as every receiver knows it; more are grouped by their
/// participants.
void write_choice(const std::vector<ServiceKey>& chosen, wire::Subscription& message);

/// Nothing where the groups are no groups, or both forms are used. The order of the keys is not looked at.
[[nodiscard]] std::optional<std::vector<ServiceKey>> read_choice(const wire::Subscription& message);

}  // namespace geminga::announcement

#endif
