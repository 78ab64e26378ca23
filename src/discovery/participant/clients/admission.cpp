#include "discovery/participant/clients/admission.hpp"

#include <algorithm>
#include <string>

namespace geminga::participant {

Refusal Admission::check_new(const Session& session, std::uint32_t id) {
  if (!session.services.contains(id)) return std::nullopt;
  return Error{ErrorCode::already_exists,
               std::to_string(id) + " is in use already: choose another number, or modify it"};
}

Refusal Admission::check_count(std::size_t of_its_kind) const {
  if (of_its_kind < limits_.services_per_peer) return std::nullopt;
  return Error{ErrorCode::too_many,
               "too many: a peer may have " + std::to_string(limits_.services_per_peer) + " of each kind"};
}

Refusal Admission::check_publications(const Session& session) const {
  return check_count(session.services.publications.size());
}

Refusal Admission::check_subscriptions(const Session& session, bool is_quiet) const {
  if (!is_quiet) return check_count(session.services.subscriptions.size() - session.services.quiet);
  if (session.services.quiet < session.services.room) return std::nullopt;
  return Error{ErrorCode::too_many, "too many: this peer has asked for room for " +
                                        std::to_string(session.services.room) + " subscriptions of mode otm/stream"};
}

Refusal Admission::check_room() const {
  if (sessions_.shared_count() < limits_.services) return std::nullopt;
  return Error{ErrorCode::too_many, "too many: the peers of this host have all " + std::to_string(limits_.services) +
                                        " publications and subscriptions that can be announced, and a description is "
                                        "one more"};
}

Refusal Admission::make_room(const Session& session) {
  if (sessions_.shared_count() + own_.description().count() < limits_.services || take_back_one(session))
    return std::nullopt;
  return Error{ErrorCode::too_many, "too many: the peers of one host may have " + std::to_string(limits_.services) +
                                        " publications and subscriptions together"};
}

/// Takes one service back from the peer that has the most, if that peer then still has at least as many as the one that
/// asks will have. So a peer may use room that is free, and no peer is kept from its fair share. False where no peer
/// has so many more.
bool Admission::take_back_one(const Session& asking) {
  const auto most = std::ranges::max_element(sessions_.all, {}, [](const auto& entry) {
    // Services of a peer that leaves go first.
    return std::pair(entry.second->is_leaving && entry.second->services.shared_count() > 0,
                     entry.second->services.shared_count());
  });
  Session& greediest = *most->second;
  if (greediest.is_leaving && greediest.services.shared_count() > 0) {
    own_.withdraw_one(greediest);
    return true;
  }
  if (greediest.services.shared_count() < asking.services.shared_count() + 2) return false;
  const auto shared = std::find_if(greediest.services.subscriptions.rbegin(), greediest.services.subscriptions.rend(),
                                   [](const auto& entry) { return !entry.second.is_quiet; });
  const std::uint32_t number =
      std::max(greediest.services.publications.empty() ? 0 : greediest.services.publications.rbegin()->first,
               shared == greediest.services.subscriptions.rend() ? 0 : shared->first);
  own_.forget(greediest, number);
  sessions_.refuse(
      greediest, number,
      {ErrorCode::too_many, "taken back: the peers of one host may have " + std::to_string(limits_.services) +
                                " publications and subscriptions together, and another one has fewer"});
  return true;
}

Refusal Admission::promise_room(Session& session, std::size_t room) const {
  if (room > limits_.room_per_peer) {
    return Error{ErrorCode::too_large,
                 "room: " + std::to_string(room) + ", the limit is " + std::to_string(limits_.room_per_peer)};
  }
  if (room != session.services.room && !session.services.subscriptions.empty()) {
    return Error{ErrorCode::impossible, "room: say it before the first subscription"};
  }
  if (sessions_.promised_room() - session.services.room + room > limits_.room) {
    return Error{ErrorCode::too_many, "room: the peers of one host may ask for " + std::to_string(limits_.room) +
                                          " together, and other ones have the rest"};
  }
  session.services.room = room;
  return std::nullopt;
}

}  // namespace geminga::participant
