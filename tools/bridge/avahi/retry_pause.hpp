// The pause before something that Avahi refused, or that nobody answered, is tried again.
#ifndef GEMINGA_BRIDGE_AVAHI_RETRY_PAUSE_HPP
#define GEMINGA_BRIDGE_AVAHI_RETRY_PAUSE_HPP

#include <algorithm>

#include "bridge/avahi/limits.hpp"

namespace geminga::bridge {

/// Doubles with each failure, up to max_pause. Counted in calls of a function that is called once a second.
class RetryPause {
 public:
  void fail() {
    ++failures_;
    left_ = std::min(1U << std::min(failures_, 6U), max_pause);
  }
  /// One call has passed. Whether the pause has ended with it.
  bool pass() {
    if (is_over()) return false;
    --left_;
    return is_over();
  }
  [[nodiscard]] bool is_over() const { return left_ == 0; }
  [[nodiscard]] unsigned failures() const { return failures_; }

 private:
  unsigned failures_ = 0;
  unsigned left_ = 0;
};

}  // namespace geminga::bridge

#endif
