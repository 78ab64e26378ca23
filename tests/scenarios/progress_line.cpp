#include "scenarios/progress_line.hpp"

#include <unistd.h>

#include <iostream>

#include "scenarios/moment.hpp"

namespace geminga::scenarios {
namespace {

using RealClock = std::chrono::steady_clock;

constexpr auto spacing = std::chrono::seconds(1);
constexpr const char* empty_line = "\r\x1b[K";

}  // namespace

ProgressLine::ProgressLine(const Conditions& conditions)
    : conditions_(conditions), is_terminal_(::isatty(STDERR_FILENO) == 1), began_(RealClock::now()), shown_(began_) {}

OnProgress ProgressLine::on_terminal() {
  if (!is_terminal_) return {};
  return [this](base::Duration simulated, std::uint64_t datagrams) { show(simulated, datagrams); };
}

void ProgressLine::show(base::Duration simulated, std::uint64_t datagrams) {
  const auto now = RealClock::now();
  if (now - shown_ < spacing) return;
  shown_ = now;
  is_shown_ = true;
  std::cerr << empty_line << moment(simulated) << " of " << moment(conditions_.time) << " simulated, "
            << conditions_.participants << " participants, " << datagrams << " datagrams, "
            << std::chrono::duration_cast<std::chrono::seconds>(now - began_).count() << " s" << std::flush;
}

void ProgressLine::clear() {
  if (is_shown_) std::cerr << empty_line << std::flush;
  is_shown_ = false;
}

}  // namespace geminga::scenarios
