// Who is told of whom: publications and subscriptions in, GCNP events out (paper section 3.6).
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
#include <vector>

#include "base/time.hpp"
#include "discovery/matching/clash.hpp"
#include "discovery/matching/degree.hpp"
#include "discovery/matching/event.hpp"
#include "discovery/matching/overlap.hpp"
#include "discovery/matching/standing.hpp"
#include "discovery/matching/where.hpp"  // for check_where()
#include "discovery/registry/entry.hpp"
#include "geminga/service.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::matching {

struct Request;
struct Finding;
struct Place;

/// Holds the registry, matches and arbitrates. Not thread-safe. Feeding it is idempotent: a put of what is there
/// already only moves its age and causes no event. No event is ever doubled: per (to, about) the stream is add
/// (modify)* del.
///
/// Arbitration order: what the consumer favours, greater priority, what it prefers, better degree, smaller distance,
/// the incumbent, then the smaller key (PREFERENCES.md). In the events of one cause a subscription first loses what
/// matches no more, then come its modifies, then its adds, and the dels of what was outranked last: a consumer whose
/// provider gives way to a better one is never without, and has one more than its limit for so long. Subscriptions
/// follow each other by key.
///
/// A subscription may ask for a class expression. It is filed under the classes right below the expression's place in
/// the taxonomy, so that a new publication finds it as it finds any other request above its concept; no class is added
/// to the ontology, and neither the ontology's index nor the registry's is rebuilt: one more request costs what it is
/// filed under. Its degree is that of a class in its place.
///
/// Providers are told of consumers in the modes oto and otm/pubsub only (paper section 3), and only of those whose
/// choice they are in. A consumer's host that had to choose announces what it has chosen (Subscription::chosen), and
/// the providers' hosts follow it. Until they hear of it, and where nothing had to be chosen, every host computes the
/// choice from its own view; nothing is asked for over the air.
///
/// A peer is never told of the end of its own request: after its subscription is removed there are no dels for it.
class Matcher {
 public:
  /// Who is told by an event of what a new or changed subscription is given at once.
  enum class Telling : std::uint8_t {
    all,
    providers,  ///< the consumer is not: it asks by chosen(), piece by piece
  };

  /// Without an ontology semantic identities match exactly or not at all.
  /// `placing` gives the places of expressions that are asked for; without it they meet nothing. `overlapping` says
  /// which concepts overlap; without it the reasoner is asked whenever a pair is judged.
  explicit Matcher(vocabulary::Vocabulary vocabulary = {}, Placing placing = {}, Overlapping overlapping = {});
  ~Matcher();

  /// Adds or changes an entry. Its identity is resolved by the caller (IRIs). An entry of another participant whose
  /// `where` cannot be read never matches.
  void put(registry::PublicationEntry entry);
  void put(registry::SubscriptionEntry entry, Telling telling = Telling::all);
  /// Removes one; false where there was none.
  bool remove_publication(const ServiceKey& key, Reason reason);
  bool remove_subscription(const ServiceKey& key, Reason reason);
  /// Removes all of a peer.
  void remove_peer(ParticipantId participant, PeerId peer, Reason reason);
  /// Begins to remove everything of a participant, which depart_next() does in steps. Between the steps everything else
  /// may go on, except that no entry of this participant may be put or removed. From here on none of them meets
  /// anything; the events of that come step by step, those of one subscription together.
  void begin_departure(ParticipantId participant, Reason reason);
  /// False: no departure was left to do.
  [[nodiscard]] bool depart_next();
  [[nodiscard]] bool is_departing() const;
  /// The vocabulary in force, by which all questions to the matcher are answered.
  [[nodiscard]] const vocabulary::Vocabulary& vocabulary() const;
  /// The classes of a chain of an event for this subscription: "A>B>C" in short names.
  [[nodiscard]] std::string chain_words(const ServiceKey& subscription, const vocabulary::Chain& chain) const;
  /// How a publication is turned into what a subscription asks for, both known here; null where nothing does.
  [[nodiscard]] std::shared_ptr<const vocabulary::Chain> chain(const ServiceKey& subscription,
                                                               const ServiceKey& publication) const;
  /// Where a converter has come or gone, more subscriptions may be concerned than are judged at once: the next one of
  /// those that are left, with its events. False: none was left. Until then such a one keeps what it was given.
  [[nodiscard]] bool rejudge_next();
  [[nodiscard]] bool has_stale() const;
  /// Judges one of them now.
  void catch_up(const ServiceKey& subscription);
  /// Begins to put another vocabulary in the place of the one in force. That is work over the whole registry. It is
  /// done in steps, and between them everything else may go on:
  ///
  ///     matcher.begin_vocabulary(next);
  ///     while (matcher.file_next()) {}     // what is offered is filed by it, too; nothing else changes
  ///     matcher.put_in_force();            // at once: vocabulary() is the next one
  ///     while (matcher.rematch_next()) {}  // one subscription after the other, by key, is judged by it
  ///
  /// A change may begin only when the last one is over: when rematch_next() has given false, the former vocabulary is
  /// released. A subscription is judged by one vocabulary at any time, by the former one until its step. Its events
  /// come in that step; what stays matched gets none. A step costs as much as putting one publication or subscription.
  void begin_vocabulary(vocabulary::Vocabulary next);
  /// False: everything is filed, and put_in_force() is due.
  [[nodiscard]] bool file_next();
  void put_in_force();
  /// False: nothing was left to do.
  [[nodiscard]] bool rematch_next();
  /// Takes the vocabulary in force prepared for expressions; place_again() makes use of that. False where this is of
  /// another ontology or the one in force is prepared already: then it is dropped.
  bool take_prepared(vocabulary::Vocabulary prepared);
  /// Has rematch_next() ask again for the place of each subscription whose expression has none, and judge those again
  /// for which `overlapping` gave no answer. A local one is judged when it has all of them.
  void place_again();

  /// The events since the last call, in the order in which they must be written.
  [[nodiscard]] std::vector<Event> take_events();
  /// Whose number turned out to be that of two different concepts since the last call (clash.hpp).
  [[nodiscard]] std::vector<Clash> take_clashes();

  /// What meets() needs of a request, for as long as the ontology stays. Without who asks, nobody converts for it.
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
  /// The same up to `most` of them: the first that are found.
  [[nodiscard]] std::vector<ServiceKey> some_candidates(const Subscription& asked, const Request& request,
                                                        std::size_t most) const;
  /// What stands between an offer and `asked`, from which `request` was prepared; either may be one that nobody has
  /// stated.
  [[nodiscard]] Finding examine(const registry::SubscriptionEntry& asked, const Request& request,
                                const registry::PublicationEntry& offer) const;
  /// What stands between an offer, which may be one that nobody has stated, and each subscription behind `after`, or
  /// all, in ascending order of key, by the vocabulary in force, until `visit` gives false. Whether all were visited.
  using VisitFinding = std::function<bool(const registry::SubscriptionEntry&, const Finding&)>;
  bool examine_requests(const std::optional<ServiceKey>& after, const registry::PublicationEntry& offer,
                        const VisitFinding& visit) const;
  /// The same of an offer that is known, for up to `most` that are likely to come near: those who ask for the same or
  /// something above it, then for something below it, the nearest first. Gives how many subscriptions and classes were
  /// looked at.
  std::size_t examine_near(const registry::PublicationEntry& offer, std::size_t most, const VisitFinding& visit) const;
  /// What a subscription is given, as its consumer's host has announced it or as it is chosen here; nothing where that
  /// is the affair of another host.
  [[nodiscard]] std::optional<std::vector<ServiceKey>> known_choice(
      const registry::SubscriptionEntry& subscription) const;
  /// Whether the class of an offer can have instances in common with what a request asks for, by the vocabulary in
  /// force, for a peer of our own; null: that waits to be decided. One of the request's classes must be known.
  [[nodiscard]] OverlapAnswer overlap(vocabulary::ClassNumber offered, const SemanticIdentity& requested,
                                      const Classes& requested_classes) const;
  /// How this offer meets this request by identity, mode, provider, scope and conditions; the error says what does not
  /// fit. `chains` says what is converted; empty: what this very request is told.
  [[nodiscard]] std::expected<Match, std::string> why(const registry::SubscriptionEntry& request,
                                                      const registry::PublicationEntry& offer,
                                                      const AskChain& chains = {}) const;
  /// How a publication stands in the arbitration of a subscription, both known here; nothing where they do not match.
  /// While the vocabulary changes, this is also the subscription's step.
  [[nodiscard]] std::optional<Standing> standing(const ServiceKey& subscription, const ServiceKey& publication);
  /// The same where its place is known already, so that nobody is ranked. Nothing where one of them is not known.
  [[nodiscard]] std::optional<Standing> standing(const ServiceKey& subscription, const ServiceKey& publication,
                                                 const Place& place);
  /// How many converters take no part in chains, because their hosts have as many as may.
  [[nodiscard]] std::size_t waiting_converters() const;
  /// The limit of a subscription that is known, as standing() counts it; 0 is none.
  [[nodiscard]] static std::size_t counted_limit(const registry::SubscriptionEntry& subscription);
  /// Those behind `after`, or all, in ascending order of key, until `visit` gives false. Whether all were visited.
  using VisitPublication = std::function<bool(const registry::PublicationEntry&)>;
  using VisitSubscription = std::function<bool(const registry::SubscriptionEntry&)>;
  bool walk_publications(const std::optional<ServiceKey>& after, const VisitPublication& visit) const;
  bool walk_subscriptions(const std::optional<ServiceKey>& after, const VisitSubscription& visit) const;
  [[nodiscard]] std::size_t publication_count() const;
  [[nodiscard]] std::size_t subscription_count() const;
  /// What a local subscription is given, best first; nothing where it is not known.
  [[nodiscard]] std::vector<ServiceKey> chosen(const ServiceKey& subscription) const;
  /// What its host announces of the choice of a local subscription, ascending: what it is given, where it has a limit
  /// of max_announced_choice at most, its providers are told, and more may match than it admits; else nothing.
  [[nodiscard]] std::vector<ServiceKey> announced_choice(const ServiceKey& subscription) const;
  /// Whether announced_choice() of any subscription has changed since the last call.
  [[nodiscard]] bool take_choice_change();
  /// Whom a local publication is told of, in no particular order.
  [[nodiscard]] std::vector<ServiceKey> consumers(const ServiceKey& publication) const;
  /// The match of a pair that stands in chosen().
  [[nodiscard]] std::optional<Match> given(const ServiceKey& subscription, const ServiceKey& publication) const;
  /// How many pairs were judged since the start: what matching has cost.
  [[nodiscard]] std::uint64_t judged() const;
  /// Entries that were filed, unfiled or passed in the index since the start: what filing has cost.
  [[nodiscard]] std::uint64_t filed() const;
  [[nodiscard]] const registry::PublicationEntry* find_publication(const ServiceKey& key) const;
  [[nodiscard]] const registry::SubscriptionEntry* find_subscription(const ServiceKey& key) const;
  /// Whether anybody known, anywhere in the team, serves this subscription / asks for this publication, which must be
  /// known.
  [[nodiscard]] bool is_served(const registry::SubscriptionEntry& subscription) const;
  [[nodiscard]] bool is_used(const registry::PublicationEntry& publication) const;
  /// The converters that the chain of a known request needs, as Chain::via names them (place_of()). Looks at all that
  /// the requests that convert may meet.
  [[nodiscard]] std::set<std::string> converters_in_use() const;

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace geminga::matching

#endif
