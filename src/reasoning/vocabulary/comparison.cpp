// Compares two expressions: by their places where these decide it, else by the rules of placement.
#include "reasoning/vocabulary/comparison.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "reasoning/vocabulary/expression.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::vocabulary {
namespace {

using Relation = Comparison::Relation;

/// The edges from one expression up to another over a class between them; nothing where there is none.
std::optional<std::uint32_t> way_over_a_class(const Vocabulary& vocabulary, const Place& sub, const Place& super) {
  if (sub.equivalent) return vocabulary.distance_down(super, *sub.equivalent);
  if (super.equivalent) return vocabulary.distance_up(sub, *super.equivalent);
  std::optional<std::uint32_t> least;
  for (const ClassNumber child : super.children) {
    const auto up = vocabulary.distance_up(sub, child);
    if (up && (!least || *up + 1 < *least)) least = *up + 1;
  }
  return least;
}

/// Whether the places show that the first is not below the second: a class above the second is not above the first, or
/// one below the first is not below the second, and the place that would say so misses nothing.
bool is_certainly_not_below(const Vocabulary& vocabulary, const Place& sub, const Place& super) {
  const bool is_above_missing = sub.gaps.empty() && std::ranges::any_of(super.parents, [&](ClassNumber parent) {
                                  return !vocabulary.distance_up(sub, parent);
                                });
  const bool is_below_missing = super.gaps.empty() && std::ranges::any_of(sub.children, [&](ClassNumber child) {
                                  return !vocabulary.is_above(super, child);
                                });
  return is_above_missing || is_below_missing;
}

std::vector<std::string> united(const std::vector<std::string>& one, const std::vector<std::string>& other) {
  std::set<std::string> all(one.begin(), one.end());
  all.insert(other.begin(), other.end());
  return {all.begin(), all.end()};
}

}  // namespace

std::optional<Comparison> Vocabulary::compare(const Place& one, const Place& other) const {
  const auto up = way_over_a_class(*this, one, other);
  const auto down = way_over_a_class(*this, other, one);
  if (up && down) return Comparison{.relation = Relation::equivalent};
  if (up) return Comparison{.relation = Relation::narrower, .distance = *up};
  if (down) return Comparison{.relation = Relation::broader, .distance = *down};
  // An expression that is equivalent to a class relates to the other as the class does, by the other's place.
  if (one.equivalent || other.equivalent) return Comparison{.gaps = united(one.gaps, other.gaps)};
  if (is_certainly_not_below(*this, one, other) && is_certainly_not_below(*this, other, one)) return Comparison{};
  return std::nullopt;
}

Comparison Vocabulary::compare(const Expression& one, const Place& place, const Expression& other,
                               const Place& place_of_other) const {
  if (const auto by_place = compare(place, place_of_other)) return *by_place;
  const auto up = is_subsumed(one, other);
  const auto down = is_subsumed(other, one);
  if (up.holds && down.holds) return {.relation = Relation::equivalent};
  if (up.holds) return {.relation = Relation::narrower, .distance = 1};
  if (down.holds) return {.relation = Relation::broader, .distance = 1};
  return {.gaps = united(up.gaps, down.gaps)};
}

}  // namespace geminga::vocabulary
