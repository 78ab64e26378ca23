// The matcher: publications and subscriptions in, events out (paper section 3.6).
#ifndef GEMINGA_DISCOVERY_MATCHING_MATCHER_HPP
#define GEMINGA_DISCOVERY_MATCHING_MATCHER_HPP

#include <cstddef>
#include <cstdint>
#include <expected>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "discovery/matching/agenda.hpp"
#include "discovery/matching/clashes.hpp"
#include "discovery/matching/departures.hpp"
#include "discovery/matching/directory.hpp"
#include "discovery/matching/editions.hpp"
#include "discovery/matching/events.hpp"
#include "discovery/matching/examination.hpp"
#include "discovery/matching/judge.hpp"
#include "discovery/matching/pairs.hpp"
#include "discovery/matching/preparation.hpp"
#include "discovery/matching/standing.hpp"
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
    providers,  ///< the consumer is not told: it asks by chosen(), piece by piece
  };

  /// Without an ontology semantic identities match exactly or not at all. `placing` gives the places of expressions
  /// that are asked for or offered; without it expressions meet nothing. `overlapping` says which concepts overlap, and
  /// `comparing` how two expressions relate; without them the reasoner is asked whenever a pair is judged.
  explicit Matcher(const vocabulary::Vocabulary& vocabulary = {}, Placing placing = {}, Overlapping overlapping = {},
                   Comparing comparing = {});
  Matcher(const Matcher&) = delete;
  Matcher& operator=(const Matcher&) = delete;

  /// Keeps entries that matchers of the same process know, too, once. Call before the first one is put.
  void share(const std::shared_ptr<registry::SharedEntries>& entries) { directory_.share(entries); }

  // Publications and subscriptions.

  /// Adds or changes an entry. Its identity is resolved by the caller (IRIs). An entry of another participant whose
  /// `where` cannot be read never matches.
  void put(registry::PublicationEntry entry);
  void put(registry::SubscriptionEntry entry, Telling telling = Telling::all);
  /// Removes one; false where there was none.
  bool remove_publication(const ServiceKey& key, Reason reason);
  bool remove_subscription(const ServiceKey& key, Reason reason);
  /// Removes everything of a peer.
  void remove_peer(ParticipantId participant, PeerId peer, Reason reason);
  /// Begins to remove everything of a participant, which depart_next() does in steps. From here on none of it meets
  /// anything. The events come step by step, those of one subscription together. Between the steps everything else may
  /// go on. An entry of the participant that is put ends all departures at once.
  void begin_departure(ParticipantId participant, Reason reason) { departures_.begin(participant, reason); }
  /// Begins to remove one entry in the same way; false where there was none.
  bool begin_removal_of_publication(const ServiceKey& key, Reason reason);
  bool begin_removal_of_subscription(const ServiceKey& key, Reason reason);
  /// False: no departure was left to do.
  [[nodiscard]] bool depart_next() { return departures_.next(); }
  [[nodiscard]] bool is_departing() const { return departures_.is_any(); }

  // Judging that a change leaves to steps (agenda.hpp): all that a put() of another host concerns beyond a few
  // pairs, requests that a converter concerns, and choices that have used up their candidates. Until its step a
  // subscription keeps what it was given. A further put() of another host, or the removal of what is another host's,
  // takes all steps that are left first: its caller should have taken them.

  [[nodiscard]] bool has_stale() const { return !agenda_.is_empty(); }
  /// Takes the next step, with its events. False: none was left.
  [[nodiscard]] bool rejudge_next() { return agenda_.next(); }
  /// Judges this subscription now if a converter concerns it.
  void catch_up(const ServiceKey& subscription);

  // The vocabulary.

  /// The vocabulary in force, by which all questions to the matcher are answered.
  [[nodiscard]] const vocabulary::Vocabulary& vocabulary() const { return editions_.in_force().vocabulary; }
  /// Begins to put another vocabulary in the place of the one in force. That is work over the whole registry. It is
  /// done in steps, and between them everything else may go on:
  ///
  ///     matcher.begin_vocabulary(next);
  ///     while (matcher.file_next()) {}     // publications are filed by it, too; nothing else changes
  ///     matcher.put_in_force();            // at once: vocabulary() is the next one
  ///     while (matcher.rematch_next()) {}  // one subscription after the other, by key, is judged by it
  ///
  /// A change may begin only when the last one is over: when rematch_next() has given false, the former vocabulary is
  /// released. A subscription is judged by one vocabulary at any time, by the former one until its step. Its events
  /// come in that step; what stays matched gets none. A step costs as much as putting one publication or subscription.
  void begin_vocabulary(const vocabulary::Vocabulary& next) {
    agenda_.finish();
    change_.begin(next);
  }
  /// False: everything is filed, and put_in_force() is due.
  [[nodiscard]] bool file_next() { return change_.file_next(); }
  void put_in_force() { change_.put_in_force(); }
  /// False: nothing was left to do.
  [[nodiscard]] bool rematch_next() { return change_.rematch_next(); }
  /// Takes the vocabulary in force prepared for expressions; place_again() makes use of that. False where this is of
  /// another ontology or the one in force is prepared already: then it is dropped.
  bool take_prepared(vocabulary::Vocabulary prepared) { return editions_.take_prepared(std::move(prepared)); }
  /// Has rematch_next() ask again for the place of each subscription and publication whose expression has none, and
  /// judge those again for which `overlapping` or `comparing` gave no answer. A local subscription is judged when it
  /// has all of them.
  void place_again() { change_.place_again(); }

  // Events and choices.

  /// The events since the last call, in the order in which they must be written.
  [[nodiscard]] std::vector<Event> take_events() { return events_.take(); }
  /// The messages since the last call about numbers that are those of two different concepts.
  [[nodiscard]] std::vector<Clash> take_clashes() { return clashes_.take(); }
  /// The publications that a local subscription is given, best first; none where it is not known.
  [[nodiscard]] std::vector<ServiceKey> chosen(const ServiceKey& subscription) const;
  /// The consumers that a local publication is told of, in no particular order.
  [[nodiscard]] std::vector<ServiceKey> consumers(const ServiceKey& publication) const;
  /// The match of a pair that stands in chosen().
  [[nodiscard]] std::optional<Match> given(const ServiceKey& subscription, const ServiceKey& publication) const;
  /// The announced choice of a local subscription (announced_choices.hpp), in ascending order of key.
  [[nodiscard]] std::vector<ServiceKey> announced_choice(const ServiceKey& subscription) const;
  /// Whether announced_choice() of any subscription has changed since the last call.
  [[nodiscard]] bool take_choice_change() { return pairs_.take_choice_change(); }
  /// How a publication is turned into what a subscription asks for, both known here; null where nothing does.
  [[nodiscard]] std::shared_ptr<const vocabulary::Chain> chain(const ServiceKey& subscription,
                                                               const ServiceKey& publication) const;
  /// The classes of a chain of an event for this subscription: "A>B>C" in short names.
  [[nodiscard]] std::string chain_words(const ServiceKey& subscription, const vocabulary::Chain& chain) const;

  // Questions about what is known.

  [[nodiscard]] std::size_t publication_count() const { return directory_.publications().size(); }
  [[nodiscard]] std::size_t subscription_count() const { return directory_.subscriptions().size(); }
  [[nodiscard]] const registry::PublicationEntry* find_publication(const ServiceKey& key) const;
  [[nodiscard]] const registry::SubscriptionEntry* find_subscription(const ServiceKey& key) const;
  /// When an entry that is known was last stated.
  [[nodiscard]] base::Instant updated(const registry::PublicationEntry& entry) const;
  [[nodiscard]] base::Instant updated(const registry::SubscriptionEntry& entry) const;
  /// Visit the entries behind `after`, or all, in ascending order of key, until `visit` gives false. Whether all were
  /// visited.
  bool walk_publications(const std::optional<ServiceKey>& after,
                         const std::function<bool(const registry::PublicationEntry&)>& visit) const;
  bool walk_subscriptions(const std::optional<ServiceKey>& after,
                          const std::function<bool(const registry::SubscriptionEntry&)>& visit) const;
  /// Whether anybody in the team serves this subscription, or asks for this publication, which must be known.
  [[nodiscard]] bool is_served(const registry::SubscriptionEntry& subscription) const;
  [[nodiscard]] bool is_used(const registry::PublicationEntry& publication) const;
  /// The converters that the chain of a known request needs, as Chain::via names them (conversions/converter.hpp).
  /// Looks at all that the requests that convert may meet.
  [[nodiscard]] std::set<std::string> converters_in_use() const;
  /// How many converters take no part in chains because their hosts have as many as may.
  [[nodiscard]] std::size_t waiting_converters() const { return editions_.in_force().converters->waiting_count(); }
  /// How many pairs were judged since the start: what matching has cost.
  [[nodiscard]] std::uint64_t judged() const { return judge_.judged(); }
  /// How many entries were filed, unfiled or passed in the index since the start: what filing has cost.
  [[nodiscard]] std::uint64_t filed() const {
    return directory_.filed() + pairs_.passed() + agenda_.passed() + departures_.passed() + change_.passed();
  }

  // Questions about one request, by the vocabulary in force.

  /// The request for meets(), valid while the ontology stays. Without a consumer nothing is converted for it.
  [[nodiscard]] std::shared_ptr<const Request> prepare(const Subscription& asked) const;
  [[nodiscard]] std::shared_ptr<const Request> prepare(const registry::SubscriptionEntry& asked) const;
  /// How a publication of the registry meets `asked`, from which `request` was prepared; its mode and its identity may
  /// have been set to the publication's own since.
  [[nodiscard]] std::optional<Match> meets(const registry::SubscriptionEntry& asked, const Request& request,
                                           const registry::PublicationEntry& publication) const;
  /// The publications whose identity may meet the request's, in no particular order; nothing where they are more than
  /// `most`.
  [[nodiscard]] std::optional<std::vector<ServiceKey>> candidates(const Subscription& asked, const Request& request,
                                                                  std::size_t most) const;
  /// Up to `most` of them: the first that are found.
  [[nodiscard]] std::vector<ServiceKey> some_candidates(const Subscription& asked, const Request& request,
                                                        std::size_t most) const;
  /// The classes of an offer, which may be one that nobody has stated, with the place of an expression.
  [[nodiscard]] Classes classes(const registry::PublicationEntry& offer) const {
    return preparation_.classes(offer, vocabulary());
  }
  /// Whether what an offer is can have instances in common with what a request asks for, for a peer of our own; null:
  /// that waits to be decided. Something must be known of both.
  [[nodiscard]] OverlapAnswer overlap(const Meaning& offered, const Meaning& requested) const {
    return preparation_.overlap(offered, requested);
  }
  /// The finding about an offer and `asked`, from which `request` was prepared. Either may be one that nobody has
  /// stated.
  [[nodiscard]] Finding examine(const registry::SubscriptionEntry& asked, const Request& request,
                                const registry::PublicationEntry& offer) const {
    return examination_.examine(asked, request, offer);
  }
  /// Gives `visit` the finding about an offer, which may be one that nobody has stated, and each subscription behind
  /// `after`, or all, in ascending order of key, until it gives false. Whether all were visited.
  bool examine_requests(const std::optional<ServiceKey>& after, const registry::PublicationEntry& offer,
                        const VisitFinding& visit) const {
    return examination_.examine_requests(after, offer, visit);
  }
  /// Gives `visit` the finding about an offer that is known and up to `most` subscriptions that are likely to come
  /// near: first those that ask for the same or something above it, then for something below it, the nearest first.
  /// Gives how many subscriptions and classes were looked at.
  std::size_t examine_near(const registry::PublicationEntry& offer, std::size_t most, const VisitFinding& visit) const {
    return examination_.examine_near(offer, most, visit);
  }
  /// How this offer meets this request; the error says in words what does not fit. `chains` says what is converted;
  /// empty: what this very request is told.
  [[nodiscard]] std::expected<Match, std::string> why(const registry::SubscriptionEntry& request,
                                                      const registry::PublicationEntry& offer,
                                                      const AskChain& chains = {}) const {
    return examination_.why(request, offer, chains);
  }
  /// How a publication stands in the arbitration of a subscription, both known here; nothing where they do not match.
  /// While the vocabulary changes, this is also the subscription's step.
  [[nodiscard]] std::optional<Standing> standing(const ServiceKey& subscription, const ServiceKey& publication);
  /// The same where its place is known already, so that nobody is ranked. Nothing where one of them is not known.
  [[nodiscard]] std::optional<Standing> standing(const ServiceKey& subscription, const ServiceKey& publication,
                                                 const Place& place);
  /// The publications that a subscription is given, as its host has announced or as they are chosen here; nothing where
  /// only another host knows.
  [[nodiscard]] std::optional<std::vector<ServiceKey>> known_choice(
      const registry::SubscriptionEntry& subscription) const;

 private:
  /// The entry that another one of the same key is to take the place of; null where there is none. Where it is about
  /// to be erased, departures are ended first. Where one of the two is local and the other is not, it is removed.
  template <typename Entry>
  const registry::Stored<Entry>* known_before(const registry::Table<Entry>& table, const Entry& entry);

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
  Examination examination_;
};

}  // namespace geminga::matching

#endif
