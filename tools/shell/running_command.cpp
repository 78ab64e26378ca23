#include "shell/running_command.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <system_error>

#include "base/private_file.hpp"

namespace geminga::shell {
namespace {

constexpr const char* shell_path = "/bin/sh";

std::string reason(int error) { return std::generic_category().message(error); }

/// The actions of posix_spawn() in the child before it becomes the shell.
class Preparation {
 public:
  explicit Preparation(int input) {
    posix_spawnattr_init(&attributes_);
    posix_spawn_file_actions_init(&actions_);
    sigset_t signals;
    sigemptyset(&signals);
    posix_spawnattr_setsigmask(&attributes_, &signals);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGCHLD}) sigaddset(&signals, signal);
    posix_spawnattr_setsigdefault(&attributes_, &signals);
    posix_spawnattr_setpgroup(&attributes_, 0);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    posix_spawn_file_actions_adddup2(&actions_, input, STDIN_FILENO);
    posix_spawn_file_actions_addclosefrom_np(&actions_, STDERR_FILENO + 1);
  }
  ~Preparation() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }
  Preparation(const Preparation&) = delete;
  Preparation& operator=(const Preparation&) = delete;

  [[nodiscard]] const posix_spawnattr_t* attributes() const { return &attributes_; }
  [[nodiscard]] const posix_spawn_file_actions_t* actions() const { return &actions_; }

 private:
  posix_spawnattr_t attributes_{};
  posix_spawn_file_actions_t actions_{};
};

/// A file with this content, at its beginning.
std::expected<base::PrivateFile, std::string> file_of(std::string_view text) {
  auto file = base::PrivateFile::in_memory();
  if (!file) return file;
  while (!text.empty()) {
    const ssize_t put = ::write(file->descriptor(), text.data(), text.size());
    if (put < 0 && errno != EINTR) return std::unexpected(reason(errno));
    text.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(put, 0)));
  }
  if (::lseek(file->descriptor(), 0, SEEK_SET) != 0) return std::unexpected(reason(errno));
  return file;
}

/// Pointers to the texts. posix_spawn() asks for writable ones and writes to none.
char* borrowed(const std::string& text) { return const_cast<char*>(text.c_str()); }

}  // namespace

std::expected<std::unique_ptr<RunningCommand>, std::string> RunningCommand::start(
    const std::string& command, const std::vector<std::string>& environment, std::string_view input) {
  const auto file = file_of(input);
  if (!file) return std::unexpected(file.error());
  const Preparation preparation(file->descriptor());
  const std::string name = "sh";
  const std::string flag = "-c";
  const std::vector<char*> words{borrowed(name), borrowed(flag), borrowed(command), nullptr};
  std::vector<char*> variables;
  for (const std::string& variable : environment) variables.push_back(borrowed(variable));
  variables.push_back(nullptr);
  pid_t pid = -1;
  const int error =
      ::posix_spawn(&pid, shell_path, preparation.actions(), preparation.attributes(), words.data(), variables.data());
  if (error != 0) return std::unexpected(std::string(shell_path) + ": " + reason(error));
  // By its number, because glibc 2.36 declares pidfd_open() without C linkage.
  const int process = static_cast<int>(::syscall(SYS_pidfd_open, pid, 0));
  std::unique_ptr<RunningCommand> running(new RunningCommand(pid, process));
  if (process < 0) return std::unexpected("cannot be waited for: " + reason(errno));
  return running;
}

RunningCommand::~RunningCommand() {
  if (pid_ > 0) {
    signal(SIGKILL);
    static_cast<void>(reap());
  }
  if (process_ >= 0) ::close(process_);
}

bool RunningCommand::has_ended(std::chrono::milliseconds patience) const {
  const auto until = std::chrono::steady_clock::now() + patience;
  while (true) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - std::chrono::steady_clock::now()).count();
    pollfd watched{process_, POLLIN, 0};
    const int ready = ::poll(&watched, 1, static_cast<int>(std::clamp<long>(left, 0, 1'000'000)));
    if (ready > 0) return true;
    if (left <= 0 && (ready == 0 || errno != EINTR)) return false;
  }
}

void RunningCommand::signal(int number) {
  was_signalled_ = true;
  ::kill(-pid_, number);
  ::kill(-pid_, SIGCONT);
}

int RunningCommand::reap() {
  if (was_signalled_) {
    // No other process or group gets its number before it is reaped.
    siginfo_t end{};
    while (::waitid(P_PID, static_cast<id_t>(pid_), &end, WEXITED | WNOWAIT) != 0 && errno == EINTR) {
    }
    ::kill(-pid_, SIGKILL);
  }
  int status = 0;
  while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  pid_ = -1;
  return status;
}

}  // namespace geminga::shell
