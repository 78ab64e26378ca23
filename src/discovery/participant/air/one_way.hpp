// The neighbours that are heard and do not hear us, which the log names.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_AIR_ONE_WAY_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_AIR_ONE_WAY_HPP

#include <cstddef>
#include <set>
#include <string_view>

#include "discovery/announcement/announcement.hpp"
#include "discovery/membership/neighbour_table.hpp"
#include "env/env.hpp"
#include "geminga/service.hpp"

namespace geminga::participant {

/// The neighbours that the log names at most at the same time. `query participants` shows all of them.
inline constexpr std::size_t max_named_deaf = 8;

/// Writes one line when a neighbour has not heard us for long, and one when it does again.
class OneWay {
 public:
  /// To be called with each presence of a neighbour that was heard, and where it came from. Costs next to nothing while
  /// nothing changes.
  void hear(const announcement::Announcement& presence, const membership::NeighbourTable& table,
            std::string_view source, std::string_view interface, base::LogSink& log);

 private:
  std::set<ParticipantId> told_;
};

}  // namespace geminga::participant

#endif
