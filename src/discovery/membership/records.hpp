// All known participants, by identifier.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_RECORDS_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_RECORDS_HPP

#include <map>
#include <memory>
#include <optional>

#include "base/time.hpp"
#include "discovery/membership/neighbour_record.hpp"

namespace geminga::membership {

/// One known participant.
struct Known {
  std::unique_ptr<NeighbourRecord> record;
  base::Instant due = base::never;  ///< when something is to be done for it
};
using Records = std::map<ParticipantId, Known>;

/// The share of all participants' last datagrams that was lost, in [0, 1); nothing: too few were heard.
[[nodiscard]] std::optional<double> loss_of(const Records& records);

}  // namespace geminga::membership

#endif
