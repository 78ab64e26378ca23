// The owners of a matcher up to the pairs, put together as in Matcher, for tests of each of them.
#ifndef GEMINGA_TESTS_DISCOVERY_MATCHING_OWNERS_HPP
#define GEMINGA_TESTS_DISCOVERY_MATCHING_OWNERS_HPP

#include <string>
#include <utility>
#include <vector>

#include "discovery/matching/clashes.hpp"
#include "discovery/matching/directory.hpp"
#include "discovery/matching/editions.hpp"
#include "discovery/matching/events.hpp"
#include "discovery/matching/judge.hpp"
#include "discovery/matching/pairs.hpp"
#include "discovery/matching/preparation.hpp"
#include "discovery/matching/team.hpp"

namespace geminga::matching {

struct Owners {
  explicit Owners(const vocabulary::Vocabulary& vocabulary = {})
      : editions(vocabulary),
        preparation(editions, {}, {}),
        directory(editions, preparation),
        clashes(directory.offers().table(), directory.requests().table()),
        judge(directory, clashes),
        events(directory),
        pairs(directory, judge, events) {}

  const registry::StoredPublication& add(registry::PublicationEntry entry) {
    const auto& stored = directory.offers().add(std::move(entry));
    pairs.add(stored);
    return stored;
  }
  const registry::StoredSubscription& add(registry::SubscriptionEntry entry) {
    Request request = preparation.prepare(entry);
    const auto& stored = directory.requests().add(std::move(entry), std::move(request));
    pairs.prepare(stored, nullptr);
    return stored;
  }
  std::vector<std::string> told() {
    std::vector<std::string> words;
    for (const Event& event : events.take()) words.push_back(in_words(event));
    return words;
  }

  Editions editions;
  Preparation preparation;
  Directory directory;
  Clashes clashes;
  Judge judge;
  Events events;
  Pairs pairs;
};

}  // namespace geminga::matching

#endif
