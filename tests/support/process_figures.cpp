#include "support/process_figures.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace geminga::system {
namespace {

std::string folder_of(pid_t pid) { return "/proc/" + std::to_string(pid) + '/'; }

/// The number behind `key` in a file of /proc/PID; -1 if there is none.
double number_of(pid_t pid, const std::string& file, const std::string& key) {
  std::ifstream lines(folder_of(pid) + file);
  std::string line;
  while (std::getline(lines, line)) {
    if (line.starts_with(key)) return std::stod(line.substr(key.size()));
  }
  return -1;
}

/// /proc counts in kibibytes.
double megabytes(double kibibytes) { return kibibytes * 1024 / 1e6; }

}  // namespace

double processor_ms(pid_t pid) { return number_of(pid, "schedstat", "") / 1e6; }

double resident_mb(pid_t pid) { return megabytes(number_of(pid, "status", "VmRSS:")); }

double anonymous_mb(pid_t pid) { return megabytes(number_of(pid, "status", "RssAnon:")); }

std::size_t descriptors(pid_t pid) {
  const std::filesystem::directory_iterator all(folder_of(pid) + "fd");
  return static_cast<std::size_t>(std::distance(begin(all), end(all)));
}

}  // namespace geminga::system
