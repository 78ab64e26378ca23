// A line on a terminal that says how far a run has come.
#ifndef GEMINGA_TESTS_SCENARIOS_PROGRESS_LINE_HPP
#define GEMINGA_TESTS_SCENARIOS_PROGRESS_LINE_HPP

#include <chrono>
#include <cstdint>

#include "scenarios/conditions.hpp"
#include "scenarios/simulation.hpp"

namespace geminga::scenarios {

/// Written over itself on standard error, at most once in a second, and only where that is a terminal.
class ProgressLine {
 public:
  explicit ProgressLine(const Conditions& conditions);
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// The function that simulate() calls; empty where standard error is no terminal. It borrows this object.
  [[nodiscard]] OnProgress on_terminal();
  /// Takes the line off the terminal.
  void clear();

 private:
  void show(base::Duration simulated, std::uint64_t datagrams);

  const Conditions& conditions_;
  bool is_terminal_;
  bool is_shown_ = false;
  std::chrono::steady_clock::time_point began_;
  std::chrono::steady_clock::time_point shown_;
};

}  // namespace geminga::scenarios

#endif
