// The filter of the cage for the processors of robots and of their programmers' machines, read as its program. Where an
// emulator has no seccomp, and for a processor that is not at hand, this stands in for trying each way out.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/netlink.h>
#include <netinet/in.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <termios.h>

#include <csignal>
#include <cstdlib>
#include <string>
#include <vector>

#include "env/cage/filter_program.hpp"

namespace geminga::cage {
namespace {

constexpr int absent = -1;  ///< the processor has no such call

/// The numbers of calls (Linux: arch/x86/entry/syscalls/syscall_64.tbl, include/uapi/asm-generic/unistd.h).
struct CallNumbers {
  const char* name;
  int x86_64;
  int aarch64;
  [[nodiscard]] int on(Processor processor) const { return processor == Processor::aarch64 ? aarch64 : x86_64; }
};

constexpr CallNumbers read_call{"read", 0, 63};
constexpr CallNumbers exit_group_call{"exit_group", 231, 94};
constexpr CallNumbers rt_sigreturn_call{"rt_sigreturn", 15, 139};
constexpr CallNumbers open_call{"open", 2, absent};
constexpr CallNumbers openat_call{"openat", 257, 56};
constexpr CallNumbers mmap_call{"mmap", 9, 222};
constexpr CallNumbers mprotect_call{"mprotect", 10, 226};
constexpr CallNumbers clone_call{"clone", 56, 220};
constexpr CallNumbers clone3_call{"clone3", 435, 435};
constexpr CallNumbers fork_call{"fork", 57, absent};
constexpr CallNumbers socket_call{"socket", 41, 198};
constexpr CallNumbers setsockopt_call{"setsockopt", 54, 208};
constexpr CallNumbers connect_call{"connect", 42, 203};
constexpr CallNumbers execve_call{"execve", 59, 221};
constexpr CallNumbers prctl_call{"prctl", 157, 167};
constexpr CallNumbers kill_call{"kill", 62, 129};
constexpr CallNumbers ioctl_call{"ioctl", 16, 29};
constexpr CallNumbers unlinkat_call{"unlinkat", 263, 35};
constexpr CallNumbers renameat_call{"renameat", 264, 38};
constexpr CallNumbers epoll_wait_call{"epoll_wait", 232, absent};
constexpr CallNumbers epoll_pwait_call{"epoll_pwait", 281, 22};

/// Calls that no freedom leaves, whatever their arguments are.
constexpr CallNumbers never[]{{"io_uring_setup", 425, 425},
                              {"ptrace", 101, 117},
                              {"mount", 165, 40},
                              {"setns", 308, 268},
                              {"unshare", 272, 97},
                              {"bpf", 321, 280},
                              {"perf_event_open", 298, 241},
                              {"keyctl", 250, 219},
                              {"userfaultfd", 323, 282},
                              {"process_vm_writev", 311, 271},
                              {"openat2", 437, 437},
                              {"execveat", 322, 281},
                              {"mkdirat", 258, 34},
                              {"mknodat", 259, 33},
                              {"chmod", 90, absent},
                              {"fchmodat", 268, 53},
                              {"setuid", 105, 146}};

Freedom freedom_of_reader() { return {}; }
Freedom freedom_of_child() {
  Freedom freedom;
  freedom.may_become = true;
  freedom.may_read_all = true;
  return freedom;
}
Freedom freedom_of_writer() {
  Freedom freedom;
  freedom.writable_folders = {"/tmp"};
  return freedom;
}
Freedom freedom_of_server() {
  Freedom freedom;
  freedom.may_serve = true;
  freedom.may_read_all = true;
  return freedom;
}

constexpr std::uint64_t every_bit = ~std::uint64_t{0};
constexpr std::uint64_t branch_targets = 0x10;  ///< PROT_BTI of aarch64 (Linux: asm/mman.h)

/// A call with arguments, and the answers of the four cages.
struct Case {
  CallNumbers call;
  std::array<std::uint64_t, 6> arguments;
  Verdict of_reader;
  Verdict of_child;
  Verdict of_writer;
  Verdict of_server;
};

constexpr Verdict yes = Verdict::allowed;
constexpr Verdict no = Verdict::forbidden;
constexpr Verdict unknown = Verdict::unknown_to_kernel;

const Case cases[]{
    {read_call, {0, 1, 2}, yes, yes, yes, yes},
    {exit_group_call, {}, yes, yes, yes, yes},
    {rt_sigreturn_call, {}, yes, yes, yes, yes},
    // files: O_RDONLY, O_WRONLY, O_RDWR, O_WRONLY | O_CREAT, O_WRONLY | O_TRUNC; the values are the same everywhere
    {open_call, {0, 00}, yes, yes, yes, yes},
    {open_call, {0, 01}, no, no, yes, yes},
    {openat_call, {0, 0, 00}, yes, yes, yes, yes},
    {openat_call, {0, 0, 01}, no, no, yes, yes},
    {openat_call, {0, 0, 02}, no, no, yes, yes},
    {openat_call, {0, 0, 0101}, no, no, yes, no},
    {openat_call, {0, 0, 01001}, no, no, yes, no},
    {unlinkat_call, {}, no, no, yes, no},
    {renameat_call, {}, no, no, yes, no},
    // memory
    {mmap_call, {0, 4096, PROT_READ | PROT_WRITE}, yes, yes, yes, yes},
    {mmap_call, {0, 4096, PROT_READ | PROT_EXEC}, no, yes, no, yes},
    {mmap_call, {0, 4096, PROT_READ | PROT_EXEC | branch_targets}, no, yes, no, yes},
    {mmap_call, {0, 4096, PROT_WRITE | PROT_EXEC}, no, yes, no, no},
    {mprotect_call, {0, 4096, PROT_READ}, yes, yes, yes, yes},
    {mprotect_call, {0, 4096, PROT_READ | PROT_EXEC}, no, yes, no, no},
    // threads, processes, other programs
    {clone_call, {CLONE_VM | CLONE_THREAD | CLONE_SIGHAND | CLONE_FS | CLONE_FILES}, yes, yes, yes, yes},
    {clone_call, {CLONE_VM | CLONE_THREAD | CLONE_NEWUSER}, no, no, no, no},
    {clone_call, {SIGCHLD}, no, no, no, yes},
    {clone_call, {SIGCHLD | CLONE_NEWNET}, no, no, no, no},
    {clone3_call, {}, unknown, unknown, unknown, unknown},
    {fork_call, {}, no, no, no, yes},
    {execve_call, {}, no, yes, no, yes},
    {prctl_call, {PR_SET_NO_NEW_PRIVS, 1}, yes, yes, yes, yes},
    {prctl_call, {PR_SET_PDEATHSIG, SIGKILL}, no, no, no, yes},
    {prctl_call, {PR_SET_SECUREBITS}, no, no, no, no},
    {kill_call, {1, SIGTERM}, no, no, no, no},
    {kill_call, {1, SIGKILL}, no, no, no, yes},
    // sockets and waiting
    {socket_call, {AF_UNIX, SOCK_STREAM}, no, no, no, yes},
    {socket_call, {AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, IPPROTO_UDP}, no, no, no, yes},
    {socket_call, {AF_INET, SOCK_RAW, IPPROTO_ICMP}, no, no, no, no},
    {socket_call, {AF_NETLINK, SOCK_RAW, NETLINK_ROUTE}, no, no, no, yes},
    {socket_call, {AF_NETLINK, SOCK_RAW, NETLINK_NETFILTER}, no, no, no, no},
    {socket_call, {AF_PACKET, SOCK_RAW, 0}, no, no, no, no},
    {setsockopt_call, {3, SOL_SOCKET}, no, no, no, yes},
    {setsockopt_call, {3, SOL_NETLINK}, no, no, no, no},
    {connect_call, {}, no, no, no, yes},
    {epoll_wait_call, {}, no, no, no, yes},
    {epoll_pwait_call, {}, no, no, no, yes},
    {ioctl_call, {0, TCGETS}, yes, yes, yes, yes},
    {ioctl_call, {0, TIOCSTI}, no, no, no, no}};

struct Cage {
  const char* name;
  Freedom freedom;
  Verdict Case::* expected;
};

std::vector<Cage> cages() {
  return {{"reader", freedom_of_reader(), &Case::of_reader},
          {"child", freedom_of_child(), &Case::of_child},
          {"writer", freedom_of_writer(), &Case::of_writer},
          {"server", freedom_of_server(), &Case::of_server}};
}

class FilterOf : public testing::TestWithParam<Processor> {
 protected:
  void SetUp() override {
    if (is_sanitized) GTEST_SKIP() << "a sanitizer's cage is wider";
  }
};

TEST_P(FilterOf, AnswersEachCallOfTheTable) {
  for (const Cage& cage : cages()) {
    const FilterProgram program(cage.freedom, GetParam());
    ASSERT_GT(program.size(), 0U) << cage.name;
    for (const Case& asked : cases) {
      const int number = asked.call.on(GetParam());
      if (number == absent) continue;
      EXPECT_EQ(program.ask({GetParam(), number, asked.arguments}), asked.*cage.expected)
          << cage.name << ": " << asked.call.name << ", case " << (&asked - cases);
    }
  }
}

TEST_P(FilterOf, LeavesSomeCallsToNobody) {
  for (const Cage& cage : cages()) {
    const FilterProgram program(cage.freedom, GetParam());
    for (const CallNumbers& call : never) {
      const int number = call.on(GetParam());
      if (number == absent) continue;
      for (const std::uint64_t value : {std::uint64_t{0}, std::uint64_t{1}, every_bit}) {
        AskedCall asked{GetParam(), number, {}};
        asked.arguments.fill(value);
        EXPECT_EQ(program.ask(asked), no) << cage.name << ": " << call.name << " with " << value;
      }
    }
  }
}

TEST_P(FilterOf, AnswersNoCallOfAnotherProcessor) {
  const Processor other = GetParam() == Processor::aarch64 ? Processor::x86_64 : Processor::aarch64;
  for (const Cage& cage : cages()) {
    const FilterProgram program(cage.freedom, GetParam());
    EXPECT_EQ(program.ask({other, read_call.on(other), {}}), Verdict::ended) << cage.name;
  }
}

TEST_P(FilterOf, ForbidsNumbersThatNoKernelHas) {
  for (const Cage& cage : cages()) {
    const FilterProgram program(cage.freedom, GetParam());
    for (const int number : {511, 1023, 0x10000}) EXPECT_EQ(program.ask({GetParam(), number, {}}), no) << cage.name;
  }
}

TEST_P(FilterOf, IsShortEnoughForAKernel) {
  for (const Cage& cage : cages()) {
    const FilterProgram program(cage.freedom, GetParam());
    EXPECT_GT(program.size(), 50U) << cage.name;
    EXPECT_LE(program.size(), std::size_t{BPF_MAXINSNS}) << cage.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Cage, FilterOf, testing::Values(Processor::x86_64, Processor::aarch64),
                         [](const auto& test) { return test.param == Processor::aarch64 ? "Aarch64" : "X86_64"; });

TEST(Filter, AnswersACallThatBothProcessorsHaveInOneWay) {
  if (is_sanitized) GTEST_SKIP() << "a sanitizer's cage is wider";
  constexpr int number_of_calls = 512;
  const std::uint64_t values[]{0, 1, 2, 3, 4, 6, 9, 15, 16, 17, 0101, 0x5401, 0x5412, 0x10100, SIGCHLD, every_bit};
  for (const Cage& cage : cages()) {
    const FilterProgram here(cage.freedom, Processor::x86_64);
    const FilterProgram there(cage.freedom, Processor::aarch64);
    int compared = 0;
    for (int number = 0; number < number_of_calls; ++number) {
      char* name = seccomp_syscall_resolve_num_arch(SCMP_ARCH_X86_64, number);
      if (name == nullptr) continue;
      const int other = seccomp_syscall_resolve_name_arch(SCMP_ARCH_AARCH64, name);
      for (std::size_t place = 0; other >= 0 && place < 3; ++place) {
        for (const std::uint64_t value : values) {
          AskedCall asked{Processor::x86_64, number, {}};
          asked.arguments[place] = value;
          const auto answer = here.ask(asked);
          asked.processor = Processor::aarch64;
          asked.number = other;
          EXPECT_EQ(there.ask(asked), answer) << cage.name << ": " << name << ", argument " << place << " is " << value;
          ++compared;
        }
      }
      std::free(name);
    }
    EXPECT_GT(compared, 10'000) << cage.name;
  }
}

TEST(Filter, IsNotWrittenWhereItsFileCannotBe) { EXPECT_FALSE(write_filter({}, Processor::aarch64, -1)); }

}  // namespace
}  // namespace geminga::cage
