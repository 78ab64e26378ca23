// Candidates are added until the question holds, and then removed while it does.
#include "reasoning/explanation/explain_minimal.hpp"

#include <algorithm>

namespace geminga::explanation {
namespace {

/// The axioms of `candidates` that are needed beside `given`. `has_grown`: `given` has changed since holds(given) was
/// last found to be false.
AxiomSet find_needed(AxiomSet given, bool has_grown, const AxiomSet& candidates, const Holds& holds) {
  if (has_grown && holds(given)) return {};
  if (candidates.size() == 1) return candidates;
  const auto half = candidates.begin() + static_cast<std::ptrdiff_t>(candidates.size() / 2);
  const AxiomSet first(candidates.begin(), half);
  const AxiomSet second(half, candidates.end());
  AxiomSet with_first = given;
  with_first.insert(with_first.end(), first.begin(), first.end());
  AxiomSet needed = find_needed(std::move(with_first), !first.empty(), second, holds);
  given.insert(given.end(), needed.begin(), needed.end());
  const AxiomSet more = find_needed(std::move(given), !needed.empty(), first, holds);
  needed.insert(needed.end(), more.begin(), more.end());
  return needed;
}

}  // namespace

AxiomSet find_minimal(const AxiomSet& candidates, const Holds& holds) {
  if (candidates.empty() || holds({})) return {};
  AxiomSet minimal = find_needed({}, false, candidates, holds);
  std::ranges::sort(minimal);
  return minimal;
}

std::optional<AxiomSet> find_sufficient_prefix(const AxiomSet& candidates, const Holds& holds) {
  constexpr std::size_t first_size = 8;
  for (std::size_t size = first_size;; size *= 2) {
    const std::size_t taken = std::min(size, candidates.size());
    AxiomSet prefix(candidates.begin(), candidates.begin() + static_cast<std::ptrdiff_t>(taken));
    if (holds(prefix)) return prefix;
    if (taken == candidates.size()) return std::nullopt;
  }
}

}  // namespace geminga::explanation
