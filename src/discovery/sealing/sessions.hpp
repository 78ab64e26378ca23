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
  KeyId key{};              ///< that it was sealed with
  std::vector<KeyId> keys;  ///< that its sender opens with, as far as it has said
};

/// Only who has a key and has proved its session gets a place, so that a forger has none and a recording neither.
class Sessions {
 public:
  /// Null: not known.
  [[nodiscard]] KnownSession* find(Session session);
  [[nodiscard]] const KnownSession* find(Session session) const;
  /// Adds one that is not known. Gives whether others had to be forgotten for it: whatever proved them must prove
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
