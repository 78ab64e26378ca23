#include "discovery/membership/schedule/copies.hpp"

#include <algorithm>
#include <span>
#include <utility>

namespace geminga::membership {

using base::Duration;
using base::Instant;
using base::never;

std::size_t state_copies(std::optional<double> loss) {
  if (!loss) return 4;
  if (*loss < 0.005) return 1;
  if (*loss < 0.02) return 2;
  if (*loss < 0.15) return 3;
  return *loss < bad_loss ? 5 : 7;
}

Instant Copies::gather(Instant now) {
  if (std::exchange(is_change_pending_, true)) return *change_due_;
  if (!change_due_ || now - *change_due_ >= change_wait_) {
    change_due_ = now;
    change_wait_ = change_spacing;
  } else if (now >= *change_due_) {
    *change_due_ += change_wait_;
    change_wait_ = std::min(2 * change_wait_, longest_change_spacing);
  }
  return *change_due_;
}

void Copies::plan(Say what, Instant first, std::optional<double> loss, Pace& pace) {
  const auto said = state_copies(loss);
  const auto all = said + (loss ? std::min(said, presence_copies) : unknown_presence_copies);
  copies_ = {{first, what}};
  for (std::size_t i = 1; i < all; ++i) {
    copies_.push_back({first + pace.spread(repeat_delays[i - 1], repeat_jitter), i < said ? what : Say::presence});
  }
  const auto show = [&](Duration delay) {
    copies_.push_back({first + pace.spread(delay, repeat_jitter), Say::presence});
  };
  if (loss.value_or(0) >= bad_loss) std::ranges::for_each(bad_presence_delays, show);
  std::ranges::for_each(std::span(late_presence_delays).first(pace.doublings()), show);
  std::ranges::sort(copies_, {}, &Copy::due);
}

void Copies::add_presence(Instant due) {
  copies_.push_back({due, Say::presence});
  std::ranges::sort(copies_, {}, &Copy::due);
}

Instant Copies::next(Say what) const {
  const auto copy = std::ranges::find(copies_, what, &Copy::what);
  return copy == copies_.end() ? never : copy->due;
}

std::size_t Copies::states() const {
  return static_cast<std::size_t>(std::ranges::count(copies_, Say::state, &Copy::what));
}

void Copies::drop_told(Instant now) {
  if (change_due_ && *change_due_ <= now) is_change_pending_ = false;
  std::erase_if(copies_, [now](const Copy& copy) { return copy.what != Say::presence && copy.due <= now; });
}

void Copies::drop_presences(Instant now) {
  std::erase_if(copies_, [now](const Copy& copy) { return copy.what == Say::presence && copy.due <= now; });
}

void Copies::clear() {
  is_change_pending_ = false;
  copies_.clear();
}

}  // namespace geminga::membership
