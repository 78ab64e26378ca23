// Who may match whom: look-ups in the registry that miss nobody and seldom give one too many.
#ifndef GEMINGA_MATCHING_CANDIDATES_HPP
#define GEMINGA_MATCHING_CANDIDATES_HPP

#include <algorithm>
#include <set>
#include <utility>
#include <variant>
#include <vector>

#include "el/ontology.hpp"
#include "geminga/service.hpp"
#include "matching/degree.hpp"
#include "registry/table.hpp"

namespace geminga::matching {

/// The classes that an entry is filed under, kept alive for a registry::Filing.
class FilingPlan {
 public:
  /// A publication is filed below every subsumer of its concept, itself included.
  [[nodiscard]] static FilingPlan of_publication(const Classes& classes, const el::Ontology* ontology);
  /// A subscription is filed below its subsumers only when it accepts broader concepts: then they may meet it.
  [[nodiscard]] static FilingPlan of_subscription(const Classes& classes, Degree weakest, const el::Ontology* ontology);

  /// Borrows from this.
  [[nodiscard]] registry::Filing filing() const { return {own_, below_, further_own_}; }

 private:
  FilingPlan(std::optional<el::ClassNumber> own, bool is_below, const el::Ontology* ontology);
  /// Of an expression: under the classes right below it, below which its narrower offers are.
  FilingPlan(const el::ExpressionPlace& place, bool is_below, const el::Ontology& ontology);

  std::optional<registry::ClassIndex> own_;
  std::vector<registry::ClassIndex> below_;
  std::vector<registry::ClassIndex> further_own_;
};

/// As visit_publications() for an expression in a place.
template <typename Visit>
void visit_publications_around(const registry::Publications& publications, const el::ExpressionPlace& place,
                               Degree weakest, const el::Ontology& ontology, const Visit& visit) {
  std::set<std::uint32_t> seen;  // a concept may be below several of the classes right below the expression
  const auto visit_all = [&](auto filed) {
    for (const auto& one : filed) {
      if (seen.insert(one.stored->slot).second && visit(*one.stored)) return true;
    }
    return false;
  };
  const auto below = [&](el::ClassNumber number) { return visit_all(publications.below(std::to_underlying(number))); };
  if (place.equivalent ? below(*place.equivalent) : std::ranges::any_of(place.children, below)) return;
  if (weakest < Degree::broader) return;
  for (const el::ClassNumber wider : el::subsumers(place, ontology)) {
    if (visit_all(publications.own(std::to_underlying(wider)))) return;
  }
}

/// Calls `visit` once for each publication whose concept may meet the request's. `visit` gives true to stop.
template <typename Visit>
void visit_publications(const registry::Publications& publications, const Identity& requested, const Classes& classes,
                        Degree weakest, const el::Ontology* ontology, const Visit& visit) {
  const auto visit_all = [&visit](auto filed) {
    for (const auto& one : filed) {
      if (visit(*one.stored)) return true;
    }
    return false;
  };
  const auto* semantic = std::get_if<SemanticIdentity>(&requested);
  if (std::holds_alternative<NumericIdentity>(requested)) {
    std::ranges::any_of(publications.with_number(id32(requested)), visit_all);
    return;
  }
  if (semantic == nullptr) {
    visit_all(publications.with_identity(requested, id32(requested)));
    return;
  }
  if (!has_expression(requested)) {
    const NumericIdentity number{id32(requested)};
    if (visit_all(publications.with_identity(number, number.number))) return;
  }
  if (classes.place) {
    visit_publications_around(publications, *classes.place, weakest, *ontology, visit);
  } else if (!classes.concept_class) {
    visit_all(publications.with_concept(semantic->concept_iri));
  } else {
    const el::ClassNumber wanted = *classes.concept_class;
    if (visit_all(publications.below(std::to_underlying(wanted))) || weakest < Degree::broader) return;
    for (const el::ClassNumber wider : ontology->subsumers(wanted)) {
      if (ontology->is_subsumed(wider, wanted)) continue;  // visited already
      if (visit_all(publications.own(std::to_underlying(wider)))) return;
    }
  }
}

/// The subscriptions that an offer may meet, each once, in ascending order of key.
[[nodiscard]] std::vector<const registry::StoredSubscription*> standing_subscriptions(
    const registry::Subscriptions& subscriptions, const Identity& offered, const Classes& classes,
    const el::Ontology* ontology);

/// Sorts by key and drops what is there twice.
void order_by_key(std::vector<const registry::StoredSubscription*>& subscriptions);

}  // namespace geminga::matching

#endif
