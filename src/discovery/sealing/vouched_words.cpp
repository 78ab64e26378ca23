#include "discovery/sealing/vouched_words.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace geminga::sealing {
namespace {

/// A word counts once, on whatever interface it comes.
constexpr env::InterfaceIndex any{};

}  // namespace

bool VouchedWords::take(Session session, std::uint32_t counter, base::Instant now) {
  const auto known = sessions_.find(session);
  if (known == sessions_.end()) {
    if (sessions_.size() == max_sessions) forget_silent_half();
    sessions_.emplace(session, Known{ReplayWindow(any, counter, now, false), now});
    return true;
  }
  auto& window = known->second.window;
  if (!window.is_open(any, counter, now)) return false;
  window.take(any, counter, now, false);
  known->second.heard = now;
  return true;
}

void VouchedWords::forget_silent_half() {
  std::vector<std::pair<base::Instant, Session>> by_silence;
  for (const auto& [session, known] : sessions_) by_silence.emplace_back(known.heard, session);
  const auto middle = by_silence.begin() + static_cast<std::ptrdiff_t>(by_silence.size() / 2);
  std::ranges::nth_element(by_silence, middle);
  for (auto one = by_silence.begin(); one != middle; ++one) sessions_.erase(one->second);
}

}  // namespace geminga::sealing
