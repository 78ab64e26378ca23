#include "query/top/raw_terminal.hpp"

#include <poll.h>
#include <sys/ioctl.h>
#include <sys/signalfd.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>

#include "base/text.hpp"

namespace geminga::query::top {
namespace {

constexpr std::string_view enter_sequence = "\x1b[?1049h\x1b[?25l";
constexpr std::string_view leave_sequence = "\x1b[0m\x1b[?25h\x1b[?1049l";

/// Signals that end a program where it stands.
constexpr std::array<int, 6> ending_signals{SIGQUIT, SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL};

// A handler of signals has no other way to the terminal's former state. Written before the handlers are set.
termios former;
termios raw;

/// Async-signal-safe (signal-safety(7)), like all that the handlers call.
void put(std::string_view octets) {
  while (!octets.empty()) {
    const ssize_t size = ::write(STDOUT_FILENO, octets.data(), octets.size());
    if (size < 0 && errno != EINTR) return;
    if (size > 0) octets.remove_prefix(static_cast<std::size_t>(size));
  }
}

void enter() {
  ::tcsetattr(STDIN_FILENO, TCSAFLUSH, &raw);
  put(enter_sequence);
}
void leave() {
  // Waits for no output, since a handler must not; keys that nobody has read are no commands for the shell.
  ::tcsetattr(STDIN_FILENO, TCSANOW, &former);
  ::tcflush(STDIN_FILENO, TCIFLUSH);
  put(leave_sequence);
}

extern "C" void on_end(int signal) {
  leave();
  ::signal(signal, SIG_DFL);
  ::raise(signal);  // comes when this handler returns
}

extern "C" void on_stop(int) {
  const int error = errno;
  leave();
  ::raise(SIGSTOP);  // goes on here
  enter();
  ::raise(SIGWINCH);  // all is written again
  errno = error;
}

void handle(int signal, void (*handler)(int)) {
  struct sigaction action{};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  ::sigaction(signal, &action, nullptr);
}

sigset_t of_size() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGWINCH);
  return set;
}

}  // namespace

RawTerminal::RawTerminal() {
  ::tcgetattr(STDIN_FILENO, &former);
  raw = former;
  raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  raw.c_iflag &= ~static_cast<tcflag_t>(ICRNL | IXON);
  raw.c_cc[VMIN] = 0;
  raw.c_cc[VTIME] = 0;
  for (const int signal : ending_signals) handle(signal, on_end);
  handle(SIGTSTP, on_stop);
  const sigset_t set = of_size();
  ::sigprocmask(SIG_BLOCK, &set, nullptr);
  changes_ = ::signalfd(-1, &set, SFD_CLOEXEC | SFD_NONBLOCK);
  enter();
}

RawTerminal::~RawTerminal() {
  handle(SIGTSTP, SIG_DFL);
  leave();
  for (const int signal : ending_signals) handle(signal, SIG_DFL);
  if (changes_ >= 0) ::close(changes_);
  const sigset_t set = of_size();
  ::sigprocmask(SIG_UNBLOCK, &set, nullptr);
}

bool RawTerminal::is_there() {
  const char* kind = std::getenv("TERM");
  return ::isatty(STDIN_FILENO) == 1 && ::isatty(STDOUT_FILENO) == 1 && kind != nullptr && *kind != '\0' &&
         std::string_view(kind) != "dumb";
}

Size RawTerminal::size() {
  Size size;
  winsize stated{};
  if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &stated) == 0) {
    if (stated.ws_row > 0) size.rows = stated.ws_row;
    if (stated.ws_col > 0) size.columns = stated.ws_col;
  }
  return size;
}

bool RawTerminal::take_change() const {
  signalfd_siginfo change{};
  bool has_changed = false;
  while (::read(changes_, &change, sizeof change) == sizeof change) has_changed = true;
  return has_changed;
}

bool RawTerminal::read(std::string& octets) const {
  pollfd input{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
  octets.clear();
  if (::poll(&input, 1, 0) <= 0) return true;
  std::array<char, 256> chunk{};
  const ssize_t size = ::read(STDIN_FILENO, chunk.data(), chunk.size());
  if (size > 0) octets.assign(chunk.data(), static_cast<std::size_t>(size));
  return size > 0 || (size < 0 && (errno == EINTR || errno == EAGAIN));
}

bool RawTerminal::write(std::string_view octets) const {
  while (!octets.empty()) {
    const ssize_t size = ::write(STDOUT_FILENO, octets.data(), octets.size());
    if (size < 0 && errno == EINTR) continue;
    if (size < 0) return false;
    octets.remove_prefix(static_cast<std::size_t>(size));
  }
  return true;
}

}  // namespace geminga::query::top
