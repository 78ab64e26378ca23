// The sessions that have proved to be live, and what is known of each.
#ifndef GEMINGA_DISCOVERY_SEALING_SESSIONS_HPP
#define GEMINGA_DISCOVERY_SEALING_SESSIONS_HPP

#include <cstddef>
#include <unordered_map>
#include <vector>

#include "base/time.hpp"
#include "discovery/sealing/envelope.hpp"
#include "discovery/sealing/replay_window.hpp"

namespace geminga::sealing {

struct KnownSession {
  ReplayWindow window;
  base::Instant heard{};
  Protection protection{};  ///< of the last datagram
  KeyId key{};              ///< the key that it was sealed with
  std::vector<KeyId> keys;  ///< the keys that its sender opens with, as far as it has said
};

/// Only a session that has a key and has proved itself gets an entry: no forger and no recording does.
class Sessions {
 public:
  /// The session, or null.
  [[nodiscard]] KnownSession* find(Session session);
  [[nodiscard]] const KnownSession* find(Session session) const;
  /// Adds an unknown session. Returns whether others had to be forgotten for it. If so, what proved those must prove
  /// nothing from then on, or their recordings would be heard again.
  [[nodiscard]] bool add(Session session, KnownSession known);
  void clear() { sessions_.clear(); }
  [[nodiscard]] std::size_t size() const { return sessions_.size(); }

 private:
  void forget_silent_half();

  std::unordered_map<Session, KnownSession> sessions_;  // its order reaches nothing
};

}  // namespace geminga::sealing

#endif
