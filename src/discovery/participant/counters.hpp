// What `query status` counts.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_COUNTERS_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_COUNTERS_HPP

#include <array>
#include <cstdint>
#include <map>

#include "discovery/announcement/codec.hpp"
#include "discovery/membership/neighbour_table.hpp"
#include "env/env.hpp"

namespace geminga::participant {

/// Datagrams of one interface.
struct InterfaceCounters {
  std::uint64_t sent = 0;
  std::uint64_t received = 0;
};

struct Counters {
  std::uint64_t statements = 0;  ///< lines from clients, good and bad
  std::uint64_t errors = 0;      ///< error lines to clients
  std::uint64_t events = 0;      ///< event lines to clients
  std::uint64_t clients = 0;     ///< connections taken since the start
  std::uint64_t clients_refused = 0;
  std::uint64_t clients_closed = 0;  ///< by us: silent, stalled, flooding, or of another protocol
  std::uint64_t lags = 0;            ///< times that a client was too far behind to be told of every change
  std::uint64_t datagrams_sent = 0;
  std::uint64_t bytes_sent = 0;
  std::uint64_t datagrams_received = 0;
  std::uint64_t bytes_received = 0;
  std::uint64_t clashes = 0;       ///< times that the identifier was given up
  std::uint64_t redraws = 0;       ///< identifiers drawn because another one was somebody else's, too
  std::uint64_t contested = 0;     ///< datagrams of others under our identifier, which we kept
  std::uint64_t contradicted = 0;  ///< datagrams with our boot nonce that we have not sent
  std::array<std::uint64_t, announcement::decode_error_count> undecodable{};  ///< by DecodeError
  std::array<std::uint64_t, membership::hearing_count> hearings{};            ///< by Hearing
  std::map<env::InterfaceIndex, InterfaceCounters> interfaces;
};

}  // namespace geminga::participant

#endif
