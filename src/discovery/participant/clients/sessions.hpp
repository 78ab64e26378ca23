// The sessions of all clients that are connected, and what they have together.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_SESSIONS_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_SESSIONS_HPP

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "discovery/participant/clients/counters.hpp"
#include "discovery/participant/clients/session.hpp"
#include "env/env.hpp"
#include "geminga/error.hpp"
#include "geminga/service.hpp"

namespace geminga::participant {

/// Owns the sessions, by stream and so in the order of arrival. One whose connection is over stays, `is_leaving`, until
/// its services are withdrawn. Only Clients adds and removes sessions.
class Sessions {
 public:
  using Map = std::map<env::StreamId, std::unique_ptr<Session>>;

  Map all;
  ClientCounters counters;

  /// Null where the client is gone, or its connection over.
  [[nodiscard]] Session* find(env::StreamId stream);
  [[nodiscard]] Session* find(PeerId peer);
  /// Those whose connection is not over, in ascending order of peer.
  [[nodiscard]] std::vector<const Session*> peers() const;
  /// Their number.
  [[nodiscard]] std::size_t peer_count() const;
  /// Publications and subscriptions of all sessions.
  [[nodiscard]] std::size_t publication_count() const;
  [[nodiscard]] std::size_t subscription_count() const;
  [[nodiscard]] std::size_t service_count() const { return publication_count() + subscription_count(); }
  /// Those of them that are announced.
  [[nodiscard]] std::size_t shared_count() const;
  /// Room for quiet subscriptions that is promised.
  [[nodiscard]] std::size_t promised_room() const;

  /// Writes an error to a client, and counts it.
  void refuse(Session& session, std::uint32_t id, const Error& error);
};

}  // namespace geminga::participant

#endif
