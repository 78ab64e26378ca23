// One command of the user's that the shell runs, as a child of this program.
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

/// Lives at most as long as this object: the destructor kills what is left of it. Neither copies nor moves.
class RunningCommand {
 public:
  /// Starts `/bin/sh -c command` with exactly this environment, as the leader of a process group of its own, with no
  /// signal blocked or ignored. Its standard input is a file that holds `input`, so that nobody ever waits for it to
  /// read; it has this program's standard output and error, and no other descriptor. The error says what failed.
  [[nodiscard]] static std::expected<std::unique_ptr<RunningCommand>, std::string> start(
      const std::string& command, const std::vector<std::string>& environment, std::string_view input);

  ~RunningCommand();
  RunningCommand(const RunningCommand&) = delete;
  RunningCommand& operator=(const RunningCommand&) = delete;

  /// For poll(): readable when the command has ended. Owned by this.
  [[nodiscard]] int descriptor() const { return process_; }
  /// Waits so long for its end; whether it has ended.
  [[nodiscard]] bool has_ended(std::chrono::milliseconds patience = std::chrono::milliseconds(0)) const;
  /// To all processes of its group; one that is stopped goes on, so that it can end.
  void signal(int number);
  /// What waitpid(2) says of its end, for which it waits. What a signal() was sent to and outlived the command is
  /// killed. To be called once.
  [[nodiscard]] int reap();

 private:
  RunningCommand(pid_t pid, int process) : pid_(pid), process_(process) {}

  pid_t pid_;    ///< -1: reaped
  int process_;  ///< its pidfd
  bool was_signalled_ = false;
};

}  // namespace geminga::shell

#endif
