// Requests: subscriptions prepared to be compared with many publications; and the judgement on one pair.
#ifndef GEMINGA_DISCOVERY_MATCHING_MEETING_REQUEST_HPP
#define GEMINGA_DISCOVERY_MATCHING_MEETING_REQUEST_HPP

#include <memory>
#include <optional>
#include <string>

#include "discovery/matching/arbitration/preferences.hpp"
#include "discovery/matching/arbitration/rank.hpp"
#include "discovery/matching/conditions/audience.hpp"
#include "discovery/matching/conditions/scope.hpp"
#include "discovery/matching/conditions/where.hpp"
#include "discovery/matching/conversions/consumer.hpp"
#include "discovery/matching/degrees/comparison.hpp"
#include "discovery/matching/degrees/degree.hpp"
#include "discovery/matching/degrees/overlap.hpp"
#include "discovery/matching/degrees/signature.hpp"
#include "discovery/registry/entry.hpp"
#include "geminga/service.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::matching {

/// The class or expression that has to describe the provider's participant.
struct Robot {
  SemanticIdentity identity;
  Classes classes;
  AskComparison compares{};  ///< empty: it is no expression with a place
};

/// A subscription as it is compared: its classes, its parsed conditions and its preferences.
struct Request {
  Classes classes;
  std::optional<Where> where;            ///< nothing: it cannot be read, and accepts nobody
  Preferences preferences{};             ///< none where they cannot be read
  std::optional<Signature> signature{};  ///< nothing: none is stated
  std::optional<Scope> scope = Scope();  ///< nothing: it cannot be read, and admits nobody
  Questions asks{};
  std::optional<Robot> on{};  ///< of the provider's participant; nothing: any participant
  AskChain chains_of_all{};   ///< of all converters, also those that it takes no part with; may be empty
  std::shared_ptr<const Consumer> consumer{};  ///< the consumer that asks `asks.chains`; null where that is empty

  /// The request of a subscription that states nothing but an identity without a class.
  [[nodiscard]] static Request plain() { return {.classes = {}, .where = Where()}; }
  [[nodiscard]] bool is_plain() const {
    const bool has_class = classes.concept_class || classes.representation_class || classes.place;
    const bool is_unconditional = !on && where && where->is_empty() && scope && scope->is_everybody() && !signature;
    return !has_class && is_unconditional && preferences.is_usual() && !asks.overlaps && !asks.chains &&
           !chains_of_all && consumer == nullptr;
  }
  /// The rank of a publication that matches among all that do.
  [[nodiscard]] Rank rank(const registry::PublicationEntry& publication, const Match& match) const {
    return {publication.publication.priority, match, publication.key, preferences.score(publication, match)};
  }
};

/// The classes of an identity that the participant `from` states, with the place of an expression; without that where
/// `placing` is empty.
[[nodiscard]] Classes placed_classes(const Identity& identity, const vocabulary::Vocabulary& vocabulary,
                                     const Placing& placing, ParticipantId from);

/// Prepares a subscription of the participant `from`. Where `placing` is empty, expressions meet nothing. Where
/// `overlapping` or `comparing` is empty, the reasoner decides at once; else it must live as long as the request.
[[nodiscard]] Request prepared(const Subscription& subscription, const vocabulary::Vocabulary& vocabulary,
                               const Placing& placing = {}, ParticipantId from = {},
                               const Overlapping& overlapping = {}, const Comparing& comparing = {});

/// A publication with its parsed audience, classes and signature. Borrows all.
struct Offer {
  const registry::PublicationEntry& entry;
  const Audience& audience;
  const Classes& classes;
  const Signature* signature = nullptr;  ///< null: it states none
  // The description of the provider's participant, where the request asks for it; null: it has none.
  const SemanticIdentity* described_as = nullptr;
  const Classes* described_classes = nullptr;
};

/// An offer of a publication that is not stored. Borrows the entry.
struct Imagined {
  Imagined(const registry::PublicationEntry& entry, const vocabulary::Vocabulary& vocabulary,
           const Placing& placing = {})
      : audience(Audience::parse(entry.publication)),
        classes(placed_classes(entry.publication.identity, vocabulary, placing, entry.key.participant)),
        signature(signature_of(entry.publication.attributes, vocabulary)),
        offer{entry, audience, classes, &signature} {}
  Imagined(const Imagined&) = delete;
  Imagined& operator=(const Imagined&) = delete;

  Audience audience;
  Classes classes;
  Signature signature;
  Offer offer;
};

/// Whether each is in the scope of the other.
[[nodiscard]] bool is_in_scope(const registry::SubscriptionEntry& subscription, const Request& request,
                               const Offer& offer);

/// Whether the provider's participant is known to be what the request wants. What is not known is not so.
[[nodiscard]] bool is_on(const Request& request, const Offer& offer, const vocabulary::Vocabulary& vocabulary);

/// Whether a service that meets the subscription is kept from it, since its host cannot reach the service and the
/// consumer asks for what can be reached. Each host judges for its own consumers, and a description of a participant
/// has no channel.
[[nodiscard]] inline bool is_withheld(const registry::SubscriptionEntry& subscription,
                                      const registry::PublicationEntry& publication) {
  return subscription.is_local && !publication.is_reachable &&
         publication.publication.mode != ChannelMode::participant &&
         subscription.subscription.reach == RequiredReach::routed;
}

/// Whether the subscription accepts the degree of a match. Where the representation is converted, `match` limits the
/// degree of the concept alone.
[[nodiscard]] bool is_accepted_degree(const Subscription& asked, const Request& request, const Offer& offer,
                                      const Match& match, const vocabulary::Vocabulary& vocabulary);

/// The result of judging one pair.
struct Judgement {
  std::optional<Match> match;  ///< how the offer meets the subscription; nothing where it does not
  bool waits = false;          ///< whether a question to the reasoner about this pair has no answer yet
  bool is_withheld = false;    ///< whether the pair would meet if the service could be reached
};
/// Judges a pair by mode, provider, protocol, scope, identity, conditions of both, signature and reach. `subscription`
/// is what `request` was prepared from.
[[nodiscard]] Judgement judgement_of(const registry::SubscriptionEntry& subscription, const Request& request,
                                     const Offer& offer, const vocabulary::Vocabulary& vocabulary);
/// The match of a pair; nothing where it does not meet.
[[nodiscard]] inline std::optional<Match> meets(const registry::SubscriptionEntry& subscription, const Request& request,
                                                const Offer& offer, const vocabulary::Vocabulary& vocabulary) {
  return judgement_of(subscription, request, offer, vocabulary).match;
}

}  // namespace geminga::matching

#endif
