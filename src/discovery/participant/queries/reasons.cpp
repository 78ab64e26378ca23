#include "discovery/participant/queries/reasons.hpp"

#include <algorithm>
#include <iterator>
#include <string_view>
#include <utility>

#include "base/text.hpp"
#include "discovery/participant/knowledge/naming.hpp"
#include "discovery/participant/queries/lines.hpp"
#include "discovery/participant/queries/mending.hpp"

namespace geminga::participant {
namespace {

using matching::Obstacle;
using registry::PublicationEntry;

constexpr std::size_t max_shown_bytes = 400;

std::string shown(const vocabulary::Vocabulary& vocabulary, const std::string& iri) {
  return base::printable(vocabulary.short_name(std::string_view(iri)), max_shown_bytes);
}

/// A name that is asked for and that the ontology does not know.
const std::string* unknown_name(const vocabulary::Vocabulary& vocabulary, const SemanticIdentity& asked) {
  if (!has_expression(asked) && !vocabulary.find_iri(asked.concept_iri)) return &asked.concept_iri;
  const bool is_stated = !asked.representation_iri.empty();
  return is_stated && !vocabulary.find_iri(asked.representation_iri) ? &asked.representation_iri : nullptr;
}

/// Why offers may be missed; empty where none is missed, or where the reasoner is asked about each.
std::string gaps_of(const Asked& asked) {
  if (asked.entry.subscription.weakest == Degree::overlapping) return "";
  return matching::gap_words(asked.request->classes);
}

/// Whether somebody on the air has another ontology, by which concepts may be offered that are unknown here.
bool has_other_ontologies(const membership::Neighbours& neighbours, std::uint64_t digest) {
  bool has_others = false;
  neighbours.for_each(
      [&](const membership::Neighbour& one) { has_others = has_others || one.ontology_digest != digest; });
  return has_others;
}

std::string told_representations(const vocabulary::Vocabulary& vocabulary, const Nearest& nearest) {
  std::vector<std::string> names;
  for (const std::string& iri : nearest.representations) names.push_back(shown(vocabulary, iri));
  return base::joined(names, ", ");
}

}  // namespace

void Nearest::consider(const ServiceKey& key, const Identity& identity, const matching::Finding& finding) {
  if (finding.meets()) return;  // it is about to be gone
  if (finding.identity == Obstacle::unknown_offer && unknown_count++ == 0) unknown = key;
  Misfit one{key, finding};
  if (!misfit || one < *misfit) misfit = one;
  if (finding.is_near()) misfits.insert(one);
  if (misfits.size() > max_told_misfits) misfits.erase(std::prev(misfits.end()));
  const auto* semantic = std::get_if<SemanticIdentity>(&identity);
  if (finding.identity != Obstacle::representation || representations.size() >= max_told_representations) return;
  if (std::ranges::find(representations, semantic->representation_iri) == representations.end()) {
    representations.push_back(semantic->representation_iri);
  }
}

void append_reason(Line& line, const Reason& reason) {
  gcnp::append(line, "code", std::string(to_string(reason.obstacle)));
  gcnp::append(line, "text", reason.text);
  gcnp::append_stated(line, "mend", reason.mend);
}

void append_because(Line& line, const Reason& reason) {
  gcnp::append(line, "why", std::string(to_string(reason.obstacle)));
  gcnp::append(line, "because", reason.text + (reason.mend.empty() ? "" : ": " + reason.mend));
}

/// Names the participant's ontology where that is another one than ours, to stand behind a sentence; else empty.
std::string Reasons::beside_other_ontology(ParticipantId user) const {
  const auto other = neighbours_.find(user);
  const std::uint64_t own = matcher_.editions().vocabulary().digest();
  if (!other || other->ontology_digest == own) return "";
  return "; " + base::printable(other->name) + " has the ontology " + digest_word(other->ontology_digest) +
         ", this host has " + digest_word(own);
}

Reason Reasons::of_nobody(const Asked& asked) const {
  const Identity& identity = asked.entry.subscription.identity;
  const bool is_concept = std::holds_alternative<SemanticIdentity>(identity);
  Reason reason{Obstacle::nobody,
                "nobody offers " + words(matcher_.editions().vocabulary(), identity) +
                    (!is_concept ? ""
                     : asked.entry.subscription.weakest == Degree::overlapping
                         ? ", nor anything that can have instances in common with it"
                         : ", nor anything below or above it"),
                "start the module that offers it; geminga-query services lists what is offered"};
  if (is_concept) reason.text += beside_other_ontology(asked.entry.key.participant);
  return reason;
}

Reason Reasons::of_nobody(const PublicationEntry& offer) const {
  const Identity& identity = offer.publication.identity;
  const bool is_concept = std::holds_alternative<SemanticIdentity>(identity);
  Reason reason{Obstacle::nobody,
                "nobody asks for " + words(matcher_.editions().vocabulary(), identity) +
                    (is_concept ? ", nor for anything below or above it" : ""),
                "start the module that asks for it; geminga-query requests lists what is asked for"};
  if (is_concept) reason.text += beside_other_ontology(offer.key.participant);
  return reason;
}

/// The reason where an offered concept is unknown here: it may be what is asked for.
std::optional<Reason> Reasons::of_unknown_offers(const Asked& asked, const Nearest& nearest) const {
  const auto* offer = nearest.unknown ? matcher_.publications().find_entry(*nearest.unknown) : nullptr;
  if (offer == nullptr) return std::nullopt;
  const auto& offered = std::get<SemanticIdentity>(offer->publication.identity);
  const std::string count =
      nearest.unknown_count == 1 ? "one service: " : std::to_string(nearest.unknown_count) + " services, such as ";
  Reason reason{
      Obstacle::unknown_offer,
      "nobody offers " + words(matcher_.editions().vocabulary(), asked.entry.subscription.identity) +
          ", nor anything that is known to be below or above it; the ontology here does not know the concept of " +
          count + shown(matcher_.editions().vocabulary(), offered.concept_iri) + " of " + to_string(offer->key),
      std::string(mend_of_ontologies)};
  reason.text += beside_other_ontology(offer->key.participant);
  return reason;
}

Reason Reasons::of_unknown_name(Piece& piece, ParticipantId user, const std::string& iri, Obstacle obstacle) {
  Reason reason{obstacle, shown(matcher_.editions().vocabulary(), iri) + " is unknown to the ontology",
                "correct the name, or load an ontology that has it"};
  if (searches_left_ > 0) {
    --searches_left_;
    piece.add_work(cost_of_unknown_name);
    piece.look_at(cost_of_searched_name);
    const auto found =
        matcher_.editions().vocabulary().find(matcher_.editions().vocabulary().short_name(std::string_view(iri)));
    if (!found) reason.text = base::printable(found.error(), max_shown_bytes);
  }
  if (const std::string other = beside_other_ontology(user); !other.empty()) {
    reason.obstacle = Obstacle::ontology_differs;
    reason.text += other;
    reason.mend = mend_of_ontologies;
  }
  return reason;
}

/// A fault of the request itself, whatever is offered.
std::optional<Reason> Reasons::of_request(Piece& piece, const Asked& asked) {
  if (!asked.request->where || !asked.request->scope) {
    const std::string problem =
        matching::unit_problem(asked.entry.subscription.where, matcher_.editions().vocabulary().units());
    if (!problem.empty()) {
      return Reason{Obstacle::unreadable, "its condition cannot be read here: " + problem,
                    std::string(mend_of_ontologies)};
    }
    return Reason{
        Obstacle::unreadable, "its condition or its scope cannot be read here",
        "the consumer's host has a newer version, which knows more conditions: install one version on all hosts"};
  }
  const auto* semantic = std::get_if<SemanticIdentity>(&asked.entry.subscription.identity);
  if (semantic == nullptr) return std::nullopt;
  if (!matcher_.editions().vocabulary().is_loaded()) {
    return Reason{Obstacle::no_ontology, "no ontology is loaded here, and nobody offers the very same names",
                  "start gemingad with --ontology"};
  }
  if (const std::string* unknown = unknown_name(matcher_.editions().vocabulary(), *semantic)) {
    const bool is_concept = unknown == &semantic->concept_iri;
    return of_unknown_name(piece, asked.entry.key.participant, *unknown,
                           is_concept ? Obstacle::unknown_concept : Obstacle::unknown_representation);
  }
  if (has_expression(*semantic) && !asked.request->classes.place) {
    Reason reason{Obstacle::unclassified,
                  "the expression is unknown to the ontology, unsatisfiable, or waits to be classified",
                  "ask again in a second, or ask for a named concept"};
    reason.text += beside_other_ontology(asked.entry.key.participant);
    return reason;
  }
  if (!has_expression(*semantic) && !asked.request->classes.concept_class) {
    return Reason{
        Obstacle::unsatisfiable,
        shown(matcher_.editions().vocabulary(), semantic->concept_iri) + " is unsatisfiable: it can have no instance",
        "correct the ontology: geminga-ontology check says why"};
  }
  if (const std::string gaps = gaps_of(asked); !gaps.empty()) {
    return Reason{Obstacle::incomplete,
                  "nothing that is offered is known to be below or above " +
                      words(matcher_.editions().vocabulary(), asked.entry.subscription.identity) +
                      ", but the answer may be incomplete, as no class is defined by the expression: " + gaps,
                  std::string(mend_of_gaps)};
  }
  return std::nullopt;
}

Reason Reasons::of(Piece& piece, const Asked& asked, const Nearest& nearest) {
  // That something may have been missed is a reason of the request, not of one offer.
  const bool is_near =
      nearest.misfit && nearest.misfit->finding.is_near() && nearest.misfit->finding.identity != Obstacle::incomplete;
  const auto* offer = is_near ? matcher_.publications().find_entry(nearest.misfit->key) : nullptr;
  if (offer == nullptr) {
    auto reason = of_request(piece, asked);
    const bool is_general = !reason || reason->obstacle == Obstacle::incomplete;
    if (auto unknown = is_general ? of_unknown_offers(asked, nearest) : std::nullopt) return std::move(*unknown);
    return reason ? std::move(*reason) : of_nobody(asked);
  }
  const Check check = misfit_of(matcher_, neighbours_, asked, *offer, nearest.misfit->finding.first());
  Reason reason{check.obstacle, to_string(offer->key) + ": " + check.text, check.mend};
  if (check.obstacle == Obstacle::representation && nearest.representations.size() > 1) {
    reason.text += "; offered are " + told_representations(matcher_.editions().vocabulary(), nearest);
  }
  if (const std::string gaps = gaps_of(asked); !gaps.empty()) {
    reason.text += "; the answer may be incomplete, as no class is defined by the expression: " + gaps;
    reason.mend += "; or " + std::string(mend_of_gaps);
  }
  return reason;
}

Reason Reasons::likely(Piece& piece, const registry::SubscriptionEntry& request) {
  Asked asked{.entry = request, .request = matcher_.examination().prepare(request)};
  Subscription wider = request.subscription;
  if (wider.weakest != Degree::overlapping) wider.weakest = Degree::broader;
  Nearest nearest;
  const auto consider = [&](const PublicationEntry& offer) {
    nearest.consider(offer.key, offer.publication.identity,
                     matcher_.examination().examine(asked.entry, *asked.request, offer));
  };
  for (const ServiceKey& key : matcher_.search().some_candidates(wider, *asked.request, max_examined_offers)) {
    if (const auto* offer = matcher_.publications().find_entry(key)) consider(*offer);
  }
  const bool is_text = std::holds_alternative<TextIdentity>(request.subscription.identity);
  const bool may_be_unknown = std::holds_alternative<SemanticIdentity>(request.subscription.identity) &&
                              matcher_.editions().vocabulary().is_loaded() &&
                              has_other_ontologies(neighbours_, matcher_.editions().vocabulary().digest());
  if (!nearest.misfit && (is_text || may_be_unknown)) {
    std::size_t left = max_compared_offers;
    matcher_.publications().visit_after(std::nullopt, [&](const registry::StoredPublication& offer) {
      piece.add_work(cost_of_entry);
      consider(offer.entry);
      return --left > 0;
    });
  }
  return of(piece, asked, nearest);
}

/// A fault of the offer itself, whatever is asked for.
std::optional<Reason> Reasons::of_offer(Piece& piece, const PublicationEntry& offer) {
  if (!matching::Scope::parse(offer.publication.scope) || !matching::Where::parse(offer.publication.for_whom)) {
    return Reason{
        Obstacle::unreadable, "its condition or its scope cannot be read here",
        "the provider's host has a newer version, which knows more conditions: install one version on all hosts"};
  }
  const auto* semantic = std::get_if<SemanticIdentity>(&offer.publication.identity);
  if (semantic == nullptr) return std::nullopt;
  const auto& vocabulary = matcher_.editions().vocabulary();
  if (!vocabulary.is_loaded()) {
    return Reason{Obstacle::no_ontology, "no ontology is loaded here, and nobody asks for the very same names",
                  "start gemingad with --ontology"};
  }
  if (has_expression(*semantic)) {
    if (matcher_.examination().classes(offer).place) return std::nullopt;
    Reason reason{Obstacle::unclassified_offer,
                  "the expression is unknown to the ontology, unsatisfiable, or waits to be classified",
                  "look again in a second, or offer a named concept"};
    reason.text += beside_other_ontology(offer.key.participant);
    return reason;
  }
  const auto concept_class = vocabulary.find_iri(semantic->concept_iri);
  if (!concept_class) {
    return of_unknown_name(piece, offer.key.participant, semantic->concept_iri, Obstacle::unknown_offer);
  }
  if (!vocabulary.is_satisfiable(*concept_class)) {
    return Reason{
        Obstacle::unsatisfiable,
        shown(matcher_.editions().vocabulary(), semantic->concept_iri) + " is unsatisfiable: it can have no instance",
        "correct the ontology: geminga-ontology check says why"};
  }
  if (!semantic->representation_iri.empty() && !vocabulary.find_iri(semantic->representation_iri)) {
    return of_unknown_name(piece, offer.key.participant, semantic->representation_iri,
                           Obstacle::unknown_representation);
  }
  return std::nullopt;
}

Reason Reasons::of(Piece& piece, const PublicationEntry& offer, const Nearest& nearest) {
  const bool is_near = nearest.misfit && nearest.misfit->finding.is_near();
  const auto* request = is_near ? matcher_.subscriptions().find_entry(nearest.misfit->key) : nullptr;
  if (request == nullptr) {
    auto reason = of_offer(piece, offer);
    return reason ? std::move(*reason) : of_nobody(offer);
  }
  const Asked asked{.entry = *request, .request = matcher_.examination().prepare(*request)};
  const Check check = misfit_of(matcher_, neighbours_, asked, offer, nearest.misfit->finding.first());
  Reason reason{check.obstacle, to_string(request->key) + ": " + check.text,
                mend_by_provider(matcher_.examination(), asked, offer, check)};
  if (check.obstacle == Obstacle::representation && nearest.representations.size() > 1) {
    reason.text += "; asked for are " + told_representations(matcher_.editions().vocabulary(), nearest);
  }
  return reason;
}

Reason Reasons::likely(Piece& piece, const PublicationEntry& offer) {
  Nearest nearest;
  const auto consider = [&](const registry::SubscriptionEntry& request, const matching::Finding& finding) {
    nearest.consider(request.key, request.subscription.identity, finding);
    return true;
  };
  piece.add_work(cost_of_entry * matcher_.search().examine_near(offer, max_examined_requests, consider));
  if (!nearest.misfit && std::holds_alternative<TextIdentity>(offer.publication.identity)) {
    std::size_t left = max_compared_requests;
    matcher_.search().examine_requests(
        std::nullopt, offer, [&](const registry::SubscriptionEntry& request, const matching::Finding& finding) {
          piece.add_work(cost_of_entry);
          consider(request, finding);
          return --left > 0;
        });
  }
  return of(piece, offer, nearest);
}

}  // namespace geminga::participant
