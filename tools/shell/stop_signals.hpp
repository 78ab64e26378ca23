// Waits for the daemon, a time and Ctrl-C together.
#ifndef GEMINGA_SHELL_STOP_SIGNALS_HPP
#define GEMINGA_SHELL_STOP_SIGNALS_HPP

#include <chrono>
#include <optional>

namespace geminga::shell {

/// While it lives SIGINT, SIGTERM and SIGHUP do not end the program but are waited for. One at a time, made before any
/// thread. Neither copies nor moves.
class StopSignals {
 public:
  enum class Woken { stopped, readable, timed_out };

  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  /// Waits until a signal has come (then every later call says so, too), `descriptor` or `other` (-1: none) is readable
  /// or the time is over; nothing: without end.
  [[nodiscard]] Woken wait(int descriptor, std::optional<std::chrono::milliseconds> timeout, int other = -1) const;
  /// The signal that has come; 0: none.
  [[nodiscard]] static int pending();

 private:
  void take_pending() const;

  int signals_ = -1;
};

}  // namespace geminga::shell

#endif
