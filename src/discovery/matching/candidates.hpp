// Look-ups in the registry: all that may match an entry, and seldom more.
#ifndef GEMINGA_DISCOVERY_MATCHING_CANDIDATES_HPP
#define GEMINGA_DISCOVERY_MATCHING_CANDIDATES_HPP

#include <algorithm>
#include <set>
#include <utility>
#include <variant>
#include <vector>

#include "discovery/matching/degrees/degree.hpp"
#include "discovery/matching/editions.hpp"
#include "discovery/registry/table.hpp"
#include "geminga/service.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::matching {

/// The classes that an entry is filed under. Owns what its registry::Filing borrows.
class FilingPlan {
 public:
  /// The plan of a publication: below every subsumer of its concept, itself included. An expression is filed below its
  /// subsumers, and among the expressions.
  [[nodiscard]] static FilingPlan of_publication(const Classes& classes, const Edition& edition);
  /// The plan of a subscription. It is filed below its subsumers only where it accepts broader concepts, since these
  /// may meet it then. One that accepts overlapping concepts is filed under owl:Thing, since every concept may meet it.
  [[nodiscard]] static FilingPlan of_subscription(const Classes& classes, Degree weakest, const Edition& edition);

  /// Borrows from this plan.
  [[nodiscard]] registry::Filing filing() const { return {own_, below_, further_own_, generation_}; }
  /// How many classes the entry is filed under.
  [[nodiscard]] std::size_t size() const { return below_.size() + further_own_.size() + (own_ ? 1 : 0); }

 private:
  FilingPlan(std::optional<vocabulary::ClassNumber> own, const Edition& edition);
  /// The plan of a requested expression: under the classes right below it, because narrower offers are below these,
  /// and among the expressions.
  FilingPlan(const vocabulary::Place& place, const Edition& edition);
  /// Files it below these classes, too.
  void file_below(const std::vector<vocabulary::ClassNumber>& subsumers);

  registry::Generation generation_;
  std::optional<registry::ClassIndex> own_;
  std::vector<registry::ClassIndex> below_;
  std::vector<registry::ClassIndex> further_own_;
};

/// The bucket behind those of all classes: offered expressions, and requested ones, that are equivalent to no class.
/// Between two of these there may be no class, so that each is compared with all of the other kind.
[[nodiscard]] inline registry::ClassIndex bucket_of_expressions(const Edition& edition) {
  return edition.vocabulary.class_count();
}
/// The number of buckets in the index of an edition.
[[nodiscard]] inline std::size_t index_size(const Edition& edition) {
  return std::size_t{edition.vocabulary.class_count()} + 1;
}

/// Whether broader concepts are accepted.
[[nodiscard]] constexpr bool accepts_broader(Degree weakest) { return !is_weaker(Degree::broader, weakest); }

/// Whether a publication is filed below a class.
[[nodiscard]] inline bool is_filed_below(const registry::StoredPublication& stored, vocabulary::ClassNumber number,
                                         const Edition& edition) {
  return std::ranges::any_of(stored.classes[std::to_underlying(edition.generation)],
                             [&](const registry::ClassedAt& filed) {
                               return filed.is_below() && filed.number() == std::to_underlying(number);
                             });
}

/// visit_publications() for an expression in a place.
template <typename Visit>
void visit_publications_around(const registry::Publications& publications, const vocabulary::Place& place,
                               Degree weakest, const Edition& edition, const Visit& visit) {
  std::set<std::uint32_t> seen;  // a concept may be below several classes that are right below the expression
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
  if (visit_all(publications.own(bucket_of_expressions(edition), edition.generation))) return;
  if (!accepts_broader(weakest)) return;
  for (const vocabulary::ClassNumber wider : edition.vocabulary.subsumers(place)) {
    if (visit_all(publications.own(std::to_underlying(wider), edition.generation))) return;
  }
}

/// Calls `visit` once for each publication whose identity may meet the requested one. `visit` gives true to stop.
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
  if (has_meaning(classes) && weakest == Degree::overlapping) {
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
    for (const auto& one : publications.own(bucket_of_expressions(edition), edition.generation)) {
      if (!is_filed_below(*one.stored, wanted, edition) && visit(*one.stored)) return;
    }
  }
}

/// Appends the subscriptions that an offer with these classes may meet: those filed by one edition, and those whose
/// identity decides without classes. In no order, and perhaps more than once.
void add_subscriptions_for(const registry::Subscriptions& subscriptions, const registry::StoredPublication& offer,
                           const Classes& classes, const Edition& edition,
                           std::vector<const registry::StoredSubscription*>& found);

/// Sorts subscriptions by key, each once.
void order_by_key(std::vector<const registry::StoredSubscription*>& subscriptions);

}  // namespace geminga::matching

#endif
