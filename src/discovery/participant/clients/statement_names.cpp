#include "discovery/participant/clients/statement_names.hpp"

#include <type_traits>
#include <utility>

#include "discovery/announcement/announceable.hpp"
#include "discovery/matching/conditions/scope.hpp"
#include "discovery/matching/conversions/converter.hpp"

namespace geminga::participant {

Refusal StatementNames::resolve(StatedPublication& stated) { return resolve_and_check(stated); }
Refusal StatementNames::resolve(StatedSubscription& stated) { return resolve_and_check(stated); }
Refusal StatementNames::resolve_again(StatedPublication& stated) { return resolve_by_another(stated); }
Refusal StatementNames::resolve_again(StatedSubscription& stated) { return resolve_by_another(stated); }

template <typename Stated>
Refusal StatementNames::resolve_and_check(Stated& stated) {
  constexpr bool is_offer = std::is_same_v<Stated, StatedPublication>;
  auto identity = resolver_.resolve(stated.named);
  stated.is_awaited = resolver_.is_awaited(identity);
  if (!identity && !stated.is_awaited) return identity.error();
  if (identity) stated.service.identity = std::move(*identity);
  if constexpr (!is_offer) {
    if (!stated.service.on.empty()) {
      auto on = resolver_.resolve_on(stated.service.on);
      if (!on && !resolver_.is_awaited(on.error())) return on.error();
      stated.is_awaited |= !on;
      if (on) stated.service.on = std::move(*on);
    }
  }
  if (auto refusal = announcement::check(stated.service)) return refusal;
  if (auto refusal = matching::check_scope(stated.service.scope)) return refusal;
  if constexpr (is_offer) {
    if (auto refusal = matching::check_conversion(stated.service.attributes, editions_.vocabulary())) return refusal;
  }
  auto refusal = resolver_.check_conditions(stated.service);
  stated.is_awaited |= is_awaited(refusal);
  stated.is_in_force = !stated.is_awaited;
  return is_awaited(refusal) ? std::nullopt : refusal;
}

template <typename Stated>
Refusal StatementNames::resolve_by_another(Stated& stated) {
  auto identity = resolver_.resolve(stated.named);
  Refusal refusal;
  if (identity) {
    stated.service.identity = std::move(*identity);
    if constexpr (std::is_same_v<Stated, StatedSubscription>) {
      const auto on = stated.service.on.empty() ? "" : resolver_.resolve_on(stated.service.on);
      if (on) stated.service.on = *on;
      if (!on) refusal = on.error();
    }
    if (!refusal) refusal = announcement::check(stated.service);  // full IRIs may be longer than what can be announced
    if (!refusal) refusal = resolver_.check_conditions(stated.service);
  } else {
    refusal = identity.error();
  }
  stated.is_in_force = !refusal;
  stated.is_awaited = is_awaited(refusal);
  return refusal;
}

}  // namespace geminga::participant
