// The choice of a consumer's host, as it stands in the message of a subscription.
#ifndef GEMINGA_DISCOVERY_ANNOUNCEMENT_WIRE_CHOICE_HPP
#define GEMINGA_DISCOVERY_ANNOUNCEMENT_WIRE_CHOICE_HPP

#include <optional>
#include <vector>

#include "discovery/announcement/announcement.pb.h"
#include "geminga/service.hpp"

namespace geminga::announcement {

/// Writes a choice. Requires ascending keys. Up to max_listed_choice are listed, as every receiver can read; more are
/// grouped by participant.
void write_choice(const std::vector<ServiceKey>& chosen, wire::Subscription& message);

/// Reads a choice. Nothing: the groups are malformed, or both forms are used. Does not check the order of the keys.
[[nodiscard]] std::optional<std::vector<ServiceKey>> read_choice(const wire::Subscription& message);

}  // namespace geminga::announcement

#endif
