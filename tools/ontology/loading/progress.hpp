// Progress in one line of a terminal, which is overwritten and removed at the end.
#ifndef GEMINGA_ONTOLOGY_LOADING_PROGRESS_HPP
#define GEMINGA_ONTOLOGY_LOADING_PROGRESS_HPP

#include <unistd.h>

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

namespace geminga::ontology {

/// Writes to standard error where that is a terminal, and nothing to a log or a pipe. Uses no colours, and of control
/// characters only the carriage return. A thread of its own writes the line, so that it is seen while one call works
/// for long. The functions are for one thread.
class Progress {
 public:
  using Clock = std::chrono::steady_clock;
  /// The time before the line is seen at all. Most commands are done by then.
  static constexpr Clock::duration quiet_at_first = std::chrono::seconds(2);

  /// `is_wanted` false: never shown.
  explicit Progress(bool is_wanted = true, int terminal = STDERR_FILENO, Clock::duration quiet = quiet_at_first);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  /// Sets the phase and how much of it is done, in [0, 1]; 0: unknown.
  void show(std::string_view phase, double done = 0);
  /// Removes the line, so that other lines can be written. show() brings it back.
  void clear();

 private:
  void run();
  void write_line();
  void erase_line();

  const int terminal_;
  const Clock::time_point start_ = Clock::now();
  const Clock::duration quiet_;
  std::mutex mutex_;  ///< of all below but the thread
  std::condition_variable changed_;
  bool is_ended_ = false;
  std::string phase_;  ///< empty: no line
  double done_ = 0;
  std::size_t width_ = 0;  ///< of the line that is shown
  std::thread thread_;
};

}  // namespace geminga::ontology

#endif
