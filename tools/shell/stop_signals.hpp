// Waits for a descriptor, a time and Ctrl-C together.
#ifndef GEMINGA_SHELL_STOP_SIGNALS_HPP
#define GEMINGA_SHELL_STOP_SIGNALS_HPP

#include <chrono>
#include <optional>

namespace geminga::shell {

/// For its life SIGINT, SIGTERM and SIGHUP do not end the program; wait() returns instead. Only one may exist, made
/// before any thread. Neither copies nor moves.
class StopSignals {
 public:
  enum class Woken { stopped, readable, timed_out };

  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  /// Waits for a signal, for `descriptor` or `other` (-1: none) to be readable, or for the end of the time (nothing: no
  /// end). After a signal every call returns `stopped`.
  [[nodiscard]] Woken wait(int descriptor, std::optional<std::chrono::milliseconds> timeout, int other = -1) const;
  /// The pending signal; 0: none.
  [[nodiscard]] static int pending();

 private:
  void take_pending() const;

  int signals_ = -1;
};

}  // namespace geminga::shell

#endif
