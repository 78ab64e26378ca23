#include "discovery/membership/neighbour/service_room.hpp"

#include "discovery/announcement/limits.hpp"

namespace geminga::membership {

bool ServiceRoom::take(ParticipantId asks, std::size_t count) {
  if (count < announcement::reserved_services) return true;
  if (pool_ >= announcement::max_remote_services) {
    is_exhausted_ = is_exhausted_ || !make_room(asks);
    if (is_exhausted_) {
      ++refused_;
      return false;
    }
  }
  ++pool_;
  return true;
}

void ServiceRoom::give(std::size_t count) {
  if (count > announcement::reserved_services) --pool_;
}

bool ServiceRoom::remember_withdrawn() {
  if (withdrawn_ == announcement::max_withdrawn_services) return false;
  ++withdrawn_;
  return true;
}

}  // namespace geminga::membership
