// The order in which alternatives are tried.
#include "reasoning/dl/hypertableau/choice_records.hpp"

#include <algorithm>

namespace geminga::hypertableau {
namespace {

/// An estimate of the work that a choice causes: a bound causes none, new nodes cause much, and nodes that are made
/// equal seldom lead to a model.
std::uint64_t burden(const Choice& choice, const Burdens& burdens) {
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
      break;
  }
  return std::uint64_t{2} + Burdens::most;
}

}  // namespace

std::uint64_t ChoiceRecords::failures_of(std::span<const Choice> alternatives) {
  std::uint64_t failures = 0;
  for (Choice choice : alternatives) {
    for (const bool meets : {false, true}) {
      choice.meets_neighbour = meets;
      failures += record_of(choice).failures;
    }
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
