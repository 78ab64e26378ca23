#include "discovery/relaying/speakers.hpp"

#include <algorithm>

namespace geminga::relaying {

void Speakers::hear(const Place& place, const Distance& other, base::Duration interval, base::Instant now) {
  using Count = base::Duration::rep;
  const base::Duration time(static_cast<Count>(static_cast<double>(interval.count()) * stands_back_intervals));
  const auto known = others_.find(place);
  if (known != others_.end()) {
    if (known->second.until > now && known->second.distance < other) return;
    known->second = {other, now + time};
  } else {
    if (others_.size() == max_speakers) others_.clear();
    others_.emplace(place, Other{other, now + time});
  }
  due_ = std::min(due_, now + time);
}

bool Speakers::has_better(const Place& place, const Distance& own, base::Instant now) const {
  const auto known = others_.find(place);
  return known != others_.end() && known->second.until > now && known->second.distance < own;
}

bool Speakers::take_silent(base::Instant now) {
  if (due_ > now) return false;
  due_ = base::never;
  const std::size_t silent = std::erase_if(others_, [&](const auto& one) { return one.second.until <= now; });
  for (const auto& [place, other] : others_) due_ = std::min(due_, other.until);
  return silent > 0;
}

}  // namespace geminga::relaying
