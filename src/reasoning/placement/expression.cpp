// Questions about a place are answered from the taxonomy around it.
#include "reasoning/placement/expression.hpp"

#include <algorithm>

#include "base/sorted.hpp"
#include "reasoning/compiled/ontology.hpp"

namespace geminga::placement {
namespace {

void keep_smaller(std::optional<std::uint32_t>& best, std::optional<std::uint32_t> other) {
  if (other && (!best || *other < *best)) best = other;
}

}  // namespace

bool is_below(const ExpressionPlace& place, taxonomy::ClassNumber super, const compiled::Ontology& ontology) {
  if (!place.is_satisfiable) return true;
  if (place.equivalent) return ontology.is_subsumed(*place.equivalent, super);
  return std::ranges::any_of(place.parents,
                             [&](taxonomy::ClassNumber parent) { return ontology.is_subsumed(parent, super); });
}

bool is_above(const ExpressionPlace& place, taxonomy::ClassNumber sub, const compiled::Ontology& ontology) {
  if (!ontology.is_satisfiable(sub)) return true;
  if (place.equivalent) return ontology.is_subsumed(sub, *place.equivalent);
  return std::ranges::any_of(place.children,
                             [&](taxonomy::ClassNumber child) { return ontology.is_subsumed(sub, child); });
}

std::optional<std::uint32_t> distance_up(const ExpressionPlace& place, taxonomy::ClassNumber super,
                                         const compiled::Ontology& ontology) {
  if (place.equivalent) return ontology.distance(*place.equivalent, super);
  std::optional<std::uint32_t> best;
  for (const taxonomy::ClassNumber parent : place.parents) keep_smaller(best, ontology.distance(parent, super));
  if (best) ++*best;
  return best;
}

std::optional<std::uint32_t> distance_down(const ExpressionPlace& place, taxonomy::ClassNumber sub,
                                           const compiled::Ontology& ontology) {
  if (place.equivalent) return ontology.distance(sub, *place.equivalent);
  std::optional<std::uint32_t> best;
  for (const taxonomy::ClassNumber child : place.children) keep_smaller(best, ontology.distance(sub, child));
  if (best) ++*best;
  return best;
}

std::vector<taxonomy::ClassNumber> subsumers(const ExpressionPlace& place, const compiled::Ontology& ontology) {
  if (place.equivalent) return ontology.subsumers(*place.equivalent);
  std::vector<taxonomy::ClassNumber> classes;
  if (!place.is_satisfiable) {
    for (std::uint32_t number = 0; number < ontology.class_count(); ++number)
      classes.push_back(taxonomy::ClassNumber{number});
    return classes;
  }
  for (const taxonomy::ClassNumber parent : place.parents) {
    const std::vector<taxonomy::ClassNumber> above = ontology.subsumers(parent);
    classes.insert(classes.end(), above.begin(), above.end());
  }
  base::sort_unique(classes);
  return classes;
}

}  // namespace geminga::placement
