#include "discovery/participant/queries/mending.hpp"

#include "base/text.hpp"
#include "discovery/gcnp/parameters.hpp"
#include "discovery/matching/conversions/consumer.hpp"
#include "discovery/matching/degrees/representation.hpp"
#include "discovery/participant/knowledge/naming.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::participant {
namespace {

using matching::Obstacle;

constexpr std::size_t max_name_bytes = 400;

/// A name or an expression as a client writes it.
std::string asked_name(const matching::Examination& examination, const std::string& name) {
  const auto& vocabulary = examination.vocabulary();
  return base::printable(name.find('<') == std::string::npos ? vocabulary.short_name(std::string_view(name))
                                                             : vocabulary.short_expression(name),
                         max_name_bytes);
}

/// The rest of the advice once the representation fits: " and match=broader" where the concept needs it, or nothing.
std::string match_beside(const matching::Examination& examination, const Asked& asked, const matching::Meaning& offer,
                         const SemanticIdentity& request) {
  const auto degree = matching::degree_of_concept(offer, {request, asked.request->classes}, examination.vocabulary(),
                                                  asked.request->asks.compares);
  const bool is_met = !degree || !is_weaker(degree->degree, asked.entry.subscription.weakest);
  return is_met ? "" : " and match=" + std::string(to_string(degree->degree));
}

/// The keys by which a request shuts out converters that serve others.
std::string narrowed_by(const Subscription& asked) {
  std::vector<std::string> words;
  if (!asked.protocols.empty()) words.emplace_back("protocol");
  if (!asked.providers.empty()) words.emplace_back("provider");
  if (!asked.scope.empty()) words.emplace_back("scope");
  return words.empty() ? "the scope or the condition of that service" : base::joined(words, " or ");
}

std::string mend_of_representation(const matching::Examination& examination, const Asked& asked,
                                   const matching::Meaning& offer, const SemanticIdentity& request,
                                   const vocabulary::Chain* chain) {
  const std::string beside = match_beside(examination, asked, offer, request);
  if (chain != nullptr) {
    return "ask with convert=" + std::to_string(chain->cost) + ", the cost of turning it into what is asked for" +
           (beside.empty() ? "" : "," + beside);
  }
  const std::string other = asked_name(examination, offer.identity.representation_iri);
  const std::string as_it_is = "ask with representation=" + other + beside + ", or without";
  const auto offered = offer.classes.representation_class;
  const auto requested = asked.request->classes.representation_class;
  const auto of_others = offered && requested && asked.request->chains_of_all
                             ? asked.request->chains_of_all(*offered, *requested)
                             : nullptr;
  if (of_others == nullptr) {
    const std::size_t waiting = examination.waiting_converters();
    return as_it_is + ": nothing converts " + other + " to " + asked_name(examination, request.representation_iri) +
           " in at most " + std::to_string(vocabulary::max_chain_conversions) + " steps" +
           (waiting == 0 ? ""
                         : "; or withdraw what converts and is not needed: of one participant at most " +
                               std::to_string(matching::max_converters_of_participant) + " converters take part, and " +
                               std::to_string(waiting) + (waiting == 1 ? " waits for a place" : " wait for a place"));
  }
  const bool is_dearer = of_others->cost > asked.entry.subscription.convert;
  return "widen " + narrowed_by(asked.entry.subscription) + " so that the request takes part with what converts it, " +
         of_others->via + (is_dearer ? ", with convert=" + std::to_string(of_others->cost) : "") + beside + "; or " +
         as_it_is;
}

}  // namespace

std::string mend_by_provider(const matching::Examination& examination, const Asked& asked,
                             const registry::PublicationEntry& offer, const Check& check) {
  const auto* requested = std::get_if<SemanticIdentity>(&asked.entry.subscription.identity);
  const auto* offered = std::get_if<SemanticIdentity>(&offer.publication.identity);
  const auto either = [&check](const std::string& by_provider) { return by_provider + "; or " + check.mend; };
  switch (check.obstacle) {
    case Obstacle::mode:
      return "offer it with mode=" + std::string(to_string(asked.entry.subscription.mode)) +
             ", or ask with mode=" + std::string(to_string(offer.publication.mode));
    case Obstacle::protocol:
      return either("offer it by protocol=" + asked.entry.subscription.protocols.front());
    case Obstacle::where:
      return "offer what its where asks for, or ask for less";
    case Obstacle::outranked:
    case Obstacle::incumbent:
      return either("offer it with a greater priority");
    case Obstacle::for_whom:
      return "ask for less in for, or state in the request what it asks for";
    default:
      break;
  }
  if (requested == nullptr || offered == nullptr) return check.mend;
  const std::string concept_name = asked_name(examination, requested->concept_iri);
  const std::string representation = asked_name(examination, requested->representation_iri);
  switch (check.obstacle) {
    case Obstacle::broader:
      return either("offer " + concept_name + " or what is below it");
    case Obstacle::degree:
      return either("offer " + concept_name + " itself");
    case Obstacle::unrelated:
      return "offer " + concept_name + " or what is below it, or say in the ontology that " +
             asked_name(examination, offered->concept_iri) + " is";
    case Obstacle::representation:
    case Obstacle::unknown_representation:
      return either("offer it with representation=" + representation + ", too, or offer what converts=" +
                    asked_name(examination, offered->representation_iri) + ">" + representation);
    default:
      return check.mend;
  }
}

std::string mend_of_identity(const matching::Examination& examination, const Asked& asked,
                             const registry::PublicationEntry& offered, Obstacle obstacle,
                             const std::optional<matching::Match>& match, const vocabulary::Chain* chain) {
  const auto* offer = std::get_if<SemanticIdentity>(&offered.publication.identity);
  const auto* request = std::get_if<SemanticIdentity>(&asked.entry.subscription.identity);
  switch (obstacle) {
    case Obstacle::kind:
      return "ask for it by the kind of identity that is offered, or offer it by the one that is asked for";
    case Obstacle::number:
    case Obstacle::text:
      return "use one " + std::string(to_string(obstacle)) + " on both sides";
    case Obstacle::similar_text:
      return "write one text on both sides: they differ by few letters";
    case Obstacle::clash:
      return "ask for the concept and offer the concept, not the number";
    case Obstacle::no_ontology:
      return "start gemingad with --ontology";
    case Obstacle::unknown_concept:
    case Obstacle::unknown_offer:
    case Obstacle::unknown_representation:
      return std::string(mend_of_ontologies);
    case Obstacle::unsatisfiable:
      return "correct the ontology: geminga-ontology check says why it can have no instance";
    case Obstacle::unclassified:
      return "ask for a named concept, or load an ontology that knows all names of the expression";
    case Obstacle::unclassified_offer:
      return "offer a named concept, or load an ontology that knows all names of the expression: geminga-query "
             "services "
             "says what is wrong with it";
    case Obstacle::disjoint:
      return "ask for something else, or correct the ontology if something can be both";
    case Obstacle::undecided:
      return "ask again in a second, or ask for something that subsumes what is offered";
    case Obstacle::incomplete:
      return std::string(mend_of_gaps);
    case Obstacle::unrelated:
      return "ask for " + (offer == nullptr ? "" : asked_name(examination, offer->concept_iri)) +
             " or for something above it, or say in the ontology that it is subsumed";
    case Obstacle::representation_unstated:
      return "state representation=" +
             (request == nullptr ? "" : asked_name(examination, request->representation_iri)) +
             " in the offer, or ask without a representation";
    case Obstacle::representation:
      return offer == nullptr || request == nullptr
                 ? ""
                 : mend_of_representation(examination, asked, {*offer, examination.classes(offered)}, *request, chain);
    case Obstacle::broader:
    case Obstacle::degree:
      // Of what is converted the concept is too weak, and `match` is about that: it is narrower at the most.
      return "ask with match=" + std::string(to_string(!match                               ? Degree::broader
                                                       : match->degree == Degree::converted ? Degree::narrower
                                                                                            : match->degree));
    default:
      return "";
  }
}

}  // namespace geminga::participant
