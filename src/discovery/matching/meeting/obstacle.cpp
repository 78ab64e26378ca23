#include "discovery/matching/meeting/obstacle.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/edit_distance.hpp"
#include "discovery/matching/conditions/provider.hpp"
#include "discovery/matching/degrees/overlap.hpp"
#include "discovery/matching/degrees/representation.hpp"

namespace geminga::matching {
namespace {

using registry::PublicationEntry;

constexpr std::string_view words[] = {"none",
                                      "kind",
                                      "number",
                                      "text",
                                      "similar_text",
                                      "clash",
                                      "no_ontology",
                                      "unknown_concept",
                                      "unknown_offer",
                                      "unsatisfiable",
                                      "unclassified",
                                      "unrelated",
                                      "disjoint",
                                      "undecided",
                                      "representation",
                                      "representation_unstated",
                                      "unknown_representation",
                                      "broader",
                                      "degree",
                                      "mode",
                                      "protocol",
                                      "provider",
                                      "scope",
                                      "where",
                                      "for",
                                      "signature",
                                      "unreadable",
                                      "outranked",
                                      "incumbent",
                                      "nobody",
                                      "ontology_differs",
                                      "incomplete",
                                      "unclassified_offer",
                                      "on",
                                      "unreachable"};
static_assert(std::size(words) == std::to_underlying(Obstacle::unreachable) + 1U);

bool is_similar(const std::string& a, const std::string& b) {
  const std::size_t limit = base::tolerated_slips(a);
  return base::edit_distance(a, b, limit) <= limit;
}

/// The obstacle between two names without a degree. The last three are the codes for this kind of name.
Obstacle of_names(const std::string& offered, const std::string& requested, const vocabulary::Vocabulary& vocabulary,
                  Obstacle unknown_asked, Obstacle unknown_offered, Obstacle different) {
  if (!vocabulary.is_loaded()) return Obstacle::no_ontology;
  const auto asked_class = vocabulary.find_iri(requested);
  const auto offered_class = vocabulary.find_iri(offered);
  if (!asked_class) return unknown_asked;
  if (!offered_class) return unknown_offered;
  if (!vocabulary.is_satisfiable(*asked_class) || !vocabulary.is_satisfiable(*offered_class)) {
    return Obstacle::unsatisfiable;
  }
  return different;
}

/// The obstacle between two semantic identities that do not match at all.
Obstacle of_semantics(const Meaning& offered, const Meaning& requested, Degree weakest, const Questions& asks,
                      const vocabulary::Vocabulary& vocabulary) {
  const SemanticIdentity& offer = offered.identity;
  const SemanticIdentity& request = requested.identity;
  const bool is_expression =
      (has_expression(offer) || has_expression(request)) && offer.concept_iri != request.concept_iri;
  auto by_concept = degree_of_concept(offered, requested, vocabulary, asks.compares);
  const bool may_overlap = asks.overlaps && has_meaning(offered.classes) && has_meaning(requested.classes);
  if (!by_concept && may_overlap) {
    by_concept = degree_of_overlap(offered, requested.classes, vocabulary, asks.overlaps);
    const OverlapAnswer answer = answer_of_overlap(offered, requested.classes, vocabulary, asks.overlaps);
    if (!by_concept) {
      const bool is_disjoint = answer && answer->verdict == vocabulary::Overlap::Verdict::impossible;
      return is_disjoint ? Obstacle::disjoint : Obstacle::undecided;
    }
  }
  if (by_concept && offer.representation_iri.empty()) return Obstacle::representation_unstated;
  if (by_concept) {
    return of_names(offer.representation_iri, request.representation_iri, vocabulary, Obstacle::unknown_representation,
                    Obstacle::unknown_representation, Obstacle::representation);
  }
  if (!is_expression) {
    return of_names(offer.concept_iri, request.concept_iri, vocabulary, Obstacle::unknown_concept,
                    Obstacle::unknown_offer, Obstacle::unrelated);
  }
  if (!vocabulary.is_loaded()) return Obstacle::no_ontology;
  if (has_expression(request) && !requested.classes.place) return Obstacle::unclassified;
  if (!has_expression(request) && !vocabulary.find_iri(request.concept_iri)) return Obstacle::unknown_concept;
  if (has_expression(offer) && !offered.classes.place) return Obstacle::unclassified_offer;
  if (!has_expression(offer) && !vocabulary.find_iri(offer.concept_iri)) return Obstacle::unknown_offer;
  const bool is_missed =
      may_be_missed(offered.classes, requested.classes, !is_weaker(Degree::broader, weakest), vocabulary);
  return is_missed ? Obstacle::incomplete : Obstacle::unrelated;
}

/// The obstacle between two identities that do not match at all.
Obstacle of_identities(const Side& offered, const Side& requested, Degree weakest, const Questions& asks,
                       const vocabulary::Vocabulary& vocabulary) {
  if (offered.identity.index() != requested.identity.index()) return Obstacle::kind;
  if (std::holds_alternative<NumericIdentity>(offered.identity)) return Obstacle::number;
  if (const auto* text = std::get_if<TextIdentity>(&offered.identity)) {
    const bool is_slip = is_similar(std::get<TextIdentity>(requested.identity).text, text->text);
    return is_slip ? Obstacle::similar_text : Obstacle::text;
  }
  return of_semantics({std::get<SemanticIdentity>(offered.identity), offered.classes},
                      {std::get<SemanticIdentity>(requested.identity), requested.classes}, weakest, asks, vocabulary);
}

/// How far apart two identities are. Below `first_far` the concept fits.
constexpr unsigned first_far = 10;
unsigned stage_of(Obstacle identity) {
  switch (identity) {
    case Obstacle::none:
      return 0;
    case Obstacle::clash:
      return 1;
    case Obstacle::broader:
    case Obstacle::degree:
      return 2;
    case Obstacle::representation:
    case Obstacle::representation_unstated:
    case Obstacle::unknown_representation:
      return 3;
    case Obstacle::similar_text:
      return 4;
    case Obstacle::undecided:
      return 5;
    case Obstacle::incomplete:
      return 6;
    case Obstacle::disjoint:
    case Obstacle::unclassified:
    case Obstacle::unclassified_offer:
    case Obstacle::unsatisfiable:
      return first_far;
    case Obstacle::unrelated:
      return first_far + 1;
    case Obstacle::unknown_concept:
    case Obstacle::unknown_offer:
    case Obstacle::no_ontology:
      return first_far + 2;
    case Obstacle::text:
    case Obstacle::number:
      return first_far + 3;
    default:
      return first_far + 4;
  }
}

}  // namespace

std::string_view to_string(Obstacle obstacle) { return words[std::to_underlying(obstacle)]; }

Obstacle Finding::first() const {
  if (identity != Obstacle::none) return identity;
  if (!is_mode_met) return Obstacle::mode;
  if (!is_protocol_met) return Obstacle::protocol;
  if (!is_provider_met) return Obstacle::provider;
  if (!is_scope_met) return is_scope_readable ? Obstacle::scope : Obstacle::unreadable;
  if (!is_on_met) return Obstacle::on;
  if (!is_where_met) return is_where_readable ? Obstacle::where : Obstacle::unreadable;
  if (!is_for_met) return is_for_readable ? Obstacle::for_whom : Obstacle::unreadable;
  if (!is_signature_met) return Obstacle::signature;
  return is_reach_met ? Obstacle::none : Obstacle::unreachable;
}

std::size_t Finding::count() const {
  return std::size_t{identity != Obstacle::none} + !is_mode_met + !is_protocol_met + !is_provider_met + !is_scope_met +
         !is_on_met + !is_where_met + !is_for_met + !is_signature_met + !is_reach_met;
}

std::tuple<unsigned, std::size_t, unsigned, Match> Finding::remoteness() const {
  const unsigned stage = stage_of(identity);
  return {stage < first_far ? 0 : stage, count(), stage, match.value_or(Match{})};
}

bool Finding::is_near() const { return stage_of(identity) < first_far; }

Finding compared(const registry::SubscriptionEntry& subscription, const Request& request, const Offer& offer,
                 const vocabulary::Vocabulary& vocabulary) {
  const Subscription& asked = subscription.subscription;
  const Publication& offered = offer.entry.publication;
  Finding finding;
  finding.is_mode_met = asked.mode == offered.mode;
  finding.is_protocol_met = is_accepted_protocol(asked, offer.entry);
  finding.is_provider_met = is_accepted_provider(asked, offer.entry);
  finding.is_scope_readable = request.scope && offer.audience.scope;
  finding.is_where_readable = request.where.has_value();
  finding.is_for_readable = offer.audience.condition.has_value();
  finding.is_scope_met = is_in_scope(subscription, request, offer);
  finding.is_on_met = is_on(request, offer, vocabulary);
  finding.is_where_met = request.where && request.where->accepts(offer.entry, vocabulary.units());
  finding.is_for_met = offer.audience.condition && offer.audience.condition->accepts(subscription, vocabulary.units());
  finding.is_reach_met = !is_withheld(subscription, offer.entry);
  std::optional<Match> by_signature;
  if (request.signature) {
    by_signature = degree_of_signature(stated(offer.signature), *request.signature, asked.weakest, vocabulary);
    finding.is_signature_met = by_signature.has_value();
  }
  finding.by_identity = degree_of_identity({offered.identity, offer.classes}, {asked.identity, request.classes},
                                           vocabulary, asked.convert, request.asks);
  finding.match = finding.by_identity;
  if (finding.match && by_signature) finding.match = combined(*finding.match, *by_signature);
  return finding;
}

Finding examine(const registry::SubscriptionEntry& subscription, const Request& request, const Offer& offer,
                const vocabulary::Vocabulary& vocabulary, bool is_kept_apart) {
  const Subscription& asked = subscription.subscription;
  Finding finding = compared(subscription, request, offer, vocabulary);
  if (is_kept_apart) {
    finding.identity = Obstacle::clash;
    finding.by_identity = finding.match = std::nullopt;
  } else if (!finding.by_identity) {
    finding.identity = of_identities({offer.entry.publication.identity, offer.classes},
                                     {asked.identity, request.classes}, asked.weakest, request.asks, vocabulary);
  } else if (!is_accepted_degree(asked, request, offer, *finding.by_identity, vocabulary)) {
    finding.identity = finding.by_identity->degree == Degree::broader ? Obstacle::broader : Obstacle::degree;
  }
  return finding;
}

}  // namespace geminga::matching
