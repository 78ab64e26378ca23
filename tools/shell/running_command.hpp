// One command of the user, run by a shell as a child of this program.
#ifndef GEMINGA_SHELL_RUNNING_COMMAND_HPP
#define GEMINGA_SHELL_RUNNING_COMMAND_HPP

#include <sys/types.h>

#include <chrono>
#include <expected>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace geminga::shell {

/// The destructor kills the rest of the command. Neither copies nor moves.
class RunningCommand {
 public:
  /// Starts `/bin/sh -c command` with exactly this environment, as the leader of a process group of its own, with no
  /// signal blocked or ignored. Its standard input is a file with `input`, so that this program never waits for it to
  /// read. It has this program's standard output and error, and no other descriptor. The error says what failed.
  [[nodiscard]] static std::expected<std::unique_ptr<RunningCommand>, std::string> start(
      const std::string& command, const std::vector<std::string>& environment, std::string_view input);

  ~RunningCommand();
  RunningCommand(const RunningCommand&) = delete;
  RunningCommand& operator=(const RunningCommand&) = delete;

  /// A descriptor for poll(), readable when the command has ended. Owned by this object.
  [[nodiscard]] int descriptor() const { return process_; }
  /// Waits at most so long for the end. Returns whether the command has ended.
  [[nodiscard]] bool has_ended(std::chrono::milliseconds patience = std::chrono::milliseconds(0)) const;
  /// Sends a signal to all processes of its group, and continues stopped ones, so that they can end.
  void signal(int number);
  /// Waits for the end and returns the status of waitpid(2). After a signal(), kills the processes of the group that
  /// outlive the command. To be called once.
  [[nodiscard]] int reap();

 private:
  RunningCommand(pid_t pid, int process) : pid_(pid), process_(process) {}

  pid_t pid_;    ///< -1: reaped
  int process_;  ///< its pidfd
  bool was_signalled_ = false;
};

}  // namespace geminga::shell

#endif
