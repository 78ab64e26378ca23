// The judgement on one pair of subscription and publication.
#include "discovery/matching/request.hpp"

#include <algorithm>
#include <utility>

#include "base/text.hpp"
#include "discovery/matching/representation.hpp"

namespace geminga::matching {
namespace {

using registry::PublicationEntry;
using registry::SubscriptionEntry;

constexpr std::size_t max_shown_expression = 400;

std::string scope_misfit(const SubscriptionEntry& subscription, const Request& request, const Offer& offer) {
  if (!request.scope || !offer.audience.scope) return "scope: it cannot be read";
  return request.scope->admits(party(subscription), party(offer.entry))
             ? "scope: the provider's, " + base::printable(offer.entry.publication.scope, max_shown_expression) +
                   ", does not admit the consumer"
             : "scope: the consumer's, " + base::printable(subscription.subscription.scope, max_shown_expression) +
                   ", does not admit the provider";
}

std::string kind_of(const Identity& identity) {
  if (std::holds_alternative<NumericIdentity>(identity)) return "a number";
  return std::holds_alternative<TextIdentity>(identity) ? "a text" : "a concept";
}

std::string named(const vocabulary::Vocabulary& vocabulary, const std::string& iri) {
  if (iri.find('<') != std::string::npos)
    return base::printable(vocabulary.short_expression(iri), max_shown_expression);
  return vocabulary.short_name(std::string_view(iri));
}

/// Why a name of the ontology has no part in subsumption; empty where it has.
std::string without_class(const vocabulary::Vocabulary& vocabulary, const std::string& iri) {
  if (!vocabulary.is_loaded()) return "no ontology is loaded";
  const auto number = vocabulary.find_iri(iri);
  if (!number) return named(vocabulary, iri) + " is unknown to the ontology";
  return vocabulary.is_satisfiable(*number) ? "" : named(vocabulary, iri) + " is unsatisfiable";
}

std::string unrelated(const vocabulary::Vocabulary& vocabulary, const std::string& offered,
                      const std::string& requested) {
  std::string why = named(vocabulary, offered) + " is offered, " + named(vocabulary, requested) + " is asked for";
  for (const auto* iri : {&offered, &requested}) {
    const std::string reason = without_class(vocabulary, *iri);
    if (!reason.empty()) return why.append(", and ").append(reason);
  }
  return why + ", and neither subsumes the other";
}

/// Why a representation that does not fit is not converted either.
std::string conversion_misfit(const Classes& offered, const Request& request, std::uint32_t convert,
                              const vocabulary::Vocabulary& vocabulary) {
  const Classes& requested = request.classes;
  if (!offered.representation_class || !requested.representation_class) return "";
  const auto chain =
      chain_between(offered.representation_class, requested.representation_class, vocabulary, request.chains);
  if (chain == nullptr) {
    const auto other = request.chains_of_all
                           ? request.chains_of_all(*offered.representation_class, *requested.representation_class)
                           : nullptr;
    if (other != nullptr) {
      return "; what converts it is none that the request takes part with by protocol, provider and scope: " +
             other->via + ", cost " + std::to_string(other->cost);
    }
    return convert == 0 ? ""
                        : "; no conversion of at most " + std::to_string(vocabulary::max_chain_conversions) +
                              " steps leads from one to the other";
  }
  if (convert == 0)
    return "; it can be converted, cost " + std::to_string(chain->cost) + ": accept that by convert=yes";
  return "; converting costs " + std::to_string(chain->cost) + ", and at most " + std::to_string(convert) +
         " is accepted";
}

/// Why concepts that have no degree do not overlap either; empty where that is not asked for.
std::string overlap_misfit(const Classes& offered, const Classes& requested, const AskOverlap& overlaps,
                           const vocabulary::Vocabulary& vocabulary) {
  const bool has_classes = offered.concept_class && (requested.concept_class || requested.place);
  if (!overlaps || !has_classes) return "";
  const OverlapAnswer answer = answer_of_overlap(offered, requested, vocabulary, overlaps);
  if (answer == nullptr) return "; whether something can be both waits to be decided";
  if (answer->verdict == vocabulary::Overlap::Verdict::impossible) return "; nothing can be both";
  return "; it is undecided whether something can be both: " + base::printable(answer->reason, max_shown_expression);
}

/// The same of an expression, whose place may miss something.
std::string unrelated_expression(const SemanticIdentity& offer, const Classes& offered, const Subscription& asked,
                                 const Request& prepared, const vocabulary::Vocabulary& vocabulary) {
  const std::string& requested = std::get<SemanticIdentity>(asked.identity).concept_iri;
  const std::string both =
      named(vocabulary, offer.concept_iri) + " is offered, " + named(vocabulary, requested) + " is asked for, and ";
  const std::string reason = without_class(vocabulary, offer.concept_iri);
  if (!reason.empty()) return both + reason;
  const bool is_missed = offered.concept_class && may_be_missed(*offered.concept_class, *prepared.classes.place,
                                                                !is_weaker(Degree::broader, asked.weakest), vocabulary);
  if (!is_missed) return both + "neither subsumes the other";
  return both +
         "neither is known to subsume the other, but not all is found of an expression that no class is defined by: " +
         gap_words(prepared.classes);
}

std::string identity_misfit(const Identity& offered, const Classes& offered_classes, const Subscription& asked,
                            const Request& prepared, const vocabulary::Vocabulary& vocabulary) {
  const Identity& requested = asked.identity;
  const Classes& requested_classes = prepared.classes;
  const AskOverlap& overlaps = prepared.overlaps;
  if (offered.index() != requested.index()) {
    return "identity: " + kind_of(offered) + " is offered, " + kind_of(requested) + " is asked for";
  }
  const auto* offer = std::get_if<SemanticIdentity>(&offered);
  const auto* request = std::get_if<SemanticIdentity>(&requested);
  if (offer == nullptr || request == nullptr) {
    return "identity: " + base::printable(canonical_form(offered)) + " is offered, " +
           base::printable(canonical_form(requested)) + " is asked for";
  }
  if (has_expression(*request) && !requested_classes.place) {
    return "concept: " + named(vocabulary, offer->concept_iri) + " is offered, " +
           named(vocabulary, request->concept_iri) +
           " is asked for, and that is unknown to the ontology, unsatisfiable, or waits to be classified";
  }
  const bool fits = degree_of_concept(*offer, offered_classes, *request, requested_classes, vocabulary) ||
                    degree_of_overlap(offered_classes, requested_classes, vocabulary, overlaps);
  if (!fits) {
    const std::string neither = has_expression(*request)
                                    ? unrelated_expression(*offer, offered_classes, asked, prepared, vocabulary)
                                    : unrelated(vocabulary, offer->concept_iri, request->concept_iri);
    return "concept: " + neither + overlap_misfit(offered_classes, requested_classes, overlaps, vocabulary);
  }
  if (offer->representation_iri.empty()) {
    return "representation: none is stated, " + named(vocabulary, request->representation_iri) + " is asked for";
  }
  std::string why = "representation: " + unrelated(vocabulary, offer->representation_iri, request->representation_iri);
  if (degree_of_name(offer->representation_iri, offered_classes.representation_class, request->representation_iri,
                     requested_classes.representation_class, vocabulary)) {
    why = "representation: it is not the same, and the concept has no class by which to compare";
  }
  return why + conversion_misfit(offered_classes, prepared, asked.convert, vocabulary);
}

/// How the request asks about overlaps; empty where it accepts none.
AskOverlap asking(const Subscription& subscription, const Classes& classes, ParticipantId from,
                  const Overlapping& overlapping) {
  const auto* requested = std::get_if<SemanticIdentity>(&subscription.identity);
  if (subscription.weakest != Degree::overlapping || requested == nullptr) return {};
  return [requested = *requested, classes, from, ask = overlapping ? &overlapping : nullptr](
             const vocabulary::Vocabulary& vocabulary, vocabulary::ClassNumber offered) {
    return ask == nullptr ? decided_at_once(vocabulary, offered, requested, classes)
                          : (*ask)(vocabulary, offered, requested, classes, from);
  };
}

}  // namespace

bool is_accepted_degree(const Subscription& asked, const Request& request, const Offer& offer, const Match& match,
                        const vocabulary::Vocabulary& vocabulary) {
  if (match.cost == 0 || match.degree == Degree::overlapping) return !is_weaker(match.degree, asked.weakest);
  const auto by_concept = degree_of_concept(std::get<SemanticIdentity>(offer.entry.publication.identity), offer.classes,
                                            std::get<SemanticIdentity>(asked.identity), request.classes, vocabulary);
  return by_concept && !is_weaker(by_concept->degree, asked.weakest);
}

bool is_accepted_provider(const Subscription& subscription, const PublicationEntry& publication) {
  return subscription.providers.empty() || std::ranges::any_of(subscription.providers, [&](const auto& provider) {
           return is_of(provider, publication);
         });
}

bool is_accepted_protocol(const Subscription& subscription, const PublicationEntry& publication) {
  return subscription.protocols.empty() ||
         std::ranges::find(subscription.protocols, publication.publication.protocol) != subscription.protocols.end();
}

/// Whether each is in the scope of the other.
bool is_in_scope(const SubscriptionEntry& subscription, const Request& request, const Offer& offer) {
  const bool is_everybody =
      request.scope && request.scope->is_everybody() && offer.audience.scope && offer.audience.scope->is_everybody();
  if (is_everybody) return true;
  const Party consumer = party(subscription);
  const Party provider = party(offer.entry);
  return request.scope && request.scope->admits(consumer, provider) && offer.audience.scope &&
         offer.audience.scope->admits(provider, consumer);
}

Request prepared(const Subscription& subscription, const vocabulary::Vocabulary& vocabulary, const Placing& placing,
                 ParticipantId from, const Overlapping& overlapping) {
  Request request{classes_of(subscription.identity, vocabulary), std::nullopt};
  if (placing && vocabulary.is_loaded() && has_expression(subscription.identity)) {
    request.classes.place = placing(vocabulary, std::get<SemanticIdentity>(subscription.identity).concept_iri, from);
    if (request.classes.place && !request.classes.place->is_satisfiable) request.classes.place = nullptr;
  }
  if (auto where = Where::parse(subscription.where, vocabulary.units())) request.where = std::move(*where);
  if (auto preferences = Preferences::of(subscription, vocabulary.units()))
    request.preferences = std::move(*preferences);
  auto scope = Scope::of(subscription.scope);
  request.scope = scope ? std::optional(std::move(*scope)) : std::nullopt;
  request.overlaps = asking(subscription, request.classes, from, overlapping);
  if (has_signature(subscription.attributes)) request.signature = signature_of(subscription.attributes, vocabulary);
  return request;
}

std::optional<Match> meets(const SubscriptionEntry& subscription, const Request& request, const Offer& offer,
                           const vocabulary::Vocabulary& vocabulary) {
  const Subscription& asked = subscription.subscription;
  const PublicationEntry& entry = offer.entry;
  if (asked.mode != entry.publication.mode || !request.where) return std::nullopt;
  if (!is_accepted_provider(asked, entry) || !is_accepted_protocol(asked, entry)) return std::nullopt;
  if (!is_in_scope(subscription, request, offer)) return std::nullopt;
  const auto match = degree_of_identity(entry.publication.identity, offer.classes, asked.identity, request.classes,
                                        vocabulary, asked.convert, request.overlaps, request.chains);
  if (!match || !is_accepted_degree(asked, request, offer, *match, vocabulary)) return std::nullopt;
  if (!request.where->accepts(entry, vocabulary.units())) return std::nullopt;
  if (!offer.audience.condition || !offer.audience.condition->accepts(subscription, vocabulary.units()))
    return std::nullopt;
  if (!request.signature) return match;
  const auto by_signature = degree_of_signature(stated(offer.signature), *request.signature, asked.weakest, vocabulary);
  return by_signature ? std::optional(combined(*match, *by_signature)) : std::nullopt;
}

std::expected<Match, std::string> explained(const SubscriptionEntry& subscription, const Request& request,
                                            const Offer& offer, const vocabulary::Vocabulary& vocabulary) {
  if (const auto match = meets(subscription, request, offer, vocabulary)) return *match;
  const Subscription& asked = subscription.subscription;
  const Publication& offered = offer.entry.publication;
  std::string why;
  const auto say = [&why](const std::string& misfit) { why += (why.empty() ? "" : "; ") + misfit; };
  const auto degree = degree_of_identity(offered.identity, offer.classes, asked.identity, request.classes, vocabulary,
                                         asked.convert, request.overlaps, request.chains);
  if (!degree) {
    say(identity_misfit(offered.identity, offer.classes, asked, request, vocabulary));
  } else if (!is_accepted_degree(asked, request, offer, *degree, vocabulary)) {
    say("degree: " + std::string(to_string(degree->degree)) + ", but at least " +
        std::string(to_string(asked.weakest)) + " is asked for");
  }
  if (asked.mode != offered.mode) {
    say("mode: " + std::string(to_string(offered.mode)) + " is offered, " + std::string(to_string(asked.mode)) +
        " is asked for");
  }
  if (!is_accepted_provider(asked, offer.entry)) say("provider: it is not among those that are asked for");
  if (!is_accepted_protocol(asked, offer.entry)) {
    say("protocol: " + base::printable(offered.protocol) + " is offered, and none of those asked for");
  }
  if (!is_in_scope(subscription, request, offer)) say(scope_misfit(subscription, request, offer));
  if (!request.where) {
    const std::string problem = unit_problem(asked.where, vocabulary.units());
    say("filter: it cannot be read" + (problem.empty() ? "" : ": " + problem));
  } else if (!request.where->accepts(offer.entry, vocabulary.units())) {
    say("filter: " + base::printable(asked.where, max_shown_expression) +
        " does not hold: " + request.where->misses(offer.entry, vocabulary.units()));
  }
  if (!offer.audience.condition) {
    say("for: it cannot be read");
  } else if (!offer.audience.condition->accepts(subscription, vocabulary.units())) {
    say("for: " + base::printable(offered.for_whom, max_shown_expression) +
        " does not hold: " + offer.audience.condition->misses(subscription, vocabulary.units()));
  }
  if (request.signature) {
    const std::string misfit = signature_misfit(stated(offer.signature), *request.signature, asked.weakest, vocabulary);
    if (!misfit.empty()) say("signature: " + misfit);
  }
  return std::unexpected(why);
}

}  // namespace geminga::matching
