#include "reasoning/dl/consequence/settled_contexts.hpp"

#include <algorithm>

#include "reasoning/dl/consequence/closure.hpp"

namespace geminga::consequence {

SettledContexts::SettledContexts(const Saturation& saturation, std::span<const std::string> gaps) {
  const auto is_about_facts = [](std::string_view gap) {
    return gap == fact_gap || gap == key_gap || gap == rule_gap || gap == apart_gap;
  };
  const auto is_local = [&](std::string_view gap) {
    return is_about_facts(gap) || gap == nominal_gap || gap == range_gap || gap == number_gap || gap == alternative_gap;
  };
  is_open_.assign(saturation.contexts().size(), !std::ranges::all_of(gaps, is_local));
  if (!std::ranges::all_of(gaps, is_about_facts) && std::ranges::all_of(gaps, is_local)) find_open(saturation);
}

void SettledContexts::find_open(const Saturation& saturation) {
  std::vector<std::vector<std::uint32_t>> predecessors(saturation.contexts().size());
  std::vector<std::uint32_t> open;
  saturation.contexts().for_each([&](const Context& context) {
    for (const Successor& successor : context.successors.all()) {
      if (successor.target != nullptr) predecessors[successor.target->number].push_back(context.number);
    }
    if ((context.has_open || context.store.is_cut()) && !context.is_unsatisfiable) open.push_back(context.number);
  });
  for (const std::uint32_t number : open) is_open_[number] = true;
  while (!open.empty()) {
    const std::uint32_t number = open.back();
    open.pop_back();
    for (const std::uint32_t before : predecessors[number]) {
      if (!is_open_[before]) open.push_back(before);
      is_open_[before] = true;
    }
  }
}

}  // namespace geminga::consequence
