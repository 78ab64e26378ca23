#include "ontology/loading/progress.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <system_error>

namespace geminga::ontology {
namespace {

constexpr auto between_lines = std::chrono::milliseconds(200);
constexpr std::size_t max_width = 70;  // a line that wraps could not be removed again
constexpr std::size_t max_phase = 48;

}  // namespace

Progress::Progress(bool is_wanted, int terminal, Clock::duration quiet) : terminal_(terminal), quiet_(quiet) {
  if (!is_wanted || isatty(terminal) != 1) return;
  phase_.reserve(max_phase);
  try {
    thread_ = std::thread([this] { run(); });
  } catch (const std::system_error&) {  // where no thread can be had, there is no line
  }
}

Progress::~Progress() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    is_ended_ = true;
  }
  changed_.notify_one();
  thread_.join();
  erase_line();
}

void Progress::show(std::string_view phase, double done) {
  if (!thread_.joinable()) return;
  const std::lock_guard lock(mutex_);
  phase_ = phase.substr(0, max_phase);
  done_ = done;
}

void Progress::clear() {
  if (!thread_.joinable()) return;
  const std::lock_guard lock(mutex_);
  phase_.clear();
  erase_line();
}

/// Takes no memory: a thread that does gets an arena of its own, which a small --memory-limit has no room for.
void Progress::run() {
  std::unique_lock lock(mutex_);
  changed_.wait_until(lock, start_ + quiet_, [this] { return is_ended_; });
  while (!is_ended_) {
    write_line();
    changed_.wait_for(lock, between_lines, [this] { return is_ended_; });
  }
}

void Progress::write_line() {
  if (phase_.empty()) return;
  std::array<char, max_width + 2> line{};
  line.fill(' ');
  const auto seconds =
      static_cast<long long>(std::chrono::duration_cast<std::chrono::seconds>(Clock::now() - start_).count());
  const int percent = static_cast<int>(std::clamp(done_, 0.0, 1.0) * 100);
  const int written =
      percent > 0 ? std::snprintf(line.data(), line.size(), "\r%s %d%%, %lld s", phase_.c_str(), percent, seconds)
                  : std::snprintf(line.data(), line.size(), "\r%s, %lld s", phase_.c_str(), seconds);
  if (written <= 1) return;
  const std::size_t width = std::min(static_cast<std::size_t>(written), max_width) - 1;
  line[width + 1] = ' ';  // the end that snprintf() writes
  const std::size_t shown = std::max(width, width_);
  width_ = width;
  [[maybe_unused]] const auto done = write(terminal_, line.data(), shown + 1);
}

void Progress::erase_line() {
  if (width_ == 0) return;
  // Blanks overwrite the line on every terminal.
  std::array<char, max_width + 2> line{};
  line.fill(' ');
  line.front() = '\r';
  line[width_ + 1] = '\r';
  [[maybe_unused]] const auto done = write(terminal_, line.data(), width_ + 2);
  width_ = 0;
}

}  // namespace geminga::ontology
