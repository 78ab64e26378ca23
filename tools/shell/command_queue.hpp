// Runs the user's command once an event, one after the other.
#ifndef GEMINGA_SHELL_COMMAND_QUEUE_HPP
#define GEMINGA_SHELL_COMMAND_QUEUE_HPP

#include <boost/json/object.hpp>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "shell/running_command.hpp"

namespace geminga::shell {

/// Events that wait for the command before them. Beyond either limit has_room() is false, and the daemon's next events
/// stay with it.
inline constexpr std::size_t max_waiting_commands = 4096;
inline constexpr std::size_t max_waiting_octets = std::size_t{16} * 1024 * 1024;
/// How long a command may run unless told.
inline constexpr std::chrono::seconds usual_command_time{60};
/// How long a command that is to end has before it is killed.
inline constexpr std::chrono::seconds command_grace{2};

struct CommandOptions {
  std::string command;  ///< for /bin/sh -c
  /// How long it may run; nothing: without end.
  std::optional<std::chrono::milliseconds> time = usual_command_time;
  std::string connect;  ///< where the daemon is, as --connect told it; empty: it did not
};

/// Not thread-safe. Neither copies nor moves. Whoever has one calls process() when descriptor() is readable or
/// time_left() is over. What goes wrong with a command is told on standard error, and the next event goes on.
class CommandQueue {
 public:
  CommandQueue(std::string_view program, CommandOptions options);
  ~CommandQueue();
  CommandQueue(const CommandQueue&) = delete;
  CommandQueue& operator=(const CommandQueue&) = delete;

  /// Runs the command for this event, as to_json() gives it, once those before it have ended.
  void add(const boost::json::object& event);
  [[nodiscard]] bool has_room() const;
  /// Of the events that wait.
  [[nodiscard]] std::size_t waiting_octets() const { return waiting_octets_; }
  /// No command runs and none waits.
  [[nodiscard]] bool is_idle() const { return running_ == nullptr && waiting_.empty(); }

  /// Readable when the running command has ended; -1 where none runs.
  [[nodiscard]] int descriptor() const { return running_ ? running_->descriptor() : -1; }
  /// Until the running command has run too long; nothing where none can.
  [[nodiscard]] std::optional<std::chrono::milliseconds> time_left() const;
  void process();

  /// Sends the running command this signal, waits for its end, kills it after command_grace, and runs none of those
  /// that wait.
  void stop(int signal);

 private:
  using Clock = std::chrono::steady_clock;
  struct Run {
    std::string name;  ///< what it is for, e.g. `add 5d0c1f32/2/7`
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
  std::string told_to_end_;                    ///< why it was; empty: it was not
};

}  // namespace geminga::shell

#endif
