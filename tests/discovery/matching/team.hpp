// Entries of a small team, and events in words, for tests of the matcher.
#ifndef GEMINGA_TESTS_DISCOVERY_MATCHING_TEAM_HPP
#define GEMINGA_TESTS_DISCOVERY_MATCHING_TEAM_HPP

#include <algorithm>
#include <chrono>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "discovery/matching/interest.hpp"
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
  while (matcher.take_step()) {
  }
}

/// Takes all steps of the change to another vocabulary.
inline void change_vocabulary(Matcher& matcher, const vocabulary::Vocabulary& next) {
  matcher.vocabulary_change().begin(next);
  while (matcher.vocabulary_change().file_next()) {
  }
  matcher.vocabulary_change().put_in_force();
  while (matcher.vocabulary_change().rematch_next()) {
  }
}

/// The standing of a publication among all that meet a subscription, both known; nothing where it does not.
inline std::optional<Standing> standing_of(Matcher& matcher, const ServiceKey& subscription,
                                           const ServiceKey& publication) {
  const registry::SubscriptionEntry& asked = *matcher.subscriptions().find_entry(subscription);
  const auto request = matcher.examination().prepare(asked);
  std::vector<std::pair<Rank, const registry::PublicationEntry*>> ranked;
  matcher.publications().visit_after(std::nullopt, [&](const registry::StoredPublication& stored) {
    const auto match = matcher.examination().meets(asked, *request, stored.entry);
    if (match) ranked.emplace_back(request->rank(stored.entry, *match), &stored.entry);
    return true;
  });
  std::ranges::sort(ranked, BestFirst{}, [](const auto& one) { return one.first; });
  const auto at = std::ranges::find(ranked, publication, [](const auto& one) { return one.second->key; });
  if (at == ranked.end()) return std::nullopt;
  Place place{.rank = static_cast<std::size_t>(at - ranked.begin()) + 1, .candidates = ranked.size()};
  const std::size_t limit = counted_limit(asked);
  if (limit != 0 && place.rank > limit) place.last = ranked[limit - 1].second;
  matcher.vocabulary_change().catch_up(subscription);
  return matcher.choices().standing(subscription, publication, place);
}

/// Takes all steps that place_again() asks for.
inline void place_again(Matcher& matcher) {
  matcher.vocabulary_change().place_again();
  while (matcher.vocabulary_change().rematch_next()) {
  }
}

/// The publications that meet a request, in ascending order of key, found as `query match` finds them.
inline std::vector<ServiceKey> matched(const Matcher& matcher, const registry::SubscriptionEntry& entry) {
  const Subscription& asked = entry.subscription;
  const auto request = matcher.examination().prepare(entry);
  const auto candidates = matcher.search().candidates(asked, *request, matcher.publications().size());
  std::vector<ServiceKey> keys;
  for (const ServiceKey& one : candidates.value_or(keys)) {
    if (matcher.examination().meets(entry, *request, *matcher.publications().find_entry(one))) keys.push_back(one);
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
