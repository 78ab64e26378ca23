#include "bridge/loop/loop.hpp"

#include <poll.h>

#include <chrono>

#include "client/cpp/stated_endpoints.hpp"
#include "shell/exit_status.hpp"
#include "shell/report.hpp"

namespace geminga::bridge {
namespace {

/// The time that the daemon has to read the goodbye.
constexpr std::chrono::milliseconds goodbye{500};

}  // namespace

Loop::Loop(std::string_view program, const shell::CommonOptions& options)
    : reactor_([program](const std::string& reason) { shell::complain(program, reason); }) {
  auto endpoints = client::stated_endpoints(options.connect);
  if (!endpoints) {
    shell::complain(program, endpoints.error().text);
    return;
  }
  team_.emplace(reactor_, std::move(*endpoints), std::string(program), options.timeout_or(std::chrono::seconds(5)),
                [program](const std::string& line) { shell::complain(program, line); });
}

int Loop::run() {
  using Woken = shell::StopSignals::Woken;
  team_->start();
  while (signals_.wait(reactor_.descriptor(), std::nullopt) != Woken::stopped) reactor_.process();
  team_->leave();
  bool is_late = false;
  client::Reactor::Timer alarm(reactor_, [&is_late] { is_late = true; });
  alarm.set(reactor_.now() + goodbye);
  pollfd ready{reactor_.descriptor(), POLLIN, 0};
  while (team_->is_up() && !is_late) {
    if (::poll(&ready, 1, -1) > 0) reactor_.process();
  }
  return static_cast<int>(shell::ExitStatus::found);
}

}  // namespace geminga::bridge
