#include "support/process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <stdexcept>

namespace geminga::system {
namespace {

using Clock = std::chrono::steady_clock;

int milliseconds_until(Clock::time_point until) {
  const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now()).count();
  return static_cast<int>(std::max<std::int64_t>(left, 0));
}

}  // namespace

Process::Process(Start start) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  std::vector<char*> words;
  for (std::string& word : start.words) words.push_back(word.data());
  words.push_back(nullptr);
  pid_ = ::fork();
  if (pid_ == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    ::dup2(::open("/dev/null", O_RDONLY), STDIN_FILENO);
    ::dup2(ends[1], STDOUT_FILENO);
    ::dup2(ends[1], STDERR_FILENO);
    for (const auto& [name, value] : start.environment) ::setenv(name.c_str(), value.c_str(), 1);
    if (start.before) start.before();
    ::execv(words[0], words.data());
    ::_exit(127);
  }
  ::close(ends[1]);
  output_ = ends[0];
  if (pid_ < 0) throw std::runtime_error("no process");
}

Process::~Process() {
  if (!status_) {
    ::kill(pid_, SIGKILL);
    while (::waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  ::close(output_);
}

void Process::signal(int number) const {
  if (!status_) ::kill(pid_, number);
}

bool Process::read_more(Clock::time_point until) {
  pollfd wait{output_, POLLIN, 0};
  if (::poll(&wait, 1, milliseconds_until(until)) <= 0) return false;
  std::array<char, 4096> chunk;
  const ssize_t size = ::read(output_, chunk.data(), chunk.size());
  if (size <= 0) return false;
  said_.append(chunk.data(), static_cast<std::size_t>(size));
  return true;
}

bool Process::wait_for(const std::string& text) { return wait_for_any({text}); }

bool Process::wait_for_any(const std::vector<std::string>& texts) {
  const auto until = Clock::now() + patience;
  const auto is_said = [this](const std::string& text) { return said_.find(text, forgotten_) != std::string::npos; };
  while (std::ranges::none_of(texts, is_said)) {
    if (!read_more(until)) return false;
  }
  return true;
}

std::string Process::rest_of_line_with(const std::string& text) {
  if (!wait_for(text)) return "";
  const std::size_t begin = said_.find(text, forgotten_);
  const auto until = Clock::now() + patience;
  while (said_.find('\n', begin) == std::string::npos) {
    if (!read_more(until)) return "";
  }
  return said_.substr(begin, said_.find('\n', begin) + 1 - begin);
}

void Process::forget() { forgotten_ = said_.size(); }

void Process::listen() {
  while (read_more(Clock::now())) {
  }
}

std::optional<int> Process::wait() {
  if (status_) return status_;
  const auto until = Clock::now() + patience;
  while (read_more(until)) {
  }
  if (Clock::now() >= until) return std::nullopt;
  int status = 0;
  if (::waitpid(pid_, &status, 0) != pid_) return std::nullopt;
  status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return status_;
}

std::string program(const std::string& name) { return std::string(GEMINGA_BINARY_DIR) + "/bin/" + name; }

Ran run(Process::Start start) {
  Process process(std::move(start));
  const auto status = process.wait();
  return {status.value_or(-1), process.said()};
}

}  // namespace geminga::system
