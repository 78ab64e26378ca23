#include "discovery/matching/obstacle_model.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "discovery/matching/conditions/scope.hpp"
#include "discovery/matching/team.hpp"

namespace geminga::matching {
namespace {

using registry::PublicationEntry;
using registry::SubscriptionEntry;

struct Pair {
  SubscriptionEntry subscription;
  PublicationEntry publication;
};

/// Removes a condition, so that it holds.
using Waive = void (*)(Pair&);

struct Step {
  std::vector<Obstacle> obstacles;
  Waive waive;
};

/// The conditions behind the identity, in the order of QUERIES.md ("Why").
const auto steps = std::to_array<Step>({
    {{Obstacle::mode}, [](Pair& pair) { pair.subscription.subscription.mode = pair.publication.publication.mode; }},
    {{Obstacle::protocol}, [](Pair& pair) { pair.subscription.subscription.protocols.clear(); }},
    {{Obstacle::provider}, [](Pair& pair) { pair.subscription.subscription.providers.clear(); }},
    {{Obstacle::scope, Obstacle::unreadable},
     [](Pair& pair) {
       pair.subscription.subscription.scope.clear();
       pair.publication.publication.scope.clear();
     }},
    {{Obstacle::on}, [](Pair& pair) { pair.subscription.subscription.on.clear(); }},
    {{Obstacle::where, Obstacle::unreadable}, [](Pair& pair) { pair.subscription.subscription.where.clear(); }},
    {{Obstacle::for_whom, Obstacle::unreadable}, [](Pair& pair) { pair.publication.publication.for_whom.clear(); }},
    {{Obstacle::signature},
     [](Pair& pair) {
       pair.subscription.subscription.attributes.erase("inputs");
       pair.subscription.subscription.attributes.erase("outputs");
     }},
});

bool meets(const Model& model, const Pair& pair) {
  return model.would_meet(pair.subscription, pair.publication).has_value();
}

bool is_unreadable(const Pair& pair) {
  return !Scope::parse(pair.subscription.subscription.scope) || !Scope::parse(pair.publication.publication.scope) ||
         !Where::parse(pair.subscription.subscription.where) || !Where::parse(pair.publication.publication.for_whom);
}

/// Whether the obstacle says how the identities keep a pair apart of which no other condition is left.
std::string complaint_about_identity(const Model& model, Pair pair, Obstacle obstacle) {
  Subscription& asked = pair.subscription.subscription;
  const auto* offered = std::get_if<SemanticIdentity>(&pair.publication.publication.identity);
  const auto* requested = std::get_if<SemanticIdentity>(&asked.identity);
  const Subscription before = asked;
  const bool is_of_one_kind = asked.identity.index() == pair.publication.publication.identity.index();
  switch (obstacle) {
    case Obstacle::broader:
      asked.weakest = Degree::broader;
      return meets(model, pair) ? "" : "it is not broader";
    case Obstacle::degree:
      asked.weakest = Degree::narrower;
      return meets(model, pair) ? "" : "it is not narrower";
    case Obstacle::representation:
    case Obstacle::representation_unstated:
    case Obstacle::unknown_representation: {
      if (offered == nullptr || requested == nullptr) return "there is no representation";
      if (offered->representation_iri.empty() != (obstacle == Obstacle::representation_unstated)) return "unstated";
      const bool is_unknown = !model.ontology.find_iri(offered->representation_iri) ||
                              !model.ontology.find_iri(requested->representation_iri);
      if (obstacle != Obstacle::representation_unstated &&
          is_unknown != (obstacle == Obstacle::unknown_representation)) {
        return "unknown";
      }
      // The concepts are at least related.
      asked.identity = SemanticIdentity{requested->concept_iri, ""};
      asked.weakest = before.weakest == Degree::overlapping ? Degree::overlapping : Degree::broader;
      return meets(model, pair) ? "" : "the concept does not fit either";
    }
    case Obstacle::kind:
    case Obstacle::clash:
      return is_of_one_kind ? "they are of one kind" : "";
    default:
      break;
  }
  if (!is_of_one_kind) return "they are of different kinds";
  if (offered == nullptr || requested == nullptr) return "";
  if (has_expression(*requested) || has_expression(*offered)) return "";
  const auto& ontology = model.ontology;
  const auto of_asked = ontology.find_iri(requested->concept_iri);
  const auto of_offered = ontology.find_iri(offered->concept_iri);
  if (ontology.is_loaded() == (obstacle == Obstacle::no_ontology)) return "about the ontology";
  if (obstacle == Obstacle::no_ontology) return "";
  if (of_asked.has_value() == (obstacle == Obstacle::unknown_concept)) return "about the concept that is asked for";
  if (obstacle == Obstacle::unknown_concept) return "";
  if (of_offered.has_value() == (obstacle == Obstacle::unknown_offer)) return "about the concept that is offered";
  if (obstacle == Obstacle::unknown_offer) return "";
  const bool is_satisfiable = ontology.is_satisfiable(*of_asked) && ontology.is_satisfiable(*of_offered);
  if (is_satisfiable == (obstacle == Obstacle::unsatisfiable)) return "about what can be";
  if (obstacle == Obstacle::unsatisfiable) return "";
  if (ontology.is_subsumed(*of_asked, *of_offered) || ontology.is_subsumed(*of_offered, *of_asked)) {
    return "one is above the other";
  }
  const bool is_asked_to_overlap = asked.weakest == Degree::overlapping;
  const bool is_about_overlap = obstacle == Obstacle::disjoint || obstacle == Obstacle::undecided;
  return is_asked_to_overlap == is_about_overlap ? "" : "about overlapping";
}

std::string complaint_about(const Model& model, const SubscriptionEntry& subscription,
                            const PublicationEntry& publication, const Finding& finding) {
  Pair pair{subscription, publication};
  const bool is_met = meets(model, pair);
  const Obstacle first = finding.first();
  const std::string said(to_string(first));
  if (is_met != finding.meets()) return said + ", and the model says that they " + (is_met ? "meet" : "do not meet");
  if (is_met) return "";
  // With all conditions removed, only the identity can stand in the way.
  std::vector<Pair> without{pair};  // that many of the last steps
  for (auto step = steps.rbegin(); step != steps.rend(); ++step) {
    step->waive(pair);
    without.push_back(pair);
  }
  if (!meets(model, without.back())) {
    if (finding.identity == Obstacle::none) return said + ", and the identities do not meet";
    const std::string wrong = complaint_about_identity(model, without.back(), first);
    return wrong.empty() ? "" : said + ": " + wrong;
  }
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const Pair& with_it = without[steps.size() - i - 1];
    if (meets(model, with_it)) continue;
    const bool is_it = std::ranges::find(steps[i].obstacles, first) != steps[i].obstacles.end();
    if (!is_it) return said + ", and the first is " + std::string(to_string(steps[i].obstacles.front()));
    Pair alone = with_it;
    for (const Step& other : steps) {
      if (&other != &steps[i]) other.waive(alone);
    }
    if (is_unreadable(alone) != (first == Obstacle::unreadable)) return said + ", about what can be read";
    return "";
  }
  return said + ", and nothing stands in the way";
}

}  // namespace

std::string complaint(Matcher& matcher, const Model& model, const SubscriptionEntry& subscription,
                      const PublicationEntry& publication) {
  const auto request = matcher.examination().prepare(subscription);
  const Finding finding = matcher.examination().examine(subscription, *request, publication);
  if (auto wrong = complaint_about(model, subscription, publication, finding); !wrong.empty()) return wrong;
  const auto words = matcher.examination().why(subscription, publication, request->asks.chains);
  if (words.has_value() != finding.meets()) return "in words it is not so";
  std::optional<Finding> of_offer;
  matcher.search().examine_requests(std::nullopt, publication, [&](const SubscriptionEntry& one, const Finding& found) {
    if (one.key == subscription.key) of_offer = found;
    return !of_offer;
  });
  if (!of_offer || of_offer->first() != finding.first()) return "it is not so for the offer";
  const auto standing = standing_of(matcher, subscription.key, publication.key);
  if (standing.has_value() != finding.meets()) return "it stands where it does not meet, or does not where it meets";
  if (!standing || !subscription.is_local) return "";
  if (standing->is_chosen != model.is_chosen(subscription.key, publication.key)) return "chosen, or not";
  return (standing->rival == nullptr) == standing->is_chosen ? "" : "about its rival";
}

}  // namespace geminga::matching
