// Every way out of the cage, tried from inside.
#include "env/cage/cage.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/bpf.h>
#include <linux/perf_event.h>
#include <poll.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/mount.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <sys/uio.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <string>
#include <thread>

#include "env/cage/inside.hpp"

namespace geminga::cage {
namespace {

namespace fs = std::filesystem;

struct WayOut {
  const char* name;
  std::function<long()> attempt;
};

std::vector<WayOut> ways_out() {
  static std::array<char, 4096> memory{};
  const pid_t parent = ::getpid();
  std::vector<WayOut> ways;
  for (const int domain : {AF_INET, AF_INET6, AF_UNIX, AF_NETLINK, AF_PACKET, AF_ALG, AF_VSOCK})
    ways.push_back({"socket", [=] { return ::socket(domain, SOCK_DGRAM, 0); }});
  ways.insert(
      ways.end(),
      {{"socketpair",
        [] { return call(SYS_socketpair, AF_UNIX, SOCK_STREAM, 0, reinterpret_cast<long>(memory.data())); }},
       {"io_uring_setup", [] { return call(SYS_io_uring_setup, 8, reinterpret_cast<long>(memory.data())); }},
       {"fork", [] { return static_cast<long>(::fork()); }},
       {"vfork by clone", [] { return call(SYS_clone, CLONE_VFORK | SIGCHLD); }},
       {"a new user namespace by clone", [] { return call(SYS_clone, CLONE_NEWUSER | SIGCHLD); }},
       {"clone3", [] { return call(SYS_clone3, reinterpret_cast<long>(memory.data()), 88); }},
       {"unshare", [] { return static_cast<long>(::unshare(CLONE_NEWUSER)); }},
       {"setns", [] { return call(SYS_setns, 0, 0); }},
       {"kill of the parent", [=] { return static_cast<long>(::kill(parent, SIGTERM)); }},
       {"kill of everybody", [] { return static_cast<long>(::kill(-1, 0)); }},
       {"tgkill of the parent", [=] { return call(SYS_tgkill, parent, parent, SIGTERM); }},
       {"tkill of the parent", [=] { return call(SYS_tkill, parent, SIGTERM); }},
       {"rt_sigqueueinfo",
        [=] { return call(SYS_rt_sigqueueinfo, parent, SIGTERM, reinterpret_cast<long>(memory.data())); }},
       {"pidfd_open", [=] { return call(SYS_pidfd_open, parent); }},
       {"pidfd_getfd", [] { return call(SYS_pidfd_getfd, 0, 0, 0); }},
       {"fcntl F_SETOWN", [=] { return static_cast<long>(::fcntl(STDERR_FILENO, F_SETOWN, parent)); }},
       {"fcntl F_SETFL", [] { return static_cast<long>(::fcntl(STDERR_FILENO, F_SETFL, O_ASYNC)); }},
       {"prlimit of the parent", [=] { return call(SYS_prlimit64, parent, RLIMIT_CPU, 0, 0); }},
       {"setpriority", [=] { return static_cast<long>(::setpriority(PRIO_PROCESS, static_cast<id_t>(parent), 19)); }},
       {"sched_setaffinity",
        [=] { return call(SYS_sched_setaffinity, parent, 8, reinterpret_cast<long>(memory.data())); }},
       {"process_vm_writev", [=] { return call(SYS_process_vm_writev, parent, 0, 0, 0, 0); }},
       {"bpf", [] { return call(SYS_bpf, BPF_PROG_LOAD, reinterpret_cast<long>(memory.data()), 64); }},
       {"perf_event_open", [] { return call(SYS_perf_event_open, reinterpret_cast<long>(memory.data()), 0, -1, -1); }},
       {"keyctl", [] { return call(SYS_keyctl, 0, -3, 0); }},
       {"add_key", [] { return call(SYS_add_key, 0, 0, 0, 0, 0); }},
       {"userfaultfd", [] { return call(SYS_userfaultfd, 0); }},
       {"mount", [] { return static_cast<long>(::mount("none", "/mnt", "tmpfs", 0, nullptr)); }},
       {"chroot", [] { return static_cast<long>(::chroot("/")); }},
       {"mknod", [] { return call(SYS_mknodat, AT_FDCWD, reinterpret_cast<long>("/tmp/geminga-node"), 010600, 0); }},
       {"open_by_handle_at", [] { return call(SYS_open_by_handle_at, AT_FDCWD, 0, 0); }},
       {"openat2",
        [] {
          return call(SYS_openat2, AT_FDCWD, reinterpret_cast<long>("/etc/passwd"),
                      reinterpret_cast<long>(memory.data()), 24);
        }},
       {"inotify_init", [] { return call(SYS_inotify_init1, 0); }},
       {"shmget", [] { return call(SYS_shmget, 0, 4096, 01600); }},
       {"mq_open", [] { return call(SYS_mq_open, reinterpret_cast<long>("geminga"), O_RDONLY, 0, 0); }},
       {"setuid", [] { return call(SYS_setuid, 0); }},
       {"a character for the terminal", [] { return static_cast<long>(::ioctl(0, TIOCSTI, "x")); }},
       {"open for writing", [] { return static_cast<long>(::open("/dev/null", O_WRONLY)); }},
       {"open for reading and writing", [] { return static_cast<long>(::open("/dev/null", O_RDWR)); }},
       {"a new file", [] { return static_cast<long>(::open("/tmp/geminga-cage", O_RDONLY | O_CREAT, 0600)); }},
       {"a file without a name", [] { return static_cast<long>(::open("/tmp", O_TMPFILE | O_RDWR, 0600)); }},
       {"unlink", [] { return static_cast<long>(::unlink("/tmp/geminga-no-such-file")); }},
       {"rename", [] { return static_cast<long>(::rename("/tmp/geminga-no-such-file", "/tmp/geminga-another")); }},
       {"mkdir", [] { return static_cast<long>(::mkdir("/tmp/geminga-cage", 0700)); }},
       {"chmod", [] { return call(SYS_fchmodat, AT_FDCWD, reinterpret_cast<long>("/tmp"), 01777); }},
       {"the parent's memory",
        [=] { return static_cast<long>(::open(("/proc/" + std::to_string(parent) + "/mem").c_str(), O_RDWR)); }}});
  if (!is_sanitized) {
    ways.push_back({"ptrace", [] { return call(SYS_ptrace, PTRACE_TRACEME, 0, 0, 0); }});
    ways.push_back({"process_vm_readv", [=] { return call(SYS_process_vm_readv, parent, 0, 0, 0, 0); }});
    ways.push_back({"personality", [] { return call(SYS_personality, 0); }});
    ways.push_back({"prctl", [] { return static_cast<long>(::prctl(PR_SET_PDEATHSIG, 0)); }});
  }
  return ways;
}

class WaysOut : public testing::TestWithParam<bool> {};

TEST_P(WaysOut, AreClosed) {
  Freedom freedom;
  freedom.may_become = GetParam();
  freedom.may_read_all = GetParam();
  for (const WayOut& way : ways_out()) {
    const int error = inside(freedom, [&] { return error_of(way.attempt()); });
    if (error == no_cage) GTEST_SKIP() << "this kernel has no seccomp";
    EXPECT_EQ(error, std::string_view(way.name) == "clone3" ? ENOSYS : EACCES) << way.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Cage, WaysOut, testing::Bool(),
                         [](const auto& test) { return test.param ? "OfAChildThatBecomesAProgram" : "OfAReader"; });

TEST(Cage, OfAReaderHasNoOtherProgramsAndNoNewCode) {
  const auto run_true = [] {
    const char* arguments[] = {"true", nullptr};
    return error_of(::execv("/bin/true", const_cast<char**>(arguments)));
  };
  const int inner = inside({}, run_true);
  if (inner == no_cage) GTEST_SKIP() << "this kernel has no seccomp";
  EXPECT_EQ(inner, EACCES);
  Freedom freedom;
  freedom.may_become = true;
  freedom.may_read_all = true;
  EXPECT_EQ(inside(freedom, run_true), 0);
  if (is_sanitized) return;
  EXPECT_EQ(inside({},
                   [] {
                     void* code = ::mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
                     return code == MAP_FAILED ? 1 : error_of(::mprotect(code, 4096, PROT_READ | PROT_EXEC));
                   }),
            EACCES);
}

TEST(Cage, LeavesWhatReasoningNeeds) {
  const int status = inside({}, [] {
    std::vector<int> numbers(100'000, 1);
    int sum = 0;
    std::thread other([&] {
      for (const int number : numbers) sum += number;
    });
    other.join();
    try {
      throw std::runtime_error("an exception");
    } catch (const std::exception&) {
      ++sum;
    }
    (void)::isatty(STDERR_FILENO);
    return sum == 100'001 ? 0 : 1;
  });
  if (status == no_cage) GTEST_SKIP() << "this kernel has no seccomp";
  EXPECT_EQ(status, 0);
}

TEST(Cage, LeavesAProgramItsOwnTimeLimit) {
  Freedom child;
  child.may_become = true;
  child.may_read_all = true;
  for (const Freedom& freedom : {Freedom(), child}) {
    const int status = inside(freedom, [] {
      std::signal(SIGALRM, SIG_DFL);
      itimerval timer{};
      timer.it_value.tv_usec = 1;
      if (::setitimer(ITIMER_REAL, &timer, nullptr) != 0) return errno;
      while (true) ::poll(nullptr, 0, -1);
    });
    if (status == no_cage) GTEST_SKIP() << "this kernel has no seccomp";
    EXPECT_EQ(status, 1000 + SIGALRM);
  }
}

TEST(Cage, LetsAProcessEndItself) {
  const int status = inside({}, [] {
    const rlimit none{0, 0};
    ::setrlimit(RLIMIT_CORE, &none);
    std::signal(SIGABRT, SIG_DFL);
    std::abort();
    return 0;
  });
  if (status == no_cage) GTEST_SKIP() << "this kernel has no seccomp";
  EXPECT_EQ(status, 1000 + SIGABRT);
}

TEST(Cage, OpensOnlyWhatIsNamed) {
  std::string path = fs::temp_directory_path() / "geminga-cage-XXXXXX";
  ASSERT_NE(::mkdtemp(path.data()), nullptr);
  const fs::path folder = path;
  fs::create_directories(folder / "team" / "deep");
  for (const char* name : {"team/a.ttl", "team/deep/b.ttl", "named.ttl", "secret"}) std::ofstream(folder / name) << "x";
  fs::create_symlink("../secret", folder / "team" / "link.ttl");
  Freedom freedom;
  freedom.readable = {folder / "team", folder / "named.ttl", folder / "missing.ttl"};
  const auto open_error = [&](const fs::path& file, int flags = O_RDONLY) {
    return in_child([&] {
      const Held held = close(freedom);
      return held.by_paths && held.by_system_calls ? error_of(::open(file.c_str(), flags, 0600)) : no_cage;
    });
  };
  const int first = open_error(folder / "team" / "a.ttl");
  if (first == no_cage) {
    fs::remove_all(folder);
    GTEST_SKIP() << "this kernel has no Landlock";
  }
  EXPECT_EQ(first, 0);
  EXPECT_EQ(open_error(folder / "team" / "deep" / "b.ttl"), 0);
  EXPECT_EQ(open_error(folder / "named.ttl"), 0);
  for (const fs::path& forbidden : {folder / "secret", folder / "team" / "link.ttl", fs::path("/etc/passwd"), folder})
    EXPECT_EQ(open_error(forbidden), EACCES) << forbidden;
  // A folder may be written to.
  fs::create_directory(folder / "out");
  freedom.writable_folders = {folder / "out"};
  EXPECT_EQ(open_error(folder / "out" / "new", O_WRONLY | O_CREAT), 0);
  for (const fs::path& forbidden : {folder / "secret", folder / "team" / "a.ttl", folder / "new",
                                    fs::path("/proc/" + std::to_string(::getpid()) + "/mem")})
    EXPECT_EQ(open_error(forbidden, O_WRONLY | O_CREAT), EACCES) << forbidden;
  fs::remove_all(folder);
}

/// The fault of a cage in which this path may be read, in a process that may have so many descriptors more (null: any);
/// nothing where this kernel has no Landlock.
std::optional<std::string> fault_with(const std::string& path, std::optional<rlim_t> descriptors = std::nullopt) {
  std::array<int, 2> words{};
  if (::pipe(words.data()) != 0) return "no pipe";
  const int status = in_child([&] {
    int answer = words[1];
    if (descriptors) {
      constexpr int last = 3;  // whatever this process has inherited
      answer = ::dup2(answer, last);
      ::close_range(last + 1, ~0U, 0);
      const rlimit limit{last + 1 + *descriptors, last + 1 + *descriptors};
      ::setrlimit(RLIMIT_NOFILE, &limit);
    }
    Freedom freedom;
    freedom.readable = {path};
    const Held held = close(freedom);
    if (!held.by_paths && held.fault.empty()) return no_cage;
    return ::write(answer, held.fault.data(), held.fault.size()) < 0 ? 1 : 0;
  });
  ::close(words[1]);
  std::string fault(1000, '\0');
  fault.resize(static_cast<std::size_t>(std::max<ssize_t>(::read(words[0], fault.data(), fault.size()), 0)));
  ::close(words[0]);
  return status == no_cage ? std::nullopt : std::optional(fault);
}

TEST(Cage, PassesOverPathsThatLeadNowhereAndNamesOneThatCannotBeOpenedNow) {
  if (is_sanitized) GTEST_SKIP() << "a sanitizer needs /proc, too";
  const auto fault = fault_with("/etc/passwd", 1);
  if (!fault) GTEST_SKIP() << "this kernel has no Landlock";
  EXPECT_EQ(*fault, "/etc/passwd: cannot be opened: Too many open files");
  EXPECT_EQ(fault_with("/etc/passwd", 2), "");
  EXPECT_EQ(fault_with("/etc/passwd", 0), "the rules of Landlock: cannot be opened: Too many open files");
  const std::array<std::string, 4> nowhere{"/nowhere", "/etc/passwd/file", std::string(5000, 'a'), ""};
  for (const std::string& path : nowhere) EXPECT_EQ(fault_with(path), "") << path;
  EXPECT_EQ(fault_with("/dev/fd/0"), "");
  std::array<int, 2> pipe{};
  ASSERT_EQ(::pipe(pipe.data()), 0);
  EXPECT_EQ(fault_with("/dev/fd/" + std::to_string(pipe[0])), "") << "a pipe is nobody's file";
  for (const int end : pipe) ::close(end);
}

TEST(Cage, CanOnlyBeMadeNarrower) {
  Freedom wide;
  wide.may_become = true;
  wide.may_read_all = true;
  const int status = inside(wide, [&] {
    if (!close({}).by_system_calls) return 1;
    close(wide);
    const char* arguments[] = {"true", nullptr};
    return error_of(::execv("/bin/true", const_cast<char**>(arguments)));
  });
  if (status == no_cage) GTEST_SKIP() << "this kernel has no seccomp";
  EXPECT_EQ(status, EACCES);
}

TEST(Cage, OfRootHasNoCapabilitiesButToReadFiles) {
  if (::geteuid() != 0) GTEST_SKIP() << "nobody but root has any";
  const auto has = [](long capability) {
    std::ifstream status("/proc/self/status");
    std::string line;
    while (std::getline(status, line)) {
      if (line.starts_with("CapEff:")) return (std::stoull(line.substr(8), nullptr, 16) >> capability & 1U) != 0;
    }
    return true;
  };
  Freedom freedom;
  freedom.may_read_all = true;
  const int status = inside(freedom, [&] { return has(19) || has(21) || has(1) || !has(2) ? 1 : 0; });
  if (status == no_cage) GTEST_SKIP() << "this kernel has no seccomp";
  EXPECT_EQ(status, 0) << "neither CAP_SYS_PTRACE nor CAP_SYS_ADMIN nor CAP_DAC_OVERRIDE, but CAP_DAC_READ_SEARCH";
}

}  // namespace
}  // namespace geminga::cage
