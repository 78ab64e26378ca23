// Counters of what clients say and are told, for `query status`.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_COUNTERS_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_COUNTERS_HPP

#include <array>
#include <cstddef>
#include <cstdint>

#include "geminga/match.hpp"

namespace geminga::participant {

struct ClientCounters {
  std::uint64_t statements = 0;  ///< lines from clients, good and bad
  std::uint64_t errors = 0;      ///< error lines to clients
  std::uint64_t events = 0;      ///< event lines to clients
  /// Services that requests were given, by degree.
  std::array<std::uint64_t, static_cast<std::size_t>(Degree::overlapping) + 1> matched{};
  std::uint64_t clients = 0;  ///< connections taken since the start
  std::uint64_t clients_refused = 0;
  std::uint64_t clients_closed = 0;  ///< by us: silent, stalled, flooding, or of another protocol
  std::uint64_t lags = 0;            ///< times that a client was too far behind to be told of every change
};

}  // namespace geminga::participant

#endif
