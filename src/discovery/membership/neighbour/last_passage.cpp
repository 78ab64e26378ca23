#include "discovery/membership/neighbour/last_passage.hpp"

#include <algorithm>
#include <utility>

#include "discovery/announcement/limits.hpp"

namespace geminga::membership {

using base::Duration;
using base::Instant;

void LastPassage::hear_through(const Passage& passage, Instant now) {
  const bool is_in_use = passage_ && now - used_ < announcement::hold_intervals * passage_->interval;
  if (is_in_use && passage.hops > passage_->hops) return;
  const bool is_same = passage_ && passage_->through.back() == passage.through.back() && passage_->hops == passage.hops;
  const auto former = std::exchange(passage_, passage);
  used_ = now;
  if (!is_same || passage.through.size() >= former->through.size()) return;
  // Testimony names the last relay alone. The others are those of the last word.
  passage_->through = former->through;
  passage_->delay = former->delay - former->interval + passage.interval;
}

Duration LastPassage::delay(Duration interval) const {
  if (!passage_) return Duration(0);
  const std::size_t unknown = passage_->hops - std::min(passage_->hops, passage_->through.size());
  return passage_->delay + static_cast<Duration::rep>(unknown) * std::max(interval, passage_->interval);
}

}  // namespace geminga::membership
