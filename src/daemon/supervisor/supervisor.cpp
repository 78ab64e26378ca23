#include "daemon/supervisor/supervisor.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <string>

#include "daemon/supervisor/notice_socket.hpp"

namespace geminga::daemon {
namespace {

/// The first descriptor that a supervisor gives (SD_LISTEN_FDS_START).
constexpr int first_given_socket = 3;

/// The value of a variable; empty where it is not set.
std::string_view value_of(const char* const* environment, std::string_view name) {
  for (const char* const* entry = environment; *entry != nullptr; ++entry) {
    const std::string_view assignment(*entry);
    if (assignment.starts_with(name) && assignment.substr(name.size(), 1) == "=")
      return assignment.substr(name.size() + 1);
  }
  return {};
}

/// A decimal number without a sign, or nothing.
std::optional<long> number_in(std::string_view text) {
  long number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || number < 0) return std::nullopt;
  return number;
}

}  // namespace

Supervisor::Supervisor(const char* const* environment)
    : socket_(connect_for_notices(value_of(environment, "NOTIFY_SOCKET"))) {
  // A variable that names another process was meant for that one, and was inherited.
  const std::string_view watched = value_of(environment, "WATCHDOG_PID");
  const auto microseconds = number_in(value_of(environment, "WATCHDOG_USEC"));
  if (microseconds && *microseconds > 0 && (watched.empty() || number_in(watched) == ::getpid()))
    watchdog_ = std::chrono::microseconds(*microseconds);
  if (number_in(value_of(environment, "LISTEN_PID")) != ::getpid()) return;
  const auto given = number_in(value_of(environment, "LISTEN_FDS")).value_or(0);
  const int count = static_cast<int>(std::min<long>(given, max_given_sockets));
  for (int descriptor = first_given_socket; descriptor < first_given_socket + count; ++descriptor) {
    if (::fcntl(descriptor, F_SETFD, FD_CLOEXEC) == 0) sockets_.push_back(descriptor);
  }
}

Supervisor::~Supervisor() {
  if (socket_ >= 0) ::close(socket_);
}

void Supervisor::say_ready(std::string_view status) const {
  if (socket_ >= 0) send_notice(socket_, "READY=1\nSTATUS=" + std::string(status) + '\n');
}

void Supervisor::say_reloading(base::Instant now) const {
  const auto time = std::chrono::duration_cast<std::chrono::microseconds>(now.time_since_epoch());
  if (socket_ >= 0) send_notice(socket_, "RELOADING=1\nMONOTONIC_USEC=" + std::to_string(time.count()) + '\n');
}

void Supervisor::say_stopping() const {
  if (socket_ >= 0) send_notice(socket_, "STOPPING=1\nSTATUS=saying goodbye\n");
}

void Supervisor::say_alive() const {
  if (socket_ >= 0) send_notice(socket_, "WATCHDOG=1\n");
}

}  // namespace geminga::daemon
