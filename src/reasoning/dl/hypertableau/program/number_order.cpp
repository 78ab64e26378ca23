// How number restrictions are grouped into families of one role and filler, and the families ordered.
#include "reasoning/dl/hypertableau/program/number_order.hpp"

#include <algorithm>

#include "base/sorted.hpp"
#include "reasoning/dl/hypertableau/program/exclusions.hpp"
#include "reasoning/dl/hypertableau/program/hierarchy.hpp"

namespace geminga::hypertableau {

using clauses::Clause;
using clauses::number;

NumberOrder::NumberOrder(const clauses::ClauseSet& set, std::span<const Clause> inclusions,
                         std::span<const Bound> bounds)
    : first_data_(static_cast<std::uint32_t>(set.properties.size()) * 2) {
  const auto direction = [](std::uint32_t property, bool is_inverse) { return property * 2 + (is_inverse ? 1U : 0U); };
  for (const clauses::AtLeast& one : set.at_leasts) {
    const Family family{direction(number(one.role.property), one.role.is_inverse), number(one.filler)};
    at_leasts_.push_back({one.count, family_of(family)});
  }
  for (const clauses::DataAtLeast& one : set.data_at_leasts) {
    data_at_leasts_.push_back({one.count, family_of({first_data_ + number(one.property), number(one.range)})});
  }
  for (const Bound& bound : bounds) {
    Restriction restriction{bound.count, no_predicate};
    const std::uint32_t filler = bound.filler == no_predicate ? number(clauses::thing) : bound.filler;
    if (bound.unless == no_predicate) {
      restriction.family = bound.is_data ? family_of({first_data_ + bound.property, 0})
                                         : family_of({direction(bound.property, bound.is_inverse), filler});
    }
    bounds_.push_back(restriction);
  }
  find_above(set, inclusions);
  find_comparable();
  find_sums(set, inclusions);
}

// The greatest at-least and the least bound of each family stand for all of them.
void NumberOrder::find_comparable() {
  constexpr std::uint32_t unbounded = no_predicate;
  bounds_in_.resize(index_.size());
  for (std::uint32_t at = 0; at < bounds_.size(); ++at) {
    if (bounds_[at].family != no_predicate) bounds_in_[bounds_[at].family].push_back(at);
  }
  for (std::vector<std::uint32_t>& family : bounds_in_) {
    std::ranges::stable_sort(family, {}, [this](std::uint32_t bound) { return bounds_[bound].count; });
  }
  std::vector<std::uint32_t> greatest(index_.size(), 0);       // at-least of the family
  std::vector<std::uint32_t> least(index_.size(), unbounded);  // bound of the family
  std::vector<std::vector<std::uint32_t>> below(index_.size());
  for (std::uint32_t family = 0; family < above_.size(); ++family) {
    for (const std::uint32_t high : above_[family]) below[high].push_back(family);
  }
  for (const auto* const list : {&at_leasts_, &data_at_leasts_}) {
    for (const Restriction& one : *list) greatest[one.family] = std::max(greatest[one.family], one.count);
  }
  for (const Restriction& one : bounds_) {
    if (one.family != no_predicate) least[one.family] = std::min(least[one.family], one.count);
  }
  for (auto* const list : {&at_leasts_, &data_at_leasts_}) {
    for (Restriction& one : *list) {
      one.may_be_implied = std::ranges::any_of(below[one.family], [&](std::uint32_t low) {
        return greatest[low] >= one.count + (low == one.family ? 1U : 0U);
      });
      one.may_be_excluded =
          std::ranges::any_of(above_[one.family], [&](std::uint32_t high) { return least[high] < one.count; });
    }
  }
  for (Restriction& one : bounds_) {
    if (one.family == no_predicate) continue;
    one.may_be_implied = std::ranges::any_of(above_[one.family], [&](std::uint32_t high) {
      return least[high] != unbounded && least[high] + (high == one.family ? 1U : 0U) <= one.count;
    });
    one.may_be_excluded =
        std::ranges::any_of(below[one.family], [&](std::uint32_t low) { return greatest[low] > one.count; });
  }
}

// The at-leasts below a bound that ask for more together than it allows, and not one of them alone. A bound of one
// neighbour needs none of this: its neighbour is given all fillers.
void NumberOrder::find_sums(const clauses::ClauseSet& set, std::span<const Clause> inclusions) {
  std::vector<std::uint32_t> greatest(index_.size(), 0);
  for (const auto* const list : {&at_leasts_, &data_at_leasts_}) {
    for (const Restriction& one : *list) greatest[one.family] = std::max(greatest[one.family], one.count);
  }
  std::vector<std::vector<std::uint32_t>> below(index_.size());
  for (std::uint32_t family = 0; family < above_.size(); ++family) {
    if (greatest[family] == 0) continue;
    for (const std::uint32_t high : above_[family]) below[high].push_back(family);
  }
  for (std::uint32_t high = 0; high < below.size(); ++high) {
    std::uint64_t sum = 0;
    for (const std::uint32_t family : below[high]) sum += greatest[family];
    bool is_any = false;
    for (const std::uint32_t bound : bounds_in_[high]) {
      bounds_[bound].may_be_added = below[high].size() > 1 && bounds_[bound].count > 1 && bounds_[bound].count < sum;
      is_any = is_any || bounds_[bound].may_be_added;
    }
    if (!is_any) continue;
    for (const std::uint32_t family : below[high]) neighbours_.try_emplace(family);
  }
  if (neighbours_.empty()) return;
  for (auto* const list : {&at_leasts_, &data_at_leasts_}) {
    for (Restriction& one : *list) one.may_be_added = neighbours_.contains(one.family);
  }
  Hierarchy of_concepts = hierarchy_of_concepts(set, inclusions);
  Hierarchy of_roles = hierarchy_of_roles(set);
  ConceptExclusions concepts(set, of_concepts);
  RoleExclusions roles(set, of_roles);
  for (const auto& [family, index] : index_) {
    const auto found = neighbours_.find(index);
    if (found == neighbours_.end()) continue;
    found->second.along = {of_roles.all_above(family.direction), roles.of(family.direction)};
    if (family.direction < first_data_)
      found->second.in = {of_concepts.all_above(family.filler), concepts.of(family.filler)};
  }
}

bool NumberOrder::are_disjoint(AtLeastId one, AtLeastId other) const {
  const Neighbours& first = neighbours_.at(of(one).family);
  const Neighbours& second = neighbours_.at(of(other).family);
  return first.in.excludes(second.in) || first.along.excludes(second.along);
}

bool NumberOrder::Reach::excludes(const Reach& other) const {
  return std::ranges::any_of(above, [&](std::uint32_t id) { return std::ranges::binary_search(other.excluded, id); });
}

bool NumberOrder::is_below(const Restriction& low, const Restriction& high) const {
  return low.family != no_predicate && high.family != no_predicate &&
         std::ranges::binary_search(above_[low.family], high.family);
}

std::uint32_t NumberOrder::family_of(const Family& family) {
  return index_.try_emplace(family, static_cast<std::uint32_t>(index_.size())).first->second;
}

void NumberOrder::find_above(const clauses::ClauseSet& set, std::span<const Clause> inclusions) {
  Hierarchy of_roles = hierarchy_of_roles(set);
  Hierarchy of_concepts = hierarchy_of_concepts(set, inclusions);
  above_.resize(index_.size());
  for (const auto& [family, index] : index_) {
    const bool is_data = family.direction >= first_data_;
    std::vector<std::uint32_t> fillers =
        is_data ? std::vector<std::uint32_t>{family.filler} : of_concepts.all_above(family.filler);
    if (fillers.front() != 0) fillers.push_back(0);  // owl:Thing, or every value
    for (const Direction direction : of_roles.all_above(family.direction)) {
      for (const std::uint32_t filler : fillers) {
        if (const auto found = index_.find({direction, filler}); found != index_.end()) {
          above_[index].push_back(found->second);
        }
      }
    }
    base::sort_unique(above_[index]);
  }
}

}  // namespace geminga::hypertableau
