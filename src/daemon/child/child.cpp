#include "daemon/child/child.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/steady_timer.hpp>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include "env/cage/cage.hpp"

namespace geminga::daemon {
namespace {

namespace net = boost::asio;

/// The exit status of a child that could not become the program, as in a shell.
constexpr int cannot_execute = 127;
/// The most reads of 4 KiB in one turn of the event loop: twice what a pipe holds.
constexpr int reads_per_turn = 32;

std::string reason() { return std::generic_category().message(errno); }

void limit(__rlimit_resource resource, std::size_t most) {
  const rlimit value{most, most};
  ::setrlimit(resource, &value);
}

/// Closes /proc/PID/mem of this process for its life to every process without CAP_SYS_PTRACE.
class Undumpable {
 public:
  Undumpable() : before_(::prctl(PR_GET_DUMPABLE)) { ::prctl(PR_SET_DUMPABLE, 0); }
  ~Undumpable() {
    if (before_ == 1) ::prctl(PR_SET_DUMPABLE, 1);
  }
  Undumpable(const Undumpable&) = delete;
  Undumpable& operator=(const Undumpable&) = delete;

 private:
  int before_;
};

/// Closes the cage before exec(). The program can only make it narrower.
void close_cage() {
  cage::Freedom freedom;
  freedom.may_become = true;
  freedom.may_read_all = true;  // the loader reads the program's libraries
  if (cage::close(freedom).by_system_calls) return;
  constexpr std::string_view words = "this system has no seccomp: what reads the ontologies is not confined\n";
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, words.data(), words.size());
}

/// Does all work between fork() and exec(). Does not return.
[[noreturn]] void become(pid_t parent, const char* program, char* const* arguments, int words, int output,
                         const ChildLimits& limits) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(cannot_execute);  // the parent died before the call above
  ::setpgid(0, 0);
  const int nothing = ::open("/dev/null", O_RDWR);
  if (nothing < 0) ::_exit(cannot_execute);
  ::dup2(nothing, STDIN_FILENO);
  ::dup2(output < 0 ? nothing : output, STDOUT_FILENO);
  ::dup2(words, STDERR_FILENO);
  ::close_range(3, ~0U, CLOSE_RANGE_UNSHARE);
  ::signal(SIGPIPE, SIG_DFL);
  sigset_t all;
  sigemptyset(&all);
  ::sigprocmask(SIG_SETMASK, &all, nullptr);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, limits.file_bytes);
  limit(RLIMIT_CPU, static_cast<std::size_t>(limits.time.count()));
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // their shadow memory is terabytes wide
  limit(RLIMIT_AS, limits.address_space);
#endif
  close_cage();
  ::execv(program, arguments);
  ::_exit(cannot_execute);
}

}  // namespace

class Child::Process : public std::enable_shared_from_this<Child::Process> {
 public:
  Process(net::io_context& context, const ChildLimits& limits, Done done)
      : limits_(limits), done_(std::move(done)), words_(context), process_(context), timer_(context) {}

  std::expected<void, std::string> start(const std::string& program, const std::vector<std::string>& arguments,
                                         int output) {
    std::vector<std::string> texts{program};
    texts.insert(texts.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& text : texts) pointers.push_back(text.data());
    pointers.push_back(nullptr);
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) return std::unexpected(reason());
    undumpable_.emplace();
    const pid_t parent = ::getpid();
    pid_ = ::fork();
    if (pid_ == 0) become(parent, program.c_str(), pointers.data(), ends[1], output, limits_);
    const int fork_error = errno;
    ::close(ends[1]);
    if (pid_ < 0) {
      ::close(ends[0]);
      return std::unexpected(std::generic_category().message(fork_error));
    }
    words_.assign(ends[0]);
    words_.native_non_blocking(true);
    // By its number, because glibc 2.36 declares pidfd_open() without C linkage.
    const int process = static_cast<int>(::syscall(SYS_pidfd_open, pid_, 0));
    if (process < 0) {
      const std::string text = reason();
      kill();
      return std::unexpected(text);
    }
    process_.assign(process);
    read_words();
    await_end();
    timer_.expires_after(limits_.time);
    timer_.async_wait([self = shared_from_this()](const boost::system::error_code& error) {
      if (error || self->pid_ <= 0) return;
      self->is_late_ = true;
      self->signal_all();
    });
    return {};
  }

  /// Ends the process at once. `done` is not called.
  void kill() {
    done_ = nullptr;
    timer_.cancel();
    boost::system::error_code ignored;
    words_.close(ignored);
    process_.close(ignored);
    if (pid_ <= 0) return;
    signal_all();
    while (::waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
    }
    pid_ = -1;
    undumpable_.reset();
  }

 private:
  void signal_all() const {
    ::kill(-pid_, SIGKILL);
    ::kill(pid_, SIGKILL);  // it may not have made its group yet
  }

  /// Waits for readability and then reads here: an asynchronous read could complete after finish().
  void read_words() {
    words_.async_wait(net::posix::stream_descriptor::wait_read,
                      [self = shared_from_this()](const boost::system::error_code& error) {
                        if (!error && self->take_words()) self->read_words();
                      });
  }

  /// Reads the output that is there, and drops what is over the bound. False at the end of the output.
  bool take_words() {
    std::array<char, 4096> chunk;
    for (int turn = 0; turn < reads_per_turn; ++turn) {
      const ssize_t size = ::read(words_.native_handle(), chunk.data(), chunk.size());
      if (size < 0 && errno == EINTR) continue;
      if (size <= 0) return size < 0;
      const std::size_t room = limits_.words_bytes - end_.words.size();
      end_.words.append(chunk.data(), std::min(static_cast<std::size_t>(size), room));
    }
    return true;
  }

  void await_end() {
    process_.async_wait(net::posix::stream_descriptor::wait_read,
                        [self = shared_from_this()](const boost::system::error_code& error) {
                          if (!error) self->finish();
                        });
  }

  void finish() {
    int status = 0;
    if (::waitpid(pid_, &status, WNOHANG) != pid_) return;
    pid_ = -1;
    undumpable_.reset();
    timer_.cancel();
    take_words();  // the last output before its end
    if (WIFEXITED(status) && !is_late_) end_.exit_status = WEXITSTATUS(status);
    end_.has_succeeded = end_.exit_status == 0;
    if (is_late_) {
      end_.how = "stopped after " + std::to_string(limits_.time.count()) + " s";
    } else if (WIFSIGNALED(status)) {
      end_.how = "killed by signal " + std::to_string(WTERMSIG(status));
    } else if (WEXITSTATUS(status) == cannot_execute) {
      end_.how = "could not be executed: install it beside gemingad or on PATH";
    } else {
      end_.how = "exit status " + std::to_string(WEXITSTATUS(status));
    }
    boost::system::error_code ignored;
    words_.close(ignored);
    process_.close(ignored);
    if (done_) std::exchange(done_, nullptr)(end_);
  }

  ChildLimits limits_;
  Done done_;
  net::posix::stream_descriptor words_;
  net::posix::stream_descriptor process_;
  net::steady_timer timer_;
  ChildEnd end_;
  std::optional<Undumpable> undumpable_;  ///< while the child lives
  pid_t pid_ = -1;
  bool is_late_ = false;
};

std::expected<std::unique_ptr<Child>, std::string> Child::start(net::io_context& context, const std::string& program,
                                                                const std::vector<std::string>& arguments,
                                                                const ChildLimits& limits, Done done, int output) {
  auto process = std::make_shared<Process>(context, limits, std::move(done));
  if (const auto started = process->start(program, arguments, output); !started)
    return std::unexpected(started.error());
  return std::unique_ptr<Child>(new Child(std::move(process)));
}

Child::Child(std::shared_ptr<Process> process) : process_(std::move(process)) {}
Child::~Child() { process_->kill(); }

}  // namespace geminga::daemon
