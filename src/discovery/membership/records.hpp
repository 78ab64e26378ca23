// All known participants, by identifier.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_RECORDS_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_RECORDS_HPP

#include <map>
#include <memory>

#include "base/time.hpp"
#include "discovery/membership/neighbour_record.hpp"

namespace geminga::membership {

/// One known participant.
struct Known {
  std::unique_ptr<NeighbourRecord> record;
  base::Instant due = base::never;  ///< when something is to be done for it
};
using Records = std::map<ParticipantId, Known>;

}  // namespace geminga::membership

#endif
