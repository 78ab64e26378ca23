#include "reasoning/realization/type_sets.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "base/sorted.hpp"
#include "reasoning/realization/realization.hpp"

namespace geminga::realization {

using taxonomy::ClassNumber;

std::uint32_t TypeSets::number_of(Classes classes) {
  for (ClassNumber& of : classes) of = classification_.representative[static_cast<std::size_t>(of)];
  base::sort_unique(classes);
  if (const auto found = numbers_.find(classes); found != numbers_.end()) return found->second;
  Classes all = closed(classes);
  const auto [place, is_new] = numbers_.try_emplace(all, static_cast<std::uint32_t>(sets_.size()));
  const std::uint32_t number = place->second;
  if (is_new) sets_.push_back(std::move(all));
  numbers_.try_emplace(std::move(classes), number);
  return number;
}

Classes TypeSets::closed(const Classes& classes) const {
  const ClassNumber top = classification_.representative[static_cast<std::size_t>(classification_.thing)];
  std::set<ClassNumber> seen;
  Classes open = classes;
  while (!open.empty()) {
    const ClassNumber of = open.back();
    open.pop_back();
    if (of == top || !seen.insert(of).second) continue;
    for (const ClassNumber parent : classification_.parents_of(of)) open.push_back(parent);
  }
  return {seen.begin(), seen.end()};
}

std::vector<ClassNumber> most_specific(const taxonomy::Classification& classification,
                                       const std::vector<ClassNumber>& types) {
  std::set<ClassNumber> above;
  for (const ClassNumber of : types) {
    const auto parents = classification.parents_of(of);
    above.insert(parents.begin(), parents.end());
  }
  std::vector<ClassNumber> lowest;
  std::ranges::copy_if(types, std::back_inserter(lowest), [&](ClassNumber of) { return !above.contains(of); });
  return lowest;
}

}  // namespace geminga::realization
