// Introductions of neighbours to hosts that do not hear them: ANNOUNCEMENT.md, "Introductions".
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_AIR_INTRODUCTIONS_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_AIR_INTRODUCTIONS_HPP

#include <cstdint>

#include "base/time.hpp"
#include "discovery/announcement/announcement.hpp"
#include "discovery/membership/neighbour_table.hpp"
#include "discovery/participant/air/presence.hpp"
#include "discovery/sealing/seal.hpp"
#include "env/env.hpp"

namespace geminga::participant {

/// Presences introduce for so many intervals. The pause behind them is as long at first, and doubles up to the longest
/// while the roster stays as it is.
inline constexpr int introducing_intervals = 8;
inline constexpr int longest_introducing_pause = 256;

class Introductions {
 public:
  /// Borrows all for its life.
  Introductions(const membership::NeighbourTable& table, const sealing::Seal& seal, const TeamSettings& settings)
      : table_(table), seal_(seal), settings_(settings) {}

  /// Adds neighbours to a presence that goes out on this interface: those that are heard there, in turn, while somebody
  /// who hears us there knows others than we do. Only where announcements are sealed, since a receiver sends to the
  /// addresses that it is told. Leaves other announcements as they are. Looks at every participant.
  void add_to(announcement::Announcement& presence, env::InterfaceIndex interface, base::Instant now);

 private:
  [[nodiscard]] bool is_due(base::Instant now);

  const membership::NeighbourTable& table_;
  const sealing::Seal& seal_;
  const TeamSettings& settings_;
  base::Instant begin_ = base::never;  ///< of the series under way, or of the next one; never: nobody needs any
  base::Instant end_{};
  int pause_ = introducing_intervals;  ///< behind the series, in intervals
  std::uint64_t roster_ = 0;           ///< the participants for which the pauses were counted
  ParticipantId last_{};               ///< the one that was introduced last
};

}  // namespace geminga::participant

#endif
