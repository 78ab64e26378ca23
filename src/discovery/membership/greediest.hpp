// Who gives up a service when all room for services is taken.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_GREEDIEST_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_GREEDIEST_HPP

#include "discovery/membership/admission.hpp"
#include "discovery/membership/records.hpp"

namespace geminga::membership {

/// Whoever has more than the one who asks: first of another source that has more altogether, then of the same one.
/// Takes nothing from those who are known for long, unless the one who asks is, too. Null: nobody. Looks at every
/// participant.
[[nodiscard]] NeighbourRecord* find_greediest(Records& records, const Admission& admission,
                                              const NeighbourRecord& asks);

}  // namespace geminga::membership

#endif
