#include "discovery/sealing/sessions.hpp"

#include <algorithm>
#include <utility>

namespace geminga::sealing {

KnownSession* Sessions::find(Session session) {
  const auto found = sessions_.find(session);
  return found == sessions_.end() ? nullptr : &found->second;
}

const KnownSession* Sessions::find(Session session) const {
  const auto found = sessions_.find(session);
  return found == sessions_.end() ? nullptr : &found->second;
}

bool Sessions::add(Session session, KnownSession known) {
  const bool is_full = sessions_.size() == max_sessions;
  if (is_full) forget_silent_half();
  sessions_.emplace(session, std::move(known));
  return is_full;
}

/// Forgets half of them at once, because a new challenge must follow.
void Sessions::forget_silent_half() {
  std::vector<std::pair<base::Instant, Session>> by_silence;
  for (const auto& [session, known] : sessions_) by_silence.emplace_back(known.heard, session);
  const auto middle = by_silence.begin() + static_cast<std::ptrdiff_t>(by_silence.size() / 2);
  std::ranges::nth_element(by_silence, middle);
  for (auto one = by_silence.begin(); one != middle; ++one) sessions_.erase(one->second);
}

}  // namespace geminga::sealing
