#include "discovery/matching/meeting/explained.hpp"

#include <utility>

#include "base/text.hpp"
#include "discovery/matching/degrees/representation.hpp"
#include "discovery/matching/meeting/obstacle.hpp"

namespace geminga::matching {
namespace {

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

/// The reason why a name has no class in the ontology; empty where it has one.
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

/// The reason why a representation that does not fit is not converted either.
std::string conversion_misfit(const Classes& offered, const Request& request, std::uint32_t convert,
                              const vocabulary::Vocabulary& vocabulary) {
  const Classes& requested = request.classes;
  if (!offered.representation_class || !requested.representation_class) return "";
  const auto chain =
      chain_between(offered.representation_class, requested.representation_class, vocabulary, request.asks.chains);
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

/// The reason why concepts without a degree do not overlap either; empty where overlapping is not accepted.
std::string overlap_misfit(const Meaning& offered, const Classes& requested, const AskOverlap& overlaps,
                           const vocabulary::Vocabulary& vocabulary) {
  if (!overlaps || !has_meaning(offered.classes) || !has_meaning(requested)) return "";
  const OverlapAnswer answer = answer_of_overlap(offered, requested, vocabulary, overlaps);
  if (answer == nullptr) return "; whether something can be both waits to be decided";
  if (answer->verdict == vocabulary::Overlap::Verdict::impossible) return "; nothing can be both";
  return "; it is undecided whether something can be both: " + base::printable(answer->reason, max_shown_expression);
}

/// The same where one is an expression, whose place may be incomplete.
std::string unrelated_expression(const Meaning& offered, const Subscription& asked, const Request& prepared,
                                 const vocabulary::Vocabulary& vocabulary) {
  const SemanticIdentity& offer = offered.identity;
  const std::string& requested = std::get<SemanticIdentity>(asked.identity).concept_iri;
  const std::string both =
      named(vocabulary, offer.concept_iri) + " is offered, " + named(vocabulary, requested) + " is asked for, and ";
  for (const std::string* iri : {&offer.concept_iri, &requested}) {
    const bool is_expression = has_expression(SemanticIdentity{*iri, ""});
    const std::string reason = is_expression ? "" : without_class(vocabulary, *iri);
    if (!reason.empty()) return both + reason;
  }
  const bool is_missed =
      may_be_missed(offered.classes, prepared.classes, !is_weaker(Degree::broader, asked.weakest), vocabulary);
  if (!is_missed) return both + "neither subsumes the other";
  return both +
         "neither is known to subsume the other, but the answer may be incomplete, as no class is defined by the "
         "expression: " +
         gap_words(offered.classes, prepared.classes);
}

std::string identity_misfit(const Side& side, const Subscription& asked, const Request& prepared,
                            const vocabulary::Vocabulary& vocabulary) {
  const Identity& offered = side.identity;
  const Identity& requested = asked.identity;
  if (offered.index() != requested.index()) {
    return "identity: " + kind_of(offered) + " is offered, " + kind_of(requested) + " is asked for";
  }
  const auto* offer = std::get_if<SemanticIdentity>(&offered);
  const auto* request = std::get_if<SemanticIdentity>(&requested);
  if (offer == nullptr || request == nullptr) {
    return "identity: " + base::printable(canonical_form(offered)) + " is offered, " +
           base::printable(canonical_form(requested)) + " is asked for";
  }
  if (has_expression(*request) && !prepared.classes.place) {
    return "concept: " + named(vocabulary, offer->concept_iri) + " is offered, " +
           named(vocabulary, request->concept_iri) +
           " is asked for, and that is unknown to the ontology, unsatisfiable, or waits to be classified";
  }
  const bool is_same = offer->concept_iri == request->concept_iri;
  if (has_expression(*offer) && !side.classes.place && !is_same) {
    return "concept: " + named(vocabulary, offer->concept_iri) +
           " is offered, and that is unknown to the ontology, unsatisfiable, or waits to be classified; " +
           named(vocabulary, request->concept_iri) + " is asked for";
  }
  const Meaning offer_meant{*offer, side.classes};
  const Meaning request_meant{*request, prepared.classes};
  const bool fits = degree_of_concept(offer_meant, request_meant, vocabulary, prepared.asks.compares) ||
                    degree_of_overlap(offer_meant, prepared.classes, vocabulary, prepared.asks.overlaps);
  if (!fits) {
    const std::string neither = has_expression(*request) || has_expression(*offer)
                                    ? unrelated_expression(offer_meant, asked, prepared, vocabulary)
                                    : unrelated(vocabulary, offer->concept_iri, request->concept_iri);
    return "concept: " + neither + overlap_misfit(offer_meant, prepared.classes, prepared.asks.overlaps, vocabulary);
  }
  if (offer->representation_iri.empty()) {
    return "representation: none is stated, " + named(vocabulary, request->representation_iri) + " is asked for";
  }
  std::string why = "representation: " + unrelated(vocabulary, offer->representation_iri, request->representation_iri);
  if (degree_of_name(offer_meant.representation(), request_meant.representation(), vocabulary)) {
    why = "representation: it is not the same, and the concept has no class by which to compare";
  }
  return why + conversion_misfit(side.classes, prepared, asked.convert, vocabulary);
}

}  // namespace

std::expected<Match, std::string> explained(const SubscriptionEntry& subscription, const Request& request,
                                            const Offer& offer, const vocabulary::Vocabulary& vocabulary) {
  const Subscription& asked = subscription.subscription;
  const Publication& offered = offer.entry.publication;
  const Finding found = compared(subscription, request, offer, vocabulary);
  std::string why;
  const auto say = [&why](const std::string& misfit) { why += (why.empty() ? "" : "; ") + misfit; };
  if (!found.by_identity) {
    say(identity_misfit({offered.identity, offer.classes}, asked, request, vocabulary));
  } else if (!is_accepted_degree(asked, request, offer, *found.by_identity, vocabulary)) {
    say("degree: " + std::string(to_string(found.by_identity->degree)) + ", but at least " +
        std::string(to_string(asked.weakest)) + " is asked for");
  }
  if (!found.is_mode_met) {
    say("mode: " + std::string(to_string(offered.mode)) + " is offered, " + std::string(to_string(asked.mode)) +
        " is asked for");
  }
  if (!found.is_provider_met) say("provider: it is not among those that are asked for");
  if (!found.is_protocol_met) {
    say("protocol: " + base::printable(offered.protocol) + " is offered, and none of those asked for");
  }
  if (!found.is_scope_met) say(scope_misfit(subscription, request, offer));
  if (!found.is_on_met) say("on: the participant is not known to be " + subscription.subscription.on);
  if (!request.where) {
    const std::string problem = unit_problem(asked.where, vocabulary.units());
    say("filter: it cannot be read" + (problem.empty() ? "" : ": " + problem));
  } else if (!found.is_where_met) {
    say("filter: " + base::printable(asked.where, max_shown_expression) +
        " does not hold: " + request.where->misses(offer.entry, vocabulary.units()));
  }
  if (!offer.audience.condition) {
    say("for: it cannot be read");
  } else if (!found.is_for_met) {
    say("for: " + base::printable(offered.for_whom, max_shown_expression) +
        " does not hold: " + offer.audience.condition->misses(subscription, vocabulary.units()));
  }
  if (!found.is_signature_met) {
    say("signature: " + signature_misfit(stated(offer.signature), *request.signature, asked.weakest, vocabulary));
  }
  if (!found.is_reach_met) say("reach: the address " + offered.address + " cannot be reached from here");
  if (!why.empty()) return std::unexpected(why);
  return *found.match;
}

}  // namespace geminga::matching
