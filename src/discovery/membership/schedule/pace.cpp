#include "discovery/membership/schedule/pace.hpp"

namespace geminga::membership {

using base::Duration;

bool Pace::set_doublings(std::uint8_t doublings) {
  if (doublings == doublings_) return false;
  doublings_ = doublings;
  announced_until_slower_ = said_interval() > kept_ ? announced_before_slower : 0;
  if (said_interval() >= kept_) return false;
  kept_ = said_interval();
  return true;
}

void Pace::count_announcement() {
  if (announced_until_slower_ == 0) return;
  --announced_until_slower_;
  if (announced_until_slower_ == 0) kept_ = said_interval();
}

Duration Pace::spread(Duration time, double share) {
  const auto reach = Duration(static_cast<Duration::rep>(static_cast<double>(time.count()) * share));
  return between(time - reach, time + reach);
}

}  // namespace geminga::membership
