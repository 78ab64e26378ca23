// Reserve first, then the pool.
#include "discovery/membership/service_room.hpp"

#include "discovery/announcement/limits.hpp"

namespace geminga::membership {

bool ServiceRoom::take(const NeighbourServices& who, std::size_t count) {
  if (count < announcement::reserved_services) return true;
  if (pool_ >= announcement::max_remote_services && !make_room(who)) {
    ++refused_;
    return false;
  }
  ++pool_;
  return true;
}

void ServiceRoom::give(std::size_t count) {
  if (count > announcement::reserved_services) --pool_;
}

}  // namespace geminga::membership
