#include "ontology/loading/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace geminga::ontology {
namespace {

constexpr auto quiet_at_first = std::chrono::milliseconds(500);
constexpr auto between_lines = std::chrono::milliseconds(100);
constexpr std::size_t max_width = 70;  // a line that wraps could not be removed again

}  // namespace

Progress::Progress(bool is_wanted) : is_shown_(is_wanted && isatty(STDERR_FILENO) == 1) {}

void Progress::show(std::string_view phase, double done, bool is_long) {
  if (!is_shown_) return;
  const Clock::time_point now = Clock::now();
  if (!is_long && (now - start_ < quiet_at_first || now - last_ < between_lines)) return;
  last_ = now;
  std::string line(phase.substr(0, max_width - 6));
  if (done > 0) line += ' ' + std::to_string(static_cast<int>(std::min(done, 1.0) * 100)) + '%';
  const std::size_t width = line.size();
  if (width < width_) line.append(width_ - width, ' ');
  width_ = width;
  line.insert(0, 1, '\r');
  std::fwrite(line.data(), 1, line.size(), stderr);
  std::fflush(stderr);
}

void Progress::clear() {
  if (width_ == 0) return;
  // Blanks overwrite the line on every terminal.
  const std::string blanks = '\r' + std::string(width_, ' ') + '\r';
  std::fwrite(blanks.data(), 1, blanks.size(), stderr);
  std::fflush(stderr);
  width_ = 0;
}

}  // namespace geminga::ontology
