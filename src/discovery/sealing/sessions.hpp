// The sessions that are remembered, and what is known of each.
#ifndef GEMINGA_DISCOVERY_SEALING_SESSIONS_HPP
#define GEMINGA_DISCOVERY_SEALING_SESSIONS_HPP

#include <algorithm>
#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/time.hpp"
#include "discovery/sealing/envelope.hpp"
#include "discovery/sealing/limits.hpp"
#include "discovery/sealing/replay_window.hpp"

namespace geminga::sealing {

/// At most max_sessions sessions. `Known` has a member `heard`, the instant at which the session was last heard.
template <typename Known>
class Sessions {
 public:
  /// The session, or null.
  [[nodiscard]] Known* find(Session session) {
    const auto found = sessions_.find(session);
    return found == sessions_.end() ? nullptr : &found->second;
  }
  [[nodiscard]] const Known* find(Session session) const {
    const auto found = sessions_.find(session);
    return found == sessions_.end() ? nullptr : &found->second;
  }
  /// Adds an unknown session. Returns whether others had to be forgotten for it: the half that was silent for longest,
  /// all at once.
  bool add(Session session, Known known) {
    const bool is_full = sessions_.size() == max_sessions;
    if (is_full) forget_silent_half();
    sessions_.emplace(session, std::move(known));
    return is_full;
  }
  void clear() { sessions_.clear(); }
  [[nodiscard]] std::size_t size() const { return sessions_.size(); }

 private:
  void forget_silent_half() {
    std::vector<std::pair<base::Instant, Session>> by_silence;
    for (const auto& [session, known] : sessions_) by_silence.emplace_back(known.heard, session);
    const auto middle = by_silence.begin() + static_cast<std::ptrdiff_t>(by_silence.size() / 2);
    std::ranges::nth_element(by_silence, middle);
    for (auto one = by_silence.begin(); one != middle; ++one) sessions_.erase(one->second);
  }

  std::unordered_map<Session, Known> sessions_;  // its order reaches nothing
};

/// A session that has proved to be live. Only one that has a key and has proved itself is known: no forger and no
/// recording is. When others are forgotten for a new one, what proved those must prove nothing from then on, or their
/// recordings would be heard again: a new challenge must follow.
struct KnownSession {
  ReplayWindow window;
  base::Instant heard{};
  Protection protection{};  ///< of the last datagram
  KeyId key{};              ///< the key that it was sealed with
  std::vector<KeyId> keys;  ///< the keys that its sender opens with, as far as it has said
};
using ProvedSessions = Sessions<KnownSession>;

}  // namespace geminga::sealing

#endif
