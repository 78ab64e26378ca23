#include "compare/timed_run.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>

namespace geminga::compare {

/// A program that takes this many times its processor time hangs, as Konclude sometimes does.
constexpr unsigned hanging_times = 3;

TimedRun run_timed(const std::vector<std::string>& words, unsigned seconds, const std::filesystem::path& output) {
  std::vector<std::string> all{"timeout", "--kill-after=2", std::to_string(seconds * hanging_times)};
  all.insert(all.end(), words.begin(), words.end());
  std::vector<char*> arguments;
  for (std::string& word : all) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const std::string path = output.string();
  const pid_t child = ::fork();
  if (child == 0) {
    const rlimit processor{seconds, seconds + 1};
    if (::setrlimit(RLIMIT_CPU, &processor) < 0) ::_exit(126);
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    if (file < 0 || ::dup2(file, STDOUT_FILENO) < 0 || ::dup2(file, STDERR_FILENO) < 0) ::_exit(126);
    ::execvp(arguments.front(), arguments.data());
    ::_exit(127);
  }
  TimedRun ran;
  int status = 0;
  // Usage is that of timeout and of what it has waited for.
  rusage usage{};
  while (child > 0 && ::wait4(child, &status, 0, &usage) < 0) {
    if (errno != EINTR) return ran;
  }
  if (child < 0) return ran;
  ran.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  if (ran.status == 128 + SIGXCPU) ran.status = 124;
  ran.effort.user_seconds =
      static_cast<double>(usage.ru_utime.tv_sec) + static_cast<double>(usage.ru_utime.tv_usec) / 1e6;
  ran.effort.peak_kilobytes = static_cast<std::uint64_t>(usage.ru_maxrss);
  return ran;
}

}  // namespace geminga::compare
