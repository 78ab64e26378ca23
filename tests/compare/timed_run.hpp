// A program that is run to its end or for so many seconds of processor time, and what it took.
#ifndef GEMINGA_TESTS_COMPARE_TIMED_RUN_HPP
#define GEMINGA_TESTS_COMPARE_TIMED_RUN_HPP

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace geminga::compare {

/// The cost of a process.
struct Effort {
  double user_seconds = 0;           ///< of all its threads
  std::uint64_t peak_kilobytes = 0;  ///< the most memory that was resident at once
};

struct TimedRun {
  int status =
      -1;  ///< the exit status; 128 + N if signal N ended it; 124 if time was up, 127 if there is no such program
  Effort effort;
};

/// Runs a program of the PATH, with its output and errors in `output`. The kernel ends it after so many seconds of
/// processor time, so that the load of the machine does not matter, and coreutils' timeout if it hangs.
[[nodiscard]] TimedRun run_timed(const std::vector<std::string>& words, unsigned seconds,
                                 const std::filesystem::path& output);

}  // namespace geminga::compare

#endif
