// One child process with bounds on its memory, time and output, in a cage (src/env/cage).
#ifndef GEMINGA_DAEMON_CHILD_CHILD_HPP
#define GEMINGA_DAEMON_CHILD_CHILD_HPP

#include <chrono>
#include <cstddef>
#include <expected>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace boost::asio {
class io_context;
}

namespace geminga::daemon {

/// The bounds of a child. A child that reaches one is killed and has failed.
struct ChildLimits {
  std::chrono::seconds time{120};          ///< by the clock, and of the processor
  std::size_t address_space = 4UL << 30U;  ///< octets; an ontology of 350k classes needs about half
  std::size_t file_bytes = 1UL << 30U;     ///< the longest file that it may write
  std::size_t words_bytes = 16UL * 1024;   ///< kept of its standard error; the rest is dropped
};

/// The end of a child.
struct ChildEnd {
  bool has_succeeded = false;
  std::optional<int> exit_status;  ///< where it ended by itself
  std::string how;                 ///< e.g. "exit status 2", "killed by signal 9", "stopped after 120 s"
  std::string words;               ///< its standard error, at most words_bytes
};

/// A running child. Destroying it kills the child.
class Child {
 public:
  using Done = std::function<void(const ChildEnd&)>;

  /// Starts `program` with these arguments (argv[0] not among them). Its standard input is empty; its standard output
  /// goes to the descriptor `output`, which is borrowed for the call, or is dropped. The child can start no process,
  /// open nothing for writing and reach no other process; it cannot read the memory of this one. `done` is called once,
  /// from the event loop, unless the Child is destroyed earlier. The error is the system's reason.
  [[nodiscard]] static std::expected<std::unique_ptr<Child>, std::string> start(
      boost::asio::io_context& context, const std::string& program, const std::vector<std::string>& arguments,
      const ChildLimits& limits, Done done, int output = -1);
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

 private:
  class Process;
  explicit Child(std::shared_ptr<Process> process);
  std::shared_ptr<Process> process_;  ///< shared with the handlers of its events
};

}  // namespace geminga::daemon

#endif
