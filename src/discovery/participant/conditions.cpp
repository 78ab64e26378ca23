#include "discovery/participant/conditions.hpp"

#include <string_view>
#include <utility>

#include "discovery/matching/preferences.hpp"
#include "discovery/matching/where.hpp"
#include "discovery/participant/identities.hpp"

namespace geminga::participant {
namespace {

/// What is wrong, unless an ontology that is to come may mend it.
Refusal unless_awaited(const Core& core, Refusal refusal) {
  if (!refusal || core.vocabulary().is_loaded()) return refusal;
  Error missing = no_ontology(core);
  return missing.code == ErrorCode::not_ready ? Refusal(std::move(missing)) : refusal;
}

Refusal check_condition(const Core& core, std::string_view condition, std::string_view key) {
  auto refusal = matching::check_where(condition, key, core.vocabulary().units());
  const bool is_of_unit = refusal && !matching::unit_problem(condition, core.vocabulary().units()).empty();
  return is_of_unit ? unless_awaited(core, std::move(refusal)) : refusal;
}

}  // namespace

Refusal check_conditions(const Core& core, const Publication& publication) {
  return check_condition(core, publication.for_whom, "for");
}

Refusal check_conditions(const Core& core, const Subscription& subscription) {
  if (auto refusal = check_condition(core, subscription.where, "where")) return refusal;
  auto refusal = matching::check_preferences(subscription, core.vocabulary().units());
  return subscription.prefer.empty() ? refusal : unless_awaited(core, std::move(refusal));
}

}  // namespace geminga::participant
