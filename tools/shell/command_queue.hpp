// Runs the user's command once for each event, one after the other.
#ifndef GEMINGA_SHELL_COMMAND_QUEUE_HPP
#define GEMINGA_SHELL_COMMAND_QUEUE_HPP

#include <boost/json/object.hpp>
#include <chrono>
#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "shell/running_command.hpp"

namespace geminga::shell {

/// The most events that wait for a command, and their octets. Beyond either has_room() is false, and the daemon keeps
/// its next events.
inline constexpr std::size_t max_waiting_commands = 4096;
inline constexpr std::size_t max_waiting_octets = std::size_t{16} * 1024 * 1024;
/// The most time of a command, unless the user gives another.
inline constexpr std::chrono::seconds usual_command_time{60};
/// The time between the signal that ends a command and the one that kills it.
inline constexpr std::chrono::seconds command_grace{2};

struct CommandOptions {
  std::string command;  ///< of /bin/sh -c
  /// The most time that it may run; nothing: no limit.
  std::optional<std::chrono::milliseconds> time = usual_command_time;
  std::string connect;  ///< the daemon's address as in --connect; empty: not given
};

/// Its owner calls process() when descriptor() is readable or time_left() is over. Failures of a command are reported
/// on standard error, and the next event goes on. Not thread-safe. Neither copies nor moves.
class CommandQueue {
 public:
  CommandQueue(std::string_view program, CommandOptions options);
  ~CommandQueue();
  CommandQueue(const CommandQueue&) = delete;
  CommandQueue& operator=(const CommandQueue&) = delete;

  /// Runs the command for this event, an object of to_json(), after the commands of earlier events.
  void add(const boost::json::object& event);
  [[nodiscard]] bool has_room() const;
  /// The octets of the waiting events.
  [[nodiscard]] std::size_t waiting_octets() const { return waiting_octets_; }
  /// Whether no command runs and none waits.
  [[nodiscard]] bool is_idle() const { return running_ == nullptr && waiting_.empty(); }

  /// Readable when the running command has ended; -1: none runs.
  [[nodiscard]] int descriptor() const { return running_ ? running_->descriptor() : -1; }
  /// The time until the running command has run too long; nothing: it has no limit, or none runs.
  [[nodiscard]] std::optional<std::chrono::milliseconds> time_left() const;
  void process();

  /// Sends the running command this signal, waits for its end, kills it after command_grace, and drops the waiting
  /// ones.
  void stop(int signal);

 private:
  using Clock = std::chrono::steady_clock;
  struct Run {
    std::string name;  ///< of the event, e.g. `add 5d0c1f32/2/7`
    std::vector<std::string> environment;
    std::string input;
    [[nodiscard]] std::size_t octets() const;
  };

  void start_next();
  void hurry();
  void finish();
  void say(const std::string& what) const;

  std::string_view program_;
  CommandOptions options_;
  std::deque<Run> waiting_;
  std::size_t waiting_octets_ = 0;
  std::unique_ptr<RunningCommand> running_;
  std::string running_name_;
  std::optional<Clock::time_point> deadline_;  ///< of the running command
  std::string told_to_end_;                    ///< why it was signalled; empty: it was not
};

}  // namespace geminga::shell

#endif
