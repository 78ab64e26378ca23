// A program run to its end, with what it cost.
#ifndef GEMINGA_TESTS_BENCH_REASONER_CHILD_HPP
#define GEMINGA_TESTS_BENCH_REASONER_CHILD_HPP

#include <filesystem>
#include <string>
#include <vector>

namespace geminga::bench {

struct Cost {
  int status = -1;               ///< exit status; -1: it did not end by itself
  double milliseconds = 0;       ///< from start to end, as a user waits for it
  double user_milliseconds = 0;  ///< of processors, of all threads, outside the kernel
  double peak_mebibytes = 0;
};

/// Runs the words, of which the first is found on the PATH, with standard output and error in files.
[[nodiscard]] Cost run(std::vector<std::string> words, const std::filesystem::path& out,
                       const std::filesystem::path& err);

/// The cheapest by time of several runs: the others were disturbed.
[[nodiscard]] Cost best_of(int runs, const std::vector<std::string>& words, const std::filesystem::path& out,
                           const std::filesystem::path& err);

[[nodiscard]] bool is_installed(const std::string& program);

[[nodiscard]] std::string content_of(const std::filesystem::path& path);

}  // namespace geminga::bench

#endif
