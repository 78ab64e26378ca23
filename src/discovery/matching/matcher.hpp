// The matcher: publications and subscriptions in, events out (paper section 3.6).
#ifndef GEMINGA_DISCOVERY_MATCHING_MATCHER_HPP
#define GEMINGA_DISCOVERY_MATCHING_MATCHER_HPP

#include <cstdint>
#include <memory>
#include <vector>

#include "discovery/matching/agenda.hpp"
#include "discovery/matching/choices.hpp"
#include "discovery/matching/clashes.hpp"
#include "discovery/matching/departures.hpp"
#include "discovery/matching/directory.hpp"
#include "discovery/matching/editions.hpp"
#include "discovery/matching/events.hpp"
#include "discovery/matching/examination.hpp"
#include "discovery/matching/judge.hpp"
#include "discovery/matching/pairs.hpp"
#include "discovery/matching/preparation.hpp"
#include "discovery/matching/search.hpp"
#include "discovery/matching/vocabulary_change.hpp"

namespace geminga::matching {

/// Holds the registry, matches and arbitrates. README.md shows its owners and the way of one change. Resource: neither
/// copied nor moved. Not thread-safe.
///
/// A put of what is there already only moves its age and causes no event. No event is ever doubled: the stream of each
/// pair of `to` and `about` is add (modify)* del.
///
/// Arbitration goes by what the consumer favours, greater priority, what it prefers, better degree, smaller distance,
/// the incumbent, and the smaller key (PREFERENCES.md). In the events of one change a subscription first loses what
/// does not match any longer, then come its modifies and its adds, and last the dels of what was outranked. So a
/// consumer whose provider gives way to a better one is never without, and has one more than its limit for a moment.
/// Subscriptions follow each other by key.
///
/// A subscription may ask for a class expression. It is filed under the classes right below the place of the expression
/// in the taxonomy, so that a new publication finds it as it finds any other request above its concept. No class is
/// added to the ontology and no index is rebuilt: a request costs what it is filed under. Its degree is that of a class
/// in its place. A publication may offer an expression. It is filed below all classes above its place, so that a
/// request for a class finds it. Two expressions are compared with each other, since there may be no class between
/// them.
///
/// Providers are told of consumers in the modes oto and otm/pubsub only (paper section 3), and only of those that have
/// chosen them. The host of a consumer that had to choose announces what it has chosen (Subscription::chosen), and the
/// hosts of the providers follow it. Until they hear of it, and where nothing had to be chosen, every host computes the
/// choice from its own view.
///
/// A peer is never told of the end of its own request: after its subscription is removed there are no dels for it.
class Matcher {
 public:
  /// The consumers that get events of what a new or changed subscription is given at once.
  enum class Telling : std::uint8_t {
    all,
    providers,  ///< the consumer is not told: it asks by Choices::chosen(), piece by piece
  };

  /// Without an ontology semantic identities match exactly or not at all. `placing` gives the places of expressions
  /// that are asked for or offered; without it expressions meet nothing. `overlapping` says which concepts overlap, and
  /// `comparing` how two expressions relate; without them the reasoner is asked whenever a pair is judged.
  explicit Matcher(const vocabulary::Vocabulary& vocabulary = {}, Placing placing = {}, Overlapping overlapping = {},
                   Comparing comparing = {});
  Matcher(const Matcher&) = delete;
  Matcher& operator=(const Matcher&) = delete;

  /// Keeps entries that matchers of the same process know, too, once. Call before the first one is put.
  void share(const std::shared_ptr<registry::SharedEntries>& entries) {
    directory_.offers().share(entries);
    directory_.requests().share(entries);
  }

  /// Adds or changes an entry. Its identity is resolved by the caller (IRIs). An entry of another participant whose
  /// `where` cannot be read never matches.
  void put(registry::PublicationEntry entry);
  void put(registry::SubscriptionEntry entry, Telling telling = Telling::all);
  /// Removes one; false where there was none.
  bool remove_publication(const ServiceKey& key, Reason reason);
  bool remove_subscription(const ServiceKey& key, Reason reason);
  /// Removes everything of a peer.
  void remove_peer(ParticipantId participant, PeerId peer, Reason reason);
  /// Begins to remove everything of a participant, which take_step() does in steps. From here on none of it meets
  /// anything. The events come step by step, those of one subscription together. Between the steps everything else may
  /// go on. An entry of the participant that is put ends all departures at once.
  void begin_departure(ParticipantId participant, Reason reason) { departures_.begin(participant, reason); }
  /// Begins to remove one entry in the same way; false where there was none.
  bool begin_removal_of_publication(const ServiceKey& key, Reason reason);
  bool begin_removal_of_subscription(const ServiceKey& key, Reason reason);

  // Steps that a change leaves: departures, and then the judging of the agenda (agenda.hpp): all that a put() of
  // another host concerns beyond a few pairs, requests that a converter concerns, and choices that have used up their
  // candidates. Until its step a subscription keeps what it was given. A further put() of another host, or the removal
  // of what is another host's, takes all steps of judging that are left first: its caller should have taken them.

  [[nodiscard]] bool has_steps() const { return departures_.is_any() || !agenda_.is_empty(); }
  /// Takes the next step, with its events. False: none was left.
  bool take_step() { return departures_.next() || agenda_.next(); }
  /// Judges this subscription now if a converter concerns it.
  void catch_up(const ServiceKey& subscription);

  // Results of the changes.

  /// The events since the last call, in the order in which they must be written.
  [[nodiscard]] std::vector<Event> take_events() { return events_.take(); }
  /// The messages since the last call about numbers that are those of two different concepts.
  [[nodiscard]] std::vector<Clash> take_clashes() { return clashes_.take(); }
  /// Whether Choices::announced() of any subscription has changed since the last call.
  [[nodiscard]] bool take_choice_change() { return pairs_.take_choice_change(); }

  // The owners that answer questions, and the change of the vocabulary.

  /// The registry: all that is known of the team.
  [[nodiscard]] const registry::Publications& publications() const { return directory_.offers().table(); }
  [[nodiscard]] const registry::Subscriptions& subscriptions() const { return directory_.requests().table(); }
  /// The vocabulary in force, by which all questions are answered.
  [[nodiscard]] const Editions& editions() const { return editions_; }
  /// The publications that are given to whom.
  [[nodiscard]] const Choices& choices() const { return choices_; }
  /// How an offer and a request meet.
  [[nodiscard]] const Examination& examination() const { return examination_; }
  /// All that may meet an offer or a request.
  [[nodiscard]] const Search& search() const { return search_; }
  [[nodiscard]] VocabularyChange& vocabulary_change() { return change_; }

  /// How many pairs were judged since the start: what matching has cost.
  [[nodiscard]] std::uint64_t judged() const { return judge_.judged(); }
  /// How many entries were filed, unfiled or passed in the index since the start: what filing has cost.
  [[nodiscard]] std::uint64_t filed() const {
    return directory_.offers().filed() + directory_.requests().filed() + pairs_.passed() + agenda_.passed() +
           departures_.passed() + change_.passed();
  }

 private:
  /// The entry of offers or requests that another one of the same key is to take the place of; null where there is
  /// none. Where it is about to be erased, departures are ended first. Where one of the two is local and the other is
  /// not, it is removed.
  template <typename Owner, typename Entry>
  const registry::Stored<Entry>* known_before(const Owner& owner, const Entry& entry);

  /// Takes the steps that are left of what other hosts have said, before they say something else.
  void settle_air(bool is_local) {
    if (!is_local && !agenda_.is_empty()) agenda_.finish();
  }

  // In the order in which they know each other: each knows some of those above it.
  Editions editions_;
  Preparation preparation_;
  Directory directory_;
  Clashes clashes_;
  Judge judge_;
  Events events_;
  Pairs pairs_;
  Agenda agenda_;
  Departures departures_;
  VocabularyChange change_;
  Choices choices_;
  Examination examination_;
  Search search_;
};

}  // namespace geminga::matching

#endif
