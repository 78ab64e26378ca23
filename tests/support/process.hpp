// A program under test: started, listened to, signalled, and certainly ended.
#ifndef GEMINGA_TESTS_SUPPORT_PROCESS_HPP
#define GEMINGA_TESTS_SUPPORT_PROCESS_HPP

#include <sys/types.h>

#include <chrono>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace geminga::system {

/// The time that a test waits for something that must happen before it fails. Far longer than anything takes.
inline constexpr std::chrono::seconds patience{120};

/// One child process; its standard output and error are kept. The kernel kills it when the test dies.
class Process {
 public:
  struct Start {
    std::vector<std::string> words;                  ///< the program and its arguments
    std::map<std::string, std::string> environment;  ///< beside the test's own
    std::function<void()> before;                    ///< called in the child before exec, e.g. to enter a namespace
  };

  explicit Process(Start start);
  ~Process();  ///< kills it
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  [[nodiscard]] pid_t pid() const { return pid_; }
  void signal(int number) const;
  /// Waits until its output contains `text`. False: it ended without, or patience did.
  [[nodiscard]] bool wait_for(const std::string& text);
  /// The same for one of several texts.
  [[nodiscard]] bool wait_for_any(const std::vector<std::string>& texts);
  /// Waits in the same way for a whole line that contains `text`. Returns the text and what follows it in its line, the
  /// end of the line included; empty: it did not come.
  [[nodiscard]] std::string rest_of_line_with(const std::string& text);
  /// Forgets the output until now, then waits in the same way.
  void forget();
  /// Reads its output, so that it never has to wait for a reader.
  void listen();
  /// Waits for its end. Returns the exit status, 128 + N for signal N; nothing: patience ended first.
  [[nodiscard]] std::optional<int> wait();
  /// The output so far on both.
  [[nodiscard]] const std::string& said() const { return said_; }

 private:
  bool read_more(std::chrono::steady_clock::time_point until);

  pid_t pid_ = -1;
  int output_ = -1;
  std::string said_;
  std::size_t forgotten_ = 0;
  std::optional<int> status_;
};

/// The path of a program of this build.
[[nodiscard]] std::string program(const std::string& name);

/// Runs to the end; returns exit status and output. The status is -1 if it did not end.
struct Ran {
  int status = -1;
  std::string said;
};
[[nodiscard]] Ran run(Process::Start start);

}  // namespace geminga::system

#endif
