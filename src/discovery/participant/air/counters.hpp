// Counters of the datagrams of one participant, for `query status` and `query interfaces`.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_AIR_COUNTERS_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_AIR_COUNTERS_HPP

#include <array>
#include <cstdint>
#include <map>

#include "discovery/announcement/codec.hpp"
#include "discovery/membership/neighbour/hearing.hpp"
#include "env/env.hpp"

namespace geminga::participant {

/// Datagrams of one interface.
struct InterfaceCounters {
  std::uint64_t sent = 0;
  std::uint64_t received = 0;
};

struct AirCounters {
  std::uint64_t datagrams_sent = 0;
  std::uint64_t bytes_sent = 0;
  std::uint64_t datagrams_received = 0;
  std::uint64_t bytes_received = 0;
  std::uint64_t lost = 0;          ///< participants that were given up, without a goodbye
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
