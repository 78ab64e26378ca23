#include "daemon/child.hpp"

#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/steady_timer.hpp>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <system_error>

namespace geminga::daemon {
namespace {

namespace net = boost::asio;

/// The status of a child that could not become the program; as the shell has it.
constexpr int cannot_execute = 127;

std::string reason() { return std::generic_category().message(errno); }

/// Makes socket(2) fail with EACCES for this process and all that it becomes. A few instructions of classic BPF, so
/// that the daemon needs no library for it; on another architecture the call is left alone.
void forbid_sockets() {
#if defined(__x86_64__)
  constexpr std::uint32_t architecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
  constexpr std::uint32_t architecture = AUDIT_ARCH_AARCH64;
#else
  constexpr std::uint32_t architecture = 0;
#endif
  const auto load = [](std::size_t offset) {
    return sock_filter{BPF_LD | BPF_W | BPF_ABS, 0, 0, static_cast<std::uint32_t>(offset)};
  };
  const auto skip_unless = [](std::uint32_t value, std::uint8_t count) {
    return sock_filter{BPF_JMP | BPF_JEQ | BPF_K, 0, count, value};
  };
  const auto result = [](std::uint32_t value) { return sock_filter{BPF_RET | BPF_K, 0, 0, value}; };
  std::array<sock_filter, 6> program{load(offsetof(seccomp_data, arch)), skip_unless(architecture, 3),
                                     load(offsetof(seccomp_data, nr)),   skip_unless(__NR_socket, 1),
                                     result(SECCOMP_RET_ERRNO | EACCES), result(SECCOMP_RET_ALLOW)};
  const sock_fprog filter{static_cast<unsigned short>(program.size()), program.data()};
  ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter);
}

void limit(__rlimit_resource resource, std::size_t most) {
  const rlimit value{most, most};
  ::setrlimit(resource, &value);
}

/// Everything between fork() and exec(): only calls that are safe there. Does not return.
[[noreturn]] void become(const char* program, char* const* arguments, int words, const ChildLimits& limits) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  ::setpgid(0, 0);
  const int nothing = ::open("/dev/null", O_RDWR);
  ::dup2(nothing, STDIN_FILENO);
  ::dup2(nothing, STDOUT_FILENO);
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
  forbid_sockets();
  ::execv(program, arguments);
  ::_exit(cannot_execute);
}

}  // namespace

class Child::State : public std::enable_shared_from_this<Child::State> {
 public:
  State(net::io_context& context, const ChildLimits& limits, Done done)
      : limits_(limits), done_(std::move(done)), words_(context), process_(context), timer_(context) {}

  std::expected<void, std::string> start(const std::string& program, const std::vector<std::string>& arguments) {
    std::vector<std::string> texts{program};
    texts.insert(texts.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& text : texts) pointers.push_back(text.data());
    pointers.push_back(nullptr);
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) return std::unexpected(reason());
    pid_ = ::fork();
    if (pid_ == 0) become(program.c_str(), pointers.data(), ends[1], limits_);
    const int fork_error = errno;
    ::close(ends[1]);
    if (pid_ < 0) {
      ::close(ends[0]);
      return std::unexpected(std::generic_category().message(fork_error));
    }
    words_.assign(ends[0]);
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
      ::kill(-self->pid_, SIGKILL);
    });
    return {};
  }

  /// Ends it at once and without a word to anybody.
  void kill() {
    done_ = nullptr;
    timer_.cancel();
    boost::system::error_code ignored;
    words_.close(ignored);
    process_.close(ignored);
    if (pid_ <= 0) return;
    ::kill(-pid_, SIGKILL);
    ::kill(pid_, SIGKILL);  // where it has not yet made its group
    while (::waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
    }
    pid_ = -1;
  }

 private:
  void read_words() {
    words_.async_read_some(net::buffer(chunk_),
                           [self = shared_from_this()](const boost::system::error_code& error, std::size_t size) {
                             if (error) return;
                             const std::size_t room = self->limits_.words_bytes - self->end_.words.size();
                             self->end_.words.append(self->chunk_.data(), std::min(size, room));
                             self->read_words();
                           });
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
    timer_.cancel();
    drain();
    end_.has_succeeded = WIFEXITED(status) && WEXITSTATUS(status) == 0 && !is_late_;
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

  /// What it wrote just before its end.
  void drain() {
    words_.native_non_blocking(true);
    for (;;) {
      const std::size_t room = limits_.words_bytes - end_.words.size();
      const ssize_t size = ::read(words_.native_handle(), chunk_.data(), std::min(chunk_.size(), room));
      if (size <= 0) return;
      end_.words.append(chunk_.data(), static_cast<std::size_t>(size));
    }
  }

  ChildLimits limits_;
  Done done_;
  net::posix::stream_descriptor words_;
  net::posix::stream_descriptor process_;
  net::steady_timer timer_;
  std::array<char, 4096> chunk_{};
  ChildEnd end_;
  pid_t pid_ = -1;
  bool is_late_ = false;
};

std::expected<std::unique_ptr<Child>, std::string> Child::start(net::io_context& context, const std::string& program,
                                                                const std::vector<std::string>& arguments,
                                                                const ChildLimits& limits, Done done) {
  auto state = std::make_shared<State>(context, limits, std::move(done));
  if (const auto started = state->start(program, arguments); !started) return std::unexpected(started.error());
  return std::unique_ptr<Child>(new Child(std::move(state)));
}

Child::Child(std::shared_ptr<State> state) : state_(std::move(state)) {}
Child::~Child() { state_->kill(); }

}  // namespace geminga::daemon
