// Choices: the publications that are given to each subscription, and the reasons.
#ifndef GEMINGA_DISCOVERY_MATCHING_CHOICES_HPP
#define GEMINGA_DISCOVERY_MATCHING_CHOICES_HPP

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "discovery/matching/directory.hpp"
#include "discovery/matching/pairs.hpp"
#include "discovery/matching/standing.hpp"

namespace geminga::matching {

/// Answers by key what arbitration has decided. Changes nothing.
class Choices {
 public:
  Choices(const Directory& directory, const Pairs& pairs) : directory_(directory), pairs_(pairs) {}

  /// The publications that a local subscription is given, best first; none where it is not known.
  [[nodiscard]] std::vector<ServiceKey> chosen(const ServiceKey& subscription) const;
  /// The consumers that a local publication is told of, in no particular order.
  [[nodiscard]] std::vector<ServiceKey> consumers(const ServiceKey& publication) const;
  /// The match of a pair that stands in chosen().
  [[nodiscard]] std::optional<Match> given(const ServiceKey& subscription, const ServiceKey& publication) const;
  /// The announced choice of a local subscription (announced_choices.hpp), in ascending order of key.
  [[nodiscard]] std::vector<ServiceKey> announced(const ServiceKey& subscription) const;
  /// The publications that a subscription is given, as its host has announced or as they are chosen here; nothing where
  /// only another host knows.
  [[nodiscard]] std::optional<std::vector<ServiceKey>> known(const registry::SubscriptionEntry& subscription) const;
  /// How a publication in this place stands in the arbitration of a subscription, both known here, else nothing. The
  /// vocabulary in force must judge the subscription (VocabularyChange::catch_up).
  [[nodiscard]] std::optional<Standing> standing(const ServiceKey& subscription, const ServiceKey& publication,
                                                 const Place& place) const;
  /// How a publication is turned into what a subscription asks for, both known here; null where nothing does.
  [[nodiscard]] std::shared_ptr<const vocabulary::Chain> chain(const ServiceKey& subscription,
                                                               const ServiceKey& publication) const;
  /// The classes of a chain of an event for this subscription: "A>B>C" in short names.
  [[nodiscard]] std::string chain_words(const ServiceKey& subscription, const vocabulary::Chain& chain) const;

 private:
  const Directory& directory_;
  const Pairs& pairs_;
};

}  // namespace geminga::matching

#endif
