// The change from one vocabulary to another, in steps between which everything else goes on.
#ifndef GEMINGA_DISCOVERY_MATCHING_VOCABULARY_CHANGE_HPP
#define GEMINGA_DISCOVERY_MATCHING_VOCABULARY_CHANGE_HPP

#include <cstdint>
#include <optional>
#include <utility>

#include "discovery/matching/agenda.hpp"
#include "discovery/matching/directory.hpp"
#include "discovery/matching/editions.hpp"
#include "discovery/matching/judge.hpp"
#include "discovery/matching/pairs.hpp"
#include "discovery/matching/preparation.hpp"

namespace geminga::matching {

/// Puts another vocabulary in the place of the one in force. That is work over the whole registry, done in steps
/// between which everything else may go on:
///
///     change.begin(next);
///     while (change.file_next()) {}     // publications are filed by it, too; nothing else changes
///     change.put_in_force();            // at once: Editions::vocabulary() is the next one
///     while (change.rematch_next()) {}  // one subscription after the other, by key, is judged by it
///
/// A subscription is judged by one vocabulary at any time, by the former one until its step. Its events come in that
/// step; what stays matched gets none. A step costs as much as putting one publication or subscription.
class VocabularyChange {
 public:
  VocabularyChange(Editions& editions, const Preparation& preparation, Directory& directory, const Judge& judge,
                   Pairs& pairs, Agenda& agenda)
      : editions_(editions),
        preparation_(preparation),
        directory_(directory),
        judge_(judge),
        pairs_(pairs),
        agenda_(agenda) {}

  /// Requires that the last change is over: when rematch_next() has given false, the former vocabulary is released.
  /// Takes all steps of judging that are left first.
  void begin(const vocabulary::Vocabulary& next);
  /// False: everything is filed, and put_in_force() is due.
  [[nodiscard]] bool file_next();
  void put_in_force();
  /// False: nothing was left to do.
  [[nodiscard]] bool rematch_next();
  /// Takes the vocabulary in force prepared for expressions; place_again() makes use of that. False where this is of
  /// another ontology or the one in force is prepared already: then it is dropped.
  bool take_prepared(vocabulary::Vocabulary prepared) { return editions_.take_prepared(std::move(prepared)); }
  /// Has rematch_next() ask again for the place of each subscription and publication whose expression has none, and
  /// judge those again for which `overlapping` or `comparing` gave no answer. A local subscription is judged when it
  /// has all of them.
  void place_again();

  /// Judges a subscription by the vocabulary in force now, if it is known and the former one judges it.
  void catch_up(const ServiceKey& subscription);
  /// How many entries of an index were passed since the start.
  [[nodiscard]] std::uint64_t passed() const { return passed_; }

 private:
  /// Judges a subscription by the vocabulary in force.
  void rematch(const registry::StoredSubscription& subscription, Request request);
  /// The same unless a request of our own waits for the reasoner: then nothing is done, so that it loses nothing that
  /// it has. Whether it was done.
  bool rematch_if_answered(const registry::StoredSubscription& subscription);
  /// Asks the reasoner whatever judging this subscription will ask it. False: some of it waits to be decided.
  [[nodiscard]] bool asks_all(const registry::StoredSubscription& subscription, const Request& request) const;
  void unfile_next();
  bool place_next();

  /// Asks again for the places of offered expressions that have none. Whether all publications were passed.
  bool place_publications();
  bool place_subscriptions();

  /// The walk over the publications and then the subscriptions whose expressions have no place, and those that wait for
  /// the reasoner.
  struct PlaceWalk {
    std::optional<ServiceKey> at;  ///< the last one that it passed
    bool is_among_subscriptions = false;
    bool must_repeat = false;
  };

  Editions& editions_;
  const Preparation& preparation_;
  Directory& directory_;
  const Judge& judge_;
  Pairs& pairs_;
  Agenda& agenda_;
  std::optional<ServiceKey> at_;  ///< the last entry that the change has dealt with; nothing: none yet
  std::optional<PlaceWalk> place_walk_;
  std::uint64_t passed_ = 0;
};

}  // namespace geminga::matching

#endif
