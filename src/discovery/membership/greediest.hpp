// The choice of the participant that gives up a service when all room for services is taken.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_GREEDIEST_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_GREEDIEST_HPP

#include "discovery/membership/admission/admission.hpp"
#include "discovery/membership/records.hpp"

namespace geminga::membership {

/// The participant that gives up a service for `asks`: first one of another source that has more altogether, then one
/// of the same source that has more. A seasoned participant gives up nothing, unless `asks` is seasoned, too. Null:
/// nobody. Looks at every participant.
[[nodiscard]] NeighbourRecord* find_greediest(Records& records, const Admission& admission,
                                              const NeighbourRecord& asks);

}  // namespace geminga::membership

#endif
