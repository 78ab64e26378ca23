// Checks the first obstacle of a pair by removing one condition after the other.
#ifndef GEMINGA_TESTS_DISCOVERY_MATCHING_OBSTACLE_MODEL_HPP
#define GEMINGA_TESTS_DISCOVERY_MATCHING_OBSTACLE_MODEL_HPP

#include <string>

#include "discovery/matching/meeting/obstacle.hpp"
#include "discovery/matching/model.hpp"

namespace geminga::matching {

/// The error in a matcher's answers about a pair that it and the model know; empty where there is none. The pair must
/// meet exactly where the model says so. Else each condition before its first obstacle must hold, and that one must
/// not. Its arbitration must say what the model has chosen. Requires that no other vocabulary is coming into force.
[[nodiscard]] std::string complaint(Matcher& matcher, const Model& model,
                                    const registry::SubscriptionEntry& subscription,
                                    const registry::PublicationEntry& publication);

}  // namespace geminga::matching

#endif
