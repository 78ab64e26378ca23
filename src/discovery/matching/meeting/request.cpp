#include "discovery/matching/meeting/request.hpp"

#include <utility>

#include "discovery/matching/conditions/provider.hpp"
#include "discovery/matching/degrees/representation.hpp"

namespace geminga::matching {
namespace {

using registry::PublicationEntry;
using registry::SubscriptionEntry;

/// The function by which a request asks about overlaps; empty where it accepts none.
AskOverlap asking(const Subscription& subscription, const Classes& classes, ParticipantId from,
                  const Overlapping& overlapping) {
  const auto* requested = std::get_if<SemanticIdentity>(&subscription.identity);
  if (subscription.weakest != Degree::overlapping || requested == nullptr) return {};
  return [identity = *requested, classes, from, ask = overlapping ? &overlapping : nullptr](
             const vocabulary::Vocabulary& vocabulary, const Meaning& offered) {
    const Meaning wanted{identity, classes};
    return ask == nullptr ? decided_at_once(vocabulary, offered, wanted) : (*ask)(vocabulary, offered, wanted, from);
  };
}

/// The function by which a request asks about offered expressions; empty where it is for none.
AskComparison asking(const Identity& identity, const Classes& classes, ParticipantId from, const Comparing& comparing) {
  if (!classes.place) return {};
  return [requested = std::get<SemanticIdentity>(identity), classes, from, ask = comparing ? &comparing : nullptr](
             const vocabulary::Vocabulary& vocabulary, const Meaning& offered) {
    const Meaning wanted{requested, classes};
    return ask == nullptr ? compared_at_once(vocabulary, offered, wanted) : (*ask)(vocabulary, offered, wanted, from);
  };
}

/// The class of `<IRI>`, or the expression.
SemanticIdentity identity_of(const std::string& on) {
  const bool is_class = on.starts_with('<') && on.find('>') == on.size() - 1;
  return {is_class ? on.substr(1, on.size() - 2) : on, {}};
}

bool is_described(const Robot& wanted, const Offer& offer, const vocabulary::Vocabulary& vocabulary,
                  const AskComparison& compares) {
  if (offer.described_as == nullptr) return false;
  const auto match = degree_of_concept({*offer.described_as, *offer.described_classes},
                                       {wanted.identity, wanted.classes}, vocabulary, compares);
  return match && !is_weaker(match->degree, Degree::narrower);
}

/// The match of a pair; nothing where it does not meet. `asks` and `compares_on` are asked in the place of the
/// request's own.
std::optional<Match> match_of(const SubscriptionEntry& subscription, const Request& request, const Offer& offer,
                              const vocabulary::Vocabulary& vocabulary, const Questions& asks,
                              const AskComparison& compares_on) {
  const Subscription& asked = subscription.subscription;
  const PublicationEntry& entry = offer.entry;
  if (asked.mode != entry.publication.mode || !request.where) return std::nullopt;
  if (!is_accepted_provider(asked, entry) || !is_accepted_protocol(asked, entry)) return std::nullopt;
  if (!is_in_scope(subscription, request, offer)) return std::nullopt;
  const auto match = degree_of_identity({entry.publication.identity, offer.classes}, {asked.identity, request.classes},
                                        vocabulary, asked.convert, asks);
  if (!match || !is_accepted_degree(asked, request, offer, *match, vocabulary)) return std::nullopt;
  if (!request.where->accepts(entry, vocabulary.units())) return std::nullopt;
  if (!offer.audience.condition || !offer.audience.condition->accepts(subscription, vocabulary.units()))
    return std::nullopt;
  if (request.on && !is_described(*request.on, offer, vocabulary, compares_on)) return std::nullopt;
  if (!request.signature) return match;
  const auto by_signature = degree_of_signature(stated(offer.signature), *request.signature, asked.weakest, vocabulary);
  return by_signature ? std::optional(combined(*match, *by_signature)) : std::nullopt;
}

}  // namespace

bool is_accepted_degree(const Subscription& asked, const Request& request, const Offer& offer, const Match& match,
                        const vocabulary::Vocabulary& vocabulary) {
  if (match.cost == 0 || match.degree == Degree::overlapping) return !is_weaker(match.degree, asked.weakest);
  const auto by_concept = degree_of_concept(
      {std::get<SemanticIdentity>(offer.entry.publication.identity), offer.classes},
      {std::get<SemanticIdentity>(asked.identity), request.classes}, vocabulary, request.asks.compares);
  return by_concept && !is_weaker(by_concept->degree, asked.weakest);
}

bool is_in_scope(const SubscriptionEntry& subscription, const Request& request, const Offer& offer) {
  const bool is_everybody =
      request.scope && request.scope->is_everybody() && offer.audience.scope && offer.audience.scope->is_everybody();
  if (is_everybody) return true;
  const Party consumer = party(subscription);
  const Party provider = party(offer.entry);
  return request.scope && request.scope->admits(consumer, provider) && offer.audience.scope &&
         offer.audience.scope->admits(provider, consumer);
}

bool is_on(const Request& request, const Offer& offer, const vocabulary::Vocabulary& vocabulary) {
  return !request.on || is_described(*request.on, offer, vocabulary, request.on->compares);
}

Classes placed_classes(const Identity& identity, const vocabulary::Vocabulary& vocabulary, const Placing& placing,
                       ParticipantId from) {
  Classes classes = classes_of(identity, vocabulary);
  if (!placing || !vocabulary.is_loaded() || !has_expression(identity)) return classes;
  classes.place = placing(vocabulary, std::get<SemanticIdentity>(identity).concept_iri, from);
  if (classes.place && !classes.place->is_satisfiable) classes.place = nullptr;
  return classes;
}

Request prepared(const Subscription& subscription, const vocabulary::Vocabulary& vocabulary, const Placing& placing,
                 ParticipantId from, const Overlapping& overlapping, const Comparing& comparing) {
  Request request{placed_classes(subscription.identity, vocabulary, placing, from), std::nullopt};
  if (auto where = Where::parse(subscription.where, vocabulary.units())) request.where = std::move(*where);
  if (auto preferences = Preferences::parse(subscription, vocabulary.units()))
    request.preferences = std::move(*preferences);
  auto scope = Scope::parse(subscription.scope);
  request.scope = scope ? std::optional(std::move(*scope)) : std::nullopt;
  request.asks.overlaps = asking(subscription, request.classes, from, overlapping);
  request.asks.compares = asking(subscription.identity, request.classes, from, comparing);
  if (!subscription.on.empty()) {
    Robot& on = request.on.emplace();
    on.identity = identity_of(subscription.on);
    on.classes = placed_classes(on.identity, vocabulary, placing, from);
    on.compares = asking(on.identity, on.classes, from, comparing);
  }
  if (has_signature(subscription.attributes)) request.signature = signature_of(subscription.attributes, vocabulary);
  return request;
}

namespace {

/// The judgement on a pair, from its match without a look at reach.
Judgement judged(const SubscriptionEntry& subscription, const Offer& offer, std::optional<Match> match, bool waits) {
  const bool is_kept_back = match && is_withheld(subscription, offer.entry);
  return {is_kept_back ? std::nullopt : match, waits, is_kept_back};
}

}  // namespace

Judgement judgement_of(const SubscriptionEntry& subscription, const Request& request, const Offer& offer,
                       const vocabulary::Vocabulary& vocabulary) {
  const AskComparison compares_on = request.on ? request.on->compares : AskComparison();
  const bool may_ask = request.asks.overlaps || (request.asks.compares && offer.classes.place) || compares_on;
  if (!may_ask) {
    return judged(subscription, offer, match_of(subscription, request, offer, vocabulary, request.asks, compares_on),
                  false);
  }
  bool waits = false;
  const auto noting = [&waits](const auto& ask) -> std::decay_t<decltype(ask)> {
    if (!ask) return {};
    return [&](const vocabulary::Vocabulary& asked, const Meaning& offered) {
      auto answer = ask(asked, offered);
      waits = waits || answer == nullptr;
      return answer;
    };
  };
  const Questions noted{.overlaps = noting(request.asks.overlaps),
                        .compares = noting(request.asks.compares),
                        .chains = request.asks.chains};
  auto match = match_of(subscription, request, offer, vocabulary, noted, noting(compares_on));
  return judged(subscription, offer, match, waits);
}

}  // namespace geminga::matching
