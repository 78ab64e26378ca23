#include "discovery/participant/queries/mending.hpp"

#include "base/text.hpp"
#include "discovery/gcnp/parameters.hpp"
#include "discovery/participant/naming.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::participant {
namespace {

using matching::Obstacle;

constexpr std::size_t max_name_bytes = 400;

/// Names and expressions as a client writes them.
std::string asked_name(const Core& core, const std::string& name) {
  const auto& vocabulary = core.vocabulary();
  return base::printable(name.find('<') == std::string::npos ? vocabulary.short_name(std::string_view(name))
                                                             : vocabulary.short_expression(name),
                         max_name_bytes);
}

}  // namespace

std::string mend_by_provider(const Core& core, const Asked& asked, const registry::PublicationEntry& offer,
                             const Check& check) {
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
  const std::string concept_name = asked_name(core, requested->concept_iri);
  const std::string representation = asked_name(core, requested->representation_iri);
  switch (check.obstacle) {
    case Obstacle::broader:
      return either("offer " + concept_name + " or what is below it");
    case Obstacle::degree:
      return either("offer " + concept_name + " itself");
    case Obstacle::unrelated:
      return "offer " + concept_name + " or what is below it, or say in the ontology that " +
             asked_name(core, offered->concept_iri) + " is";
    case Obstacle::representation:
    case Obstacle::unknown_representation:
      return either("offer it with representation=" + representation + ", too, or offer what converts=" +
                    asked_name(core, offered->representation_iri) + ">" + representation);
    default:
      return check.mend;
  }
}

}  // namespace geminga::participant
