// ptrace with PTRACE_GET_SYSCALL_INFO, which is the same on every processor.
#include "reasoning/syntax/rdf/watched.hpp"

// In this order: the kernel's header leans on glibc's.
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>

namespace geminga::rdf {
namespace {

std::string text_at(pid_t process, std::uint64_t address) {
  std::string text;
  while (text.size() < 4096) {
    errno = 0;
    const long word = ptrace(PTRACE_PEEKDATA, process, address + text.size(), nullptr);
    if (errno != 0) return text;
    const auto* bytes = reinterpret_cast<const char*>(&word);
    for (std::size_t i = 0; i < sizeof word; ++i) {
      if (bytes[i] == '\0') return text;
      text += bytes[i];
    }
  }
  return text;
}

void note(pid_t process, Watched& watched) {
  struct __ptrace_syscall_info call{};
  if (ptrace(PTRACE_GET_SYSCALL_INFO, process, sizeof call, &call) <= 0) return;
  if (call.op != PTRACE_SYSCALL_INFO_ENTRY) return;
  switch (call.entry.nr) {
    case SYS_openat:
      watched.opened.push_back(text_at(process, call.entry.args[1]));
      break;
#ifdef SYS_open
    case SYS_open:
      watched.opened.push_back(text_at(process, call.entry.args[0]));
      break;
#endif
    case SYS_socket:
    case SYS_connect:
      watched.asked_for_sockets = true;
      break;
    case SYS_execve:
      watched.asked_for_programs = true;
      break;
    default:
      break;
  }
}

[[noreturn]] void be_watched(unsigned seconds, int pipe, const std::function<std::string()>& deed) {
  const rlimit limit{seconds, seconds};
  setrlimit(RLIMIT_CPU, &limit);
  ptrace(PTRACE_TRACEME, 0, nullptr, nullptr);
  raise(SIGSTOP);
  const std::string said = deed();
  const ssize_t written = write(pipe, said.data(), said.size());
  _exit(written == static_cast<ssize_t>(said.size()) ? 0 : 1);
}

}  // namespace

Watched watch(unsigned seconds, const std::function<std::string()>& deed) {
  Watched watched;
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) return watched;
  const pid_t child = fork();
  if (child == 0) be_watched(seconds, ends[1], deed);
  close(ends[1]);
  rusage usage{};
  waitpid(child, &watched.status, 0);
  ptrace(PTRACE_SETOPTIONS, child, nullptr, PTRACE_O_TRACESYSGOOD | PTRACE_O_EXITKILL);
  int signal = 0;
  while (ptrace(PTRACE_SYSCALL, child, nullptr, signal) == 0 && wait4(child, &watched.status, 0, &usage) == child &&
         WIFSTOPPED(watched.status)) {
    const bool is_call = WSTOPSIG(watched.status) == (SIGTRAP | 0x80);
    signal = is_call ? 0 : WSTOPSIG(watched.status);
    if (is_call) note(child, watched);
  }
  watched.peak_kib = usage.ru_maxrss;
  std::array<char, 4096> text{};
  const ssize_t count = read(ends[0], text.data(), text.size());
  if (count > 0) watched.said.assign(text.data(), static_cast<std::size_t>(count));
  close(ends[0]);
  return watched;
}

}  // namespace geminga::rdf
