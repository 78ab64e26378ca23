// The reasons in words why a publication does not meet a subscription.
#ifndef GEMINGA_DISCOVERY_MATCHING_MEETING_EXPLAINED_HPP
#define GEMINGA_DISCOVERY_MATCHING_MEETING_EXPLAINED_HPP

#include <expected>
#include <string>

#include "discovery/matching/meeting/request.hpp"

namespace geminga::matching {

/// As meets(); the error has everything that does not fit in words, joined by "; ".
[[nodiscard]] std::expected<Match, std::string> explained(const registry::SubscriptionEntry& subscription,
                                                          const Request& request, const Offer& offer,
                                                          const vocabulary::Vocabulary& vocabulary);

}  // namespace geminga::matching

#endif
