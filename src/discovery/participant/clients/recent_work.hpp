// The work that was done for a client lately.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_RECENT_WORK_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_RECENT_WORK_HPP

#include "base/time.hpp"
#include "discovery/participant/knowledge/work.hpp"

namespace geminga::participant {

/// Each half-life counts half of what there was.
class RecentWork {
 public:
  [[nodiscard]] Work at(base::Instant now) const {
    const auto halvings = (now - counted_at_) / half_life;
    return halvings >= 64 ? 0 : work_ >> halvings;
  }
  void add(Work work, base::Instant now) {
    const auto halvings = (now - counted_at_) / half_life;
    work_ = at(now) + work;
    counted_at_ += halvings * half_life;  // what is left of a half-life is not lost
  }

 private:
  Work work_ = 0;
  base::Instant counted_at_{};
};

}  // namespace geminga::participant

#endif
