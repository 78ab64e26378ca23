// How a peer lags behind with reading what it is told.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_LAG_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_LAG_HPP

#include <cstddef>
#include <optional>

#include "base/time.hpp"

namespace geminga::participant {

/// A peer that lags is not told of every change. It is told so (`msg lagged`) when it has caught up.
class Lag {
 public:
  [[nodiscard]] bool is_any() const { return since_.has_value(); }
  /// The peer has `backlog` octets to read, which are too many. Whether it did not lag before.
  bool begin(std::size_t backlog, base::Instant now) {
    if (since_) return false;
    since_ = now;
    backlog_ = backlog;
    return true;
  }
  /// The peer has `backlog` octets to read. Where these are fewer than the last time, patience begins anew.
  void note(std::size_t backlog, base::Instant now) {
    if (!since_ || backlog >= backlog_) return;
    backlog_ = backlog;
    since_ = now;
  }
  void end() { since_.reset(); }
  /// When a peer that goes on reading nothing has done so for too long; base::never: it does not lag.
  [[nodiscard]] base::Instant deadline(base::Duration patience) const {
    return since_ ? *since_ + patience : base::never;
  }

 private:
  std::optional<base::Instant> since_;  ///< since when it has read nothing
  std::size_t backlog_ = 0;             ///< octets that waited for it then
};

}  // namespace geminga::participant

#endif
