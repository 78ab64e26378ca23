// The order in which alternatives are tried.
#include "reasoning/dl/hypertableau/choice_records.hpp"

#include <algorithm>

namespace geminga::hypertableau {
namespace {

/// An estimate of the work that a choice causes: a bound causes none, new nodes cause much, and nodes that are made
/// equal seldom lead to a model.
std::uint64_t burden(const Choice& choice, const Burdens& burdens) {
  if (choice.crowds) return std::uint64_t{2} + Burdens::most;
  switch (choice.kind) {
    case ChoiceKind::at_most:
      return 0;
    case ChoiceKind::concept_of:
      return std::uint64_t{1} + (choice.meets_neighbour ? burdens.of_concept_beside(choice.predicate)
                                                        : burdens.of_concept(choice.predicate));
    case ChoiceKind::role:
    case ChoiceKind::data_role:
    case ChoiceKind::data_range:
      return 1;
    case ChoiceKind::at_least:
      return std::uint64_t{1} + (choice.meets_neighbour ? burdens.of_at_least_beside(choice.predicate)
                                                        : burdens.of_at_least(choice.predicate));
    case ChoiceKind::data_at_least:
      return 2;
    case ChoiceKind::equal:
    case ChoiceKind::introduce:
    case ChoiceKind::share_neighbours:
    case ChoiceKind::make_neighbours:
      break;
  }
  return std::uint64_t{2} + Burdens::most;
}

}  // namespace

bool ChoiceRecords::is_hopeless(const Choice& choice) const {
  constexpr std::uint64_t few = 4;
  const std::vector<Records>& records = records_[static_cast<std::size_t>(choice.kind)];
  if (choice.predicate >= records.size()) return false;
  const Record& record = records[choice.predicate].front();
  return record.failures >= few && record.failures * 2 > record.tries;
}

std::uint64_t ChoiceRecords::failures_of(std::span<const Choice> alternatives) {
  std::uint64_t failures = 0;
  for (const Choice& choice : alternatives) {
    for (const Record& record : records_of(choice)) failures += record.failures;
  }
  return failures;
}

// By the share of tries that failed, as Laplace estimates it, so that one failure among many successes does not change
// the choice for all nodes; then by the burden.
void ChoiceRecords::order_by_promise(std::vector<Choice>& alternatives, const Burdens& burdens) {
  std::ranges::stable_sort(alternatives, [&](const Choice& one, const Choice& other) {
    const Record first = record_of(one);
    const Record second = record_of(other);
    const std::uint64_t risk = (first.failures + 1) * (second.tries + 2);
    const std::uint64_t other_risk = (second.failures + 1) * (first.tries + 2);
    return risk != other_risk ? risk < other_risk : burden(one, burdens) < burden(other, burdens);
  });
}

}  // namespace geminga::hypertableau
