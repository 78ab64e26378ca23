// Entries of a small team, and events in words, for tests of the matcher.
#ifndef GEMINGA_TESTS_DISCOVERY_MATCHING_TEAM_HPP
#define GEMINGA_TESTS_DISCOVERY_MATCHING_TEAM_HPP

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>
#include <vector>

#include "discovery/matching/matcher.hpp"

namespace geminga::matching {

inline constexpr std::uint32_t here = 1;  ///< the participant whose peers are local; all others are remote

inline ServiceKey key(std::uint32_t participant, std::uint32_t peer, std::uint32_t number) {
  return {ParticipantId{participant}, PeerId{peer}, number};
}

inline base::Instant at(int seconds) { return base::Instant(std::chrono::seconds(seconds)); }

/// A key in words: "p1.1.7" for participant, peer and number.
inline std::string name(const ServiceKey& key) {
  return "p" + std::to_string(std::to_underlying(key.participant)) + "." +
         std::to_string(std::to_underlying(key.peer)) + "." + std::to_string(key.number);
}

inline const ServiceKey& key_of(const Event& event) {
  return std::visit([](const auto& entry) -> const ServiceKey& { return entry->key; }, event.about);
}

/// Build entries from the values that matter to a test; everything else is as by default.
inline registry::PublicationEntry offer(const ServiceKey& key, Identity identity, std::int32_t priority = 0,
                                        ChannelMode mode = ChannelMode::one_to_one) {
  registry::PublicationEntry entry;
  entry.key = key;
  entry.is_local = key.participant == ParticipantId{here};
  entry.participant_name = "robot" + std::to_string(std::to_underlying(key.participant));
  entry.peer_name = "module" + std::to_string(std::to_underlying(key.peer));
  entry.publication.identity = std::move(identity);
  entry.publication.priority = priority;
  entry.publication.mode = mode;
  entry.publication.port = 5000;
  return entry;
}

inline registry::SubscriptionEntry request(const ServiceKey& key, Identity identity, std::uint32_t limit = 0,
                                           Degree weakest = Degree::narrower,
                                           ChannelMode mode = ChannelMode::one_to_one) {
  registry::SubscriptionEntry entry;
  entry.key = key;
  entry.is_local = key.participant == ParticipantId{here};
  entry.participant_name = "robot" + std::to_string(std::to_underlying(key.participant));
  entry.peer_name = "module" + std::to_string(std::to_underlying(key.peer));
  entry.subscription.identity = std::move(identity);
  entry.subscription.limit = limit;
  entry.subscription.weakest = weakest;
  entry.subscription.mode = mode;
  return entry;
}

inline std::string word(Change change) {
  return change == Change::add ? "add" : change == Change::modify ? "modify" : "del";
}

/// An event in words: "p1.1.1 pub add p2.1.7 narrower 2", "p1.1.1 pub del p2.1.7 expired".
inline std::string in_words(const Event& event) {
  const bool is_publication = event.about.index() == 0;
  std::string words =
      name(event.to) + (is_publication ? " pub " : " sub ") + word(event.change) + " " + name(key_of(event));
  if (event.change == Change::del) return words + " " + std::string(to_string(event.reason));
  return words + " " + std::string(to_string(event.match.degree)) + " " + std::to_string(event.match.distance);
}

/// Takes all steps of a participant's departure.
inline void remove_participant(Matcher& matcher, ParticipantId participant, Reason reason) {
  matcher.begin_departure(participant, reason);
  while (matcher.depart_next() || matcher.rejudge_next()) {
  }
}

/// Takes all steps of the change to another vocabulary.
inline void change_vocabulary(Matcher& matcher, const vocabulary::Vocabulary& next) {
  matcher.begin_vocabulary(next);
  while (matcher.file_next()) {
  }
  matcher.put_in_force();
  while (matcher.rematch_next()) {
  }
}

/// Takes all steps that place_again() asks for.
inline void place_again(Matcher& matcher) {
  matcher.place_again();
  while (matcher.rematch_next()) {
  }
}

/// The publications that meet a request, in ascending order of key, found as `query match` finds them.
inline std::vector<ServiceKey> matched(const Matcher& matcher, const registry::SubscriptionEntry& entry) {
  const Subscription& asked = entry.subscription;
  const auto request = matcher.prepare(entry);
  const auto candidates = matcher.candidates(asked, *request, matcher.publication_count());
  std::vector<ServiceKey> keys;
  for (const ServiceKey& one : candidates.value_or(keys)) {
    if (matcher.meets(entry, *request, *matcher.find_publication(one))) keys.push_back(one);
  }
  std::ranges::sort(keys);
  return keys;
}

/// The same for a request of a peer of this host.
inline std::vector<ServiceKey> matched(const Matcher& matcher, const Subscription& asked) {
  registry::SubscriptionEntry entry = request(key(here, 1, 0), asked.identity);
  entry.subscription = asked;
  return matched(matcher, entry);
}

inline std::vector<std::string> told(Matcher& matcher) {
  std::vector<std::string> words;
  for (const Event& event : matcher.take_events()) words.push_back(in_words(event));
  return words;
}

}  // namespace geminga::matching

#endif
