// Who may match whom: look-ups in the registry that miss nobody and seldom give one too many.
#ifndef GEMINGA_DISCOVERY_MATCHING_CANDIDATES_HPP
#define GEMINGA_DISCOVERY_MATCHING_CANDIDATES_HPP

#include <algorithm>
#include <memory>
#include <set>
#include <utility>
#include <variant>
#include <vector>

#include "discovery/matching/converters.hpp"
#include "discovery/matching/degree.hpp"
#include "discovery/registry/table.hpp"
#include "geminga/service.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::matching {

/// One of the vocabularies that are at work while one takes the place of another, with the index that is filed by it.
struct Edition {
  vocabulary::Vocabulary vocabulary;
  registry::Generation generation = registry::Generation::even;
  std::shared_ptr<Converters> converters{};  ///< null where there is no vocabulary
};

/// The classes that an entry is filed under, kept alive for a registry::Filing.
class FilingPlan {
 public:
  /// A publication is filed below every subsumer of its concept, itself included.
  [[nodiscard]] static FilingPlan of_publication(const Classes& classes, const Edition& edition);
  /// A subscription is filed below its subsumers only when it accepts broader concepts: then they may meet it. One that
  /// accepts concepts that overlap is filed under owl:Thing: every concept may meet it.
  [[nodiscard]] static FilingPlan of_subscription(const Classes& classes, Degree weakest, const Edition& edition);

  /// Borrows from this.
  [[nodiscard]] registry::Filing filing() const { return {own_, below_, further_own_, generation_}; }
  /// How many classes it is filed under.
  [[nodiscard]] std::size_t size() const { return below_.size() + further_own_.size() + (own_ ? 1 : 0); }

 private:
  FilingPlan(std::optional<vocabulary::ClassNumber> own, bool is_below, const Edition& edition);
  /// Of an expression: under the classes right below it, below which its narrower offers are.
  FilingPlan(const vocabulary::Place& place, bool is_below, const Edition& edition);

  registry::Generation generation_;
  std::optional<registry::ClassIndex> own_;
  std::vector<registry::ClassIndex> below_;
  std::vector<registry::ClassIndex> further_own_;
};

/// Whether `match` allows concepts that are broader.
[[nodiscard]] constexpr bool accepts_broader(Degree weakest) { return !is_weaker(Degree::broader, weakest); }

/// As visit_publications() for an expression in a place.
template <typename Visit>
void visit_publications_around(const registry::Publications& publications, const vocabulary::Place& place,
                               Degree weakest, const Edition& edition, const Visit& visit) {
  std::set<std::uint32_t> seen;  // a concept may be below several of the classes right below the expression
  const auto visit_all = [&](auto filed) {
    for (const auto& one : filed) {
      if (seen.insert(one.stored->slot).second && visit(*one.stored)) return true;
    }
    return false;
  };
  const auto below = [&](vocabulary::ClassNumber number) {
    return visit_all(publications.below(std::to_underlying(number), edition.generation));
  };
  if (place.equivalent ? below(*place.equivalent) : std::ranges::any_of(place.children, below)) return;
  if (!accepts_broader(weakest)) return;
  for (const vocabulary::ClassNumber wider : edition.vocabulary.subsumers(place)) {
    if (visit_all(publications.own(std::to_underlying(wider), edition.generation))) return;
  }
}

/// Calls `visit` once for each publication whose concept may meet the request's. `visit` gives true to stop.
template <typename Visit>
void visit_publications(const registry::Publications& publications, const Identity& requested, const Classes& classes,
                        Degree weakest, const Edition& edition, const Visit& visit) {
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
  const bool has_class = classes.place || classes.concept_class;
  if (has_class && weakest == Degree::overlapping) {
    visit_all(publications.below(std::to_underlying(edition.vocabulary.thing()), edition.generation));
  } else if (classes.place) {
    visit_publications_around(publications, *classes.place, weakest, edition, visit);
  } else if (!classes.concept_class) {
    visit_all(publications.with_concept(semantic->concept_iri));
  } else {
    const vocabulary::ClassNumber wanted = *classes.concept_class;
    if (visit_all(publications.below(std::to_underlying(wanted), edition.generation)) || !accepts_broader(weakest)) {
      return;
    }
    for (const vocabulary::ClassNumber wider : edition.vocabulary.subsumers(wanted)) {
      if (edition.vocabulary.is_subsumed(wider, wanted)) continue;  // visited already
      if (visit_all(publications.own(std::to_underlying(wider), edition.generation))) return;
    }
  }
}

/// Appends the subscriptions of one edition that an offer, which has these classes and is filed by them, may meet, and
/// those that it may meet whatever the classes, in no order and perhaps more than once.
void add_subscriptions_for(const registry::Subscriptions& subscriptions, const registry::StoredPublication& offer,
                           const Classes& classes, const Edition& edition,
                           std::vector<const registry::StoredSubscription*>& found);

/// Sorts by key and drops what is there twice.
void order_by_key(std::vector<const registry::StoredSubscription*>& subscriptions);

}  // namespace geminga::matching

#endif
