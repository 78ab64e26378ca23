// Admission: whether the host has room for one more service of a peer, or for what the peer says that it will need.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_ADMISSION_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_ADMISSION_HPP

#include <cstddef>
#include <cstdint>

#include "discovery/participant/clients/limits.hpp"
#include "discovery/participant/clients/own_services.hpp"
#include "discovery/participant/clients/sessions.hpp"
#include "discovery/participant/knowledge/resolver.hpp"

namespace geminga::participant {

class Admission {
 public:
  /// Borrows all for its life.
  Admission(const ClientLimits& limits, Sessions& sessions, OwnServices& own)
      : limits_(limits), sessions_(sessions), own_(own) {}

  /// 409 where the number is that of another request of the peer.
  [[nodiscard]] static Refusal check_new(const Session& session, std::uint32_t id);
  /// 429 where the peer has the most publications, or subscriptions, that it may have.
  [[nodiscard]] Refusal check_publications(const Session& session) const;
  /// The same for a subscription; a quiet one takes a place of the room that the peer asked for.
  [[nodiscard]] Refusal check_subscriptions(const Session& session, bool is_quiet) const;
  /// 429 where the host has the most services that it may have, and no peer has more than its share. From a peer
  /// over its share a service is withdrawn. Call last, when no other check has failed.
  [[nodiscard]] Refusal make_room(const Session& session);
  /// Whether there is room without taking anything back; 429 where there is none.
  [[nodiscard]] Refusal check_room() const;
  /// Promises room that the peer will need, beside what all peers share.
  [[nodiscard]] Refusal promise_room(Session& session, std::size_t room) const;

 private:
  [[nodiscard]] Refusal check_count(std::size_t of_its_kind) const;
  [[nodiscard]] bool take_back_one(const Session& asking);

  const ClientLimits& limits_;
  Sessions& sessions_;
  OwnServices& own_;
};

}  // namespace geminga::participant

#endif
