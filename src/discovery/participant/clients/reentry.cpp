#include "discovery/participant/clients/reentry.hpp"

#include <algorithm>

namespace geminga::participant {

void Reentry::list_returning() {
  returning_.clear();
  own_.enter_description();
  for (const auto& [stream, session] : sessions_.all) {
    session->services.for_each(
        [&, at = stream](std::uint32_t number, const auto&) { returning_.push_back({at, number}); });
  }
  std::ranges::reverse(returning_);
}

Reentry::Found Reentry::take(List& list) {
  const auto [stream, number] = list.back();
  list.pop_back();
  Session* session = sessions_.find(stream);
  if (session != nullptr) work_.add(cost_of_statement);
  return {session, number};
}

bool Reentry::return_next() {
  if (returning_.empty()) return false;
  const auto [session, number] = take(returning_);
  if (session == nullptr) return true;
  telling_.tell_gone(*session, number, matching::Reason::renamed);
  session->services.with(number, [&](const auto& stated) {
    own_.enter(*session, number, stated, matching::Matcher::Telling::providers);
    if (stated.is_in_force) session->resyncs[number] = {};
  });
  return true;
}

void Reentry::list_for_restating(bool is_of_all) {
  restated_.clear();
  own_.restate_description(is_of_all);
  for (const auto& [stream, session] : sessions_.all) {
    session->services.for_each([&, at = stream](std::uint32_t number, const auto& stated) {
      if (is_of_all || stated.is_awaited) restated_.push_back({at, number});
    });
  }
  std::ranges::reverse(restated_);
}

bool Reentry::restate_next() {
  if (restated_.empty()) return false;
  const auto [session, number] = take(restated_);
  if (session == nullptr) return true;
  session->services.with(number, [&](auto& stated) {
    const bool is_known = resolve_again(*session, number, stated);
    if (!self_.is_claimed()) return;
    if (is_known) {
      own_.enter(*session, number, stated);
    } else {
      own_.withdraw(*session, number, stated, matching::Reason::changed);
    }
  });
  return true;
}

/// Sets the identity that the ontology gives to the names. False where it does not know them, or is not prepared for
/// them yet; then the peer was told.
template <typename Stated>
bool Reentry::resolve_again(Session& session, std::uint32_t number, Stated& stated) {
  const bool must_tell = stated.is_in_force || stated.is_awaited;
  const Refusal refusal = names_.resolve_again(stated);
  if (!refusal) return true;
  if (!must_tell) return false;
  telling_.tell_gone(session, number, matching::Reason::changed);
  if (!stated.is_awaited) {
    sessions_.refuse(session, number, *refusal);
    work_.add(cost_of_unknown_name);
  }
  return false;
}

}  // namespace geminga::participant
