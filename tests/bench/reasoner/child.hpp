// A child process: a program that runs to its end, and its cost.
#ifndef GEMINGA_TESTS_BENCH_REASONER_CHILD_HPP
#define GEMINGA_TESTS_BENCH_REASONER_CHILD_HPP

#include <filesystem>
#include <string>
#include <vector>

namespace geminga::bench {

struct Cost {
  int status = -1;               ///< exit status; -1: it did not end by itself
  double milliseconds = 0;       ///< elapsed time from start to end
  double user_milliseconds = 0;  ///< processor time of all threads outside the kernel
  double peak_mebibytes = 0;
};

/// Runs a command, whose first word is found on the PATH, with standard output and error in files.
[[nodiscard]] Cost run(std::vector<std::string> words, const std::filesystem::path& out,
                       const std::filesystem::path& err);

/// The fastest of several runs; other work disturbed the others.
[[nodiscard]] Cost best_of(int runs, const std::vector<std::string>& words, const std::filesystem::path& out,
                           const std::filesystem::path& err);

[[nodiscard]] bool is_installed(const std::string& program);

[[nodiscard]] std::string content_of(const std::filesystem::path& path);

}  // namespace geminga::bench

#endif
