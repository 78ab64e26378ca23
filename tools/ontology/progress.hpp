// What is being done, in one line of a terminal that is written over and gone at the end.
#ifndef GEMINGA_ONTOLOGY_PROGRESS_HPP
#define GEMINGA_ONTOLOGY_PROGRESS_HPP

#include <chrono>
#include <cstddef>
#include <string_view>

namespace geminga::ontology {

/// Writes to standard error, and only where that is a terminal: a log or a pipe never sees any of it. No colours and no
/// control sequences but carriage returns.
class Progress {
 public:
  /// `is_wanted` false: never shown.
  explicit Progress(bool is_wanted = true);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress() { clear(); }

  /// `done` in [0, 1]; 0 where it is not known. Shown at most ten times a second, and not before work has taken half a
  /// second, unless it `is_long` for sure.
  void show(std::string_view phase, double done = 0, bool is_long = false);
  /// Takes the line away, so that other lines can be written.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;

  bool is_shown_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_{};
  std::size_t width_ = 0;  ///< of what stands in the line now
};

}  // namespace geminga::ontology

#endif
