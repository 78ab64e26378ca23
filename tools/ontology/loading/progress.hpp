// Progress in one line of a terminal, which is overwritten and removed at the end.
#ifndef GEMINGA_ONTOLOGY_LOADING_PROGRESS_HPP
#define GEMINGA_ONTOLOGY_LOADING_PROGRESS_HPP

#include <chrono>
#include <cstddef>
#include <string_view>

namespace geminga::ontology {

/// Writes to standard error where that is a terminal, and nothing to a log or a pipe. Uses no colours, and of control
/// characters only the carriage return.
class Progress {
 public:
  /// `is_wanted` false: never shown.
  explicit Progress(bool is_wanted = true);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress() { clear(); }

  /// Shows the phase and how much of it is done, in [0, 1]; 0: unknown. At most ten lines are shown in a second, and
  /// none in the first half second unless the work `is_long` for sure.
  void show(std::string_view phase, double done = 0, bool is_long = false);
  /// Removes the line, so that other lines can be written.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;

  bool is_shown_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_{};
  std::size_t width_ = 0;  ///< of the line that is shown
};

}  // namespace geminga::ontology

#endif
