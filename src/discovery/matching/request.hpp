// A subscription made ready to be compared with many publications, and the judgement on one pair.
#ifndef GEMINGA_DISCOVERY_MATCHING_REQUEST_HPP
#define GEMINGA_DISCOVERY_MATCHING_REQUEST_HPP

#include <expected>
#include <memory>
#include <optional>
#include <string>

#include "discovery/matching/arbitration.hpp"
#include "discovery/matching/audience.hpp"
#include "discovery/matching/consumer.hpp"
#include "discovery/matching/degree.hpp"
#include "discovery/matching/overlap.hpp"
#include "discovery/matching/preferences.hpp"
#include "discovery/matching/scope.hpp"
#include "discovery/matching/signature.hpp"
#include "discovery/matching/where.hpp"
#include "discovery/registry/entry.hpp"
#include "geminga/service.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::matching {

/// What is computed once a subscription: its classes, its parsed filter, and what it prefers.
struct Request {
  Classes classes;
  std::optional<Where> where;            ///< nothing: it cannot be read, and the subscription never matches
  Preferences preferences{};             ///< none where they cannot be read
  std::optional<Signature> signature{};  ///< nothing: none is stated
  std::optional<Scope> scope = Scope();  ///< nothing: it cannot be read, and the subscription never matches
  AskOverlap overlaps{};                 ///< empty: it asks for a better degree than overlapping
  AskChain chains{};                     ///< empty: it asks for no representation, or declared conversions are all
  AskChain chains_of_all{};              ///< with converters that it does not take part with, too; empty: not asked
  std::shared_ptr<const Consumer> consumer{};  ///< who asks `chains`; null where that is empty

  /// How such a publication, which matches, ranks among all that do.
  [[nodiscard]] Rank rank(const registry::PublicationEntry& publication, const Match& match) const {
    return {publication.publication.priority, match, publication.key, preferences.score(publication, match)};
  }
};

/// `placing` may be empty: then expressions meet nothing. `from` is whose subscription it is. Where `overlapping` is
/// empty, the reasoner is asked at once; it must live as long as the request.
[[nodiscard]] Request prepared(const Subscription& subscription, const vocabulary::Vocabulary& vocabulary,
                               const Placing& placing = {}, ParticipantId from = {},
                               const Overlapping& overlapping = {});

/// A publication with what is computed of it. Borrows all.
struct Offer {
  const registry::PublicationEntry& entry;
  const Audience& audience;
  const Classes& classes;
  const Signature* signature = nullptr;  ///< null: it states none
};

/// What is computed of a publication that nobody has stored. Borrows the entry.
struct Imagined {
  Imagined(const registry::PublicationEntry& entry, const vocabulary::Vocabulary& vocabulary)
      : audience(Audience::of(entry.publication)),
        classes(classes_of(entry.publication.identity, vocabulary)),
        signature(signature_of(entry.publication.attributes, vocabulary)),
        offer{entry, audience, classes, &signature} {}
  Imagined(const Imagined&) = delete;
  Imagined& operator=(const Imagined&) = delete;

  Audience audience;
  Classes classes;
  Signature signature;
  Offer offer;
};

/// Whether it is by one of the providers that are asked for, or speaks one of the protocols; always where none are.
[[nodiscard]] bool is_accepted_provider(const Subscription& subscription,
                                        const registry::PublicationEntry& publication);
[[nodiscard]] bool is_accepted_protocol(const Subscription& subscription,
                                        const registry::PublicationEntry& publication);
/// Whether each is in the scope of the other.
[[nodiscard]] bool is_in_scope(const registry::SubscriptionEntry& subscription, const Request& request,
                               const Offer& offer);

/// Whether the degree counts for the subscription. A representation that is converted is accepted as such, and `match`
/// limits the concept alone.
[[nodiscard]] bool is_accepted_degree(const Subscription& asked, const Request& request, const Offer& offer,
                                      const Match& match, const vocabulary::Vocabulary& vocabulary);

/// How the offer meets the subscription by mode, provider, protocol, scope, identity, conditions of both and
/// signature; nothing where it does not. `subscription` is what `request` was prepared from.
[[nodiscard]] std::optional<Match> meets(const registry::SubscriptionEntry& subscription, const Request& request,
                                         const Offer& offer, const vocabulary::Vocabulary& vocabulary);

/// The same with everything that does not fit in words, joined by "; ".
[[nodiscard]] std::expected<Match, std::string> explained(const registry::SubscriptionEntry& subscription,
                                                          const Request& request, const Offer& offer,
                                                          const vocabulary::Vocabulary& vocabulary);

}  // namespace geminga::matching

#endif
