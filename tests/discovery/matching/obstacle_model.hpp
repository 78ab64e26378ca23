// What stands first in the way of a pair, found without looking for it: by taking one condition after the other away.
#ifndef GEMINGA_TESTS_DISCOVERY_MATCHING_OBSTACLE_MODEL_HPP
#define GEMINGA_TESTS_DISCOVERY_MATCHING_OBSTACLE_MODEL_HPP

#include <string>

#include "discovery/matching/model.hpp"
#include "discovery/matching/obstacle.hpp"

namespace geminga::matching {

/// What is wrong with what a matcher says of a pair that it and the model know, of which no other vocabulary is coming
/// into force; empty where nothing is. It must meet exactly where the model says so; else each condition that comes
/// before its first obstacle must hold, and that one must not. Its arbitration must say what the model has chosen.
[[nodiscard]] std::string complaint(Matcher& matcher, const Model& model,
                                    const registry::SubscriptionEntry& subscription,
                                    const registry::PublicationEntry& publication);

}  // namespace geminga::matching

#endif
