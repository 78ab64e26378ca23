// The cage of a server: what it needs works, and every other way out is closed.
#include <arpa/inet.h>
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ifaddrs.h>
#include <linux/bpf.h>
#include <linux/netlink.h>
#include <net/if.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sched.h>
#include <sys/epoll.h>
#include <sys/mman.h>
#include <sys/mount.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/timerfd.h>
#include <sys/un.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "env/cage/inside.hpp"

namespace geminga::cage {
namespace {

namespace fs = std::filesystem;

/// The version of Landlock; 0: there is none.
long landlock_version() { return std::max(0L, call(444, 0, 0, 1)); }

Freedom server() {
  Freedom freedom;
  freedom.may_serve = true;
  freedom.may_read_all = true;
  freedom.rewritable = {"/dev/null"};
  return freedom;
}

/// A folder with one file in it, removed with all that is below it.
struct ServerCage : testing::Test {
  ServerCage() {
    std::string path = fs::temp_directory_path() / "geminga-server-XXXXXX";
    if (::mkdtemp(path.data()) != nullptr) folder = path;
    std::ofstream(folder / "file") << "x";
  }
  ~ServerCage() override { fs::remove_all(folder); }

  [[nodiscard]] std::string file(const char* name = "file") const { return folder / name; }

  fs::path folder;
};

/// TCP to this port of this host. Where nobody listens the error is ECONNREFUSED.
int connection_error(std::uint16_t port) {
  const int socket = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (socket < 0) return errno;
  sockaddr_in there{};
  there.sin_family = AF_INET;
  there.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  there.sin_port = htons(port);
  return error_of(::connect(socket, reinterpret_cast<const sockaddr*>(&there), sizeof there));
}

TEST_F(ServerCage, HasNoWayOut) {
  static std::array<char, 4096> memory{};
  const pid_t parent = ::getpid();
  const long octets = reinterpret_cast<long>(memory.data());
  std::vector<std::pair<const char*, std::function<long()>>> ways{
      {"a raw socket", [] { return static_cast<long>(::socket(AF_INET, SOCK_RAW, IPPROTO_ICMP)); }},
      {"a raw socket of IPv6", [] { return static_cast<long>(::socket(AF_INET6, SOCK_RAW, IPPROTO_ICMPV6)); }},
      {"pings", [] { return static_cast<long>(::socket(AF_INET, SOCK_DGRAM, IPPROTO_ICMP)); }},
      {"TCP on several paths", [] { return static_cast<long>(::socket(AF_INET, SOCK_STREAM, IPPROTO_MPTCP)); }},
      {"SCTP", [] { return static_cast<long>(::socket(AF_INET, SOCK_STREAM, IPPROTO_SCTP)); }},
      {"packets", [] { return static_cast<long>(::socket(AF_PACKET, SOCK_RAW, 0)); }},
      {"the kernel's ciphers", [] { return static_cast<long>(::socket(AF_ALG, SOCK_SEQPACKET, 0)); }},
      {"the hypervisor", [] { return static_cast<long>(::socket(AF_VSOCK, SOCK_STREAM, 0)); }},
      {"the firewall", [] { return static_cast<long>(::socket(AF_NETLINK, SOCK_RAW, NETLINK_NETFILTER)); }},
      {"io_uring_setup", [=] { return call(SYS_io_uring_setup, 8, octets); }},
      {"a new user namespace by clone", [] { return call(SYS_clone, CLONE_NEWUSER | SIGCHLD); }},
      {"unshare", [] { return static_cast<long>(::unshare(CLONE_NEWUSER)); }},
      {"setns", [] { return call(SYS_setns, 0, 0); }},
      {"SIGTERM for the parent", [=] { return static_cast<long>(::kill(parent, SIGTERM)); }},
      {"SIGTERM for a thread of the parent", [=] { return call(SYS_tgkill, parent, parent, SIGTERM); }},
      {"rt_sigqueueinfo", [=] { return call(SYS_rt_sigqueueinfo, parent, SIGTERM, octets); }},
      {"pidfd_getfd", [] { return call(SYS_pidfd_getfd, 0, 0, 0); }},
      {"fcntl F_SETOWN", [=] { return static_cast<long>(::fcntl(STDERR_FILENO, F_SETOWN, parent)); }},
      {"process_vm_writev", [=] { return call(SYS_process_vm_writev, parent, 0, 0, 0, 0); }},
      {"bpf", [=] { return call(SYS_bpf, BPF_PROG_LOAD, octets, 64); }},
      {"perf_event_open", [=] { return call(SYS_perf_event_open, octets, 0, -1, -1); }},
      {"keyctl", [] { return call(SYS_keyctl, 0, -3, 0); }},
      {"userfaultfd", [] { return call(SYS_userfaultfd, 0); }},
      {"mount", [] { return static_cast<long>(::mount("none", "/mnt", "tmpfs", 0, nullptr)); }},
      {"chroot", [] { return static_cast<long>(::chroot("/")); }},
      {"open_by_handle_at", [] { return call(SYS_open_by_handle_at, AT_FDCWD, 0, 0); }},
      {"openat2", [=] { return call(SYS_openat2, AT_FDCWD, reinterpret_cast<long>("/etc/passwd"), octets, 24); }},
      {"shmget", [] { return call(SYS_shmget, 0, 4096, 01600); }},
      {"setuid", [] { return call(SYS_setuid, 0); }},
      {"a new file", [this] { return static_cast<long>(::open(file("new").c_str(), O_WRONLY | O_CREAT, 0600)); }},
      {"a file that is cut short", [this] { return static_cast<long>(::open(file().c_str(), O_WRONLY | O_TRUNC)); }},
      {"truncate", [this] { return static_cast<long>(::truncate(file().c_str(), 0)); }},
      {"unlink", [this] { return static_cast<long>(::unlink(file().c_str())); }},
      {"rename", [this] { return static_cast<long>(::rename(file().c_str(), file("new").c_str())); }},
      {"a link", [this] { return static_cast<long>(::link(file().c_str(), file("new").c_str())); }},
      {"a symbolic link", [this] { return static_cast<long>(::symlink(file().c_str(), file("new").c_str())); }},
      {"mkdir", [this] { return static_cast<long>(::mkdir(file("new").c_str(), 0700)); }},
      {"chmod", [this] { return call(SYS_fchmodat, AT_FDCWD, reinterpret_cast<long>(file().c_str()), 0666); }},
      {"chown", [this] { return static_cast<long>(::chown(file().c_str(), 1, 1)); }},
      {"a device",
       [this] { return call(SYS_mknodat, AT_FDCWD, reinterpret_cast<long>(file("new").c_str()), 010600, 0); }},
  };
  if (!is_sanitized) {
    ways.emplace_back("ptrace", [] { return call(SYS_ptrace, PTRACE_TRACEME, 0, 0, 0); });
    ways.emplace_back("process_vm_readv", [=] { return call(SYS_process_vm_readv, parent, 0, 0, 0, 0); });
    ways.emplace_back("personality", [] { return call(SYS_personality, 0); });
    ways.emplace_back("memory to write and execute", [] {
      return call(SYS_mmap, 0, 4096, PROT_READ | PROT_WRITE | PROT_EXEC, MAP_PRIVATE | MAP_ANONYMOUS, -1);
    });
    ways.emplace_back("written memory to execute", [] {
      void* code = ::mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
      return static_cast<long>(::mprotect(code, 4096, PROT_READ | PROT_EXEC));
    });
  }
  for (const auto& [name, attempt] : ways) {
    const int error = inside(server(), [&] { return error_of(attempt()); });
    if (error == no_cage) GTEST_SKIP() << "this kernel has no seccomp";
    EXPECT_EQ(error, EACCES) << name;
  }
  EXPECT_EQ(fs::file_size(file()), 1U);
}

TEST_F(ServerCage, LeavesSocketsAndTheNamesOfHostsAndInterfaces) {
  const int status = inside(server(), [] {
    for (const int family : {AF_INET, AF_INET6, AF_UNIX}) {
      for (const int type : {SOCK_DGRAM, SOCK_STREAM})
        if (::socket(family, type | SOCK_CLOEXEC | SOCK_NONBLOCK, 0) < 0 && errno != EAFNOSUPPORT) return 1;
    }
    const int datagrams = ::socket(AF_INET, SOCK_DGRAM, 0);
    const int on = 1;
    sockaddr_in any{};
    any.sin_family = AF_INET;
    ip_mreqn group{};
    group.imr_multiaddr.s_addr = ::inet_addr("239.192.47.17");
    group.imr_ifindex = static_cast<int>(::if_nametoindex("lo"));
    if (group.imr_ifindex == 0) return 2;
    if (::bind(datagrams, reinterpret_cast<const sockaddr*>(&any), sizeof any) != 0) return 3;
    if (::setsockopt(datagrams, IPPROTO_IP, IP_PKTINFO, &on, sizeof on) != 0) return 4;
    const bool is_member = ::setsockopt(datagrams, IPPROTO_IP, IP_ADD_MEMBERSHIP, &group, sizeof group) == 0;
    if (!is_member && errno == EACCES) return 5;  // lo may have no multicast, which is not ours to ask
    ifaddrs* interfaces = nullptr;
    if (::getifaddrs(&interfaces) != 0) return 6;
    ::freeifaddrs(interfaces);
    addrinfo* found = nullptr;
    if (::getaddrinfo("localhost", nullptr, nullptr, &found) != 0) return 7;
    ::freeaddrinfo(found);
    const int no_name = ::getaddrinfo("no-such-host.invalid", nullptr, nullptr, &found);
    if (no_name == 0 || no_name == EAI_SYSTEM) return 8;
    if (::epoll_create1(EPOLL_CLOEXEC) < 0 || ::timerfd_create(CLOCK_MONOTONIC, TFD_CLOEXEC) < 0) return 9;
    return 0;
  });
  if (status == no_cage) GTEST_SKIP() << "this kernel has no seccomp";
  EXPECT_EQ(status, 0);
}

TEST_F(ServerCage, LeavesAChildThatIsInACageOfItsOwn) {
  Freedom child;
  child.may_become = true;
  child.may_read_all = true;
  const auto become = [&](const char* program, const char* word) {
    return inside(server(), [&] {
      std::thread([] {}).join();
      return in_child([&] {
        ::prctl(PR_SET_PDEATHSIG, SIGKILL);
        ::setpgid(0, 0);
        if (::open("/dev/null", O_RDWR) < 0) return 101;
        ::close_range(3, ~0U, 0);
        if (!close(child).by_system_calls) return 102;
        const char* arguments[] = {program, word, nullptr};
        ::execv(program, const_cast<char**>(arguments));
        return 103;
      });
    });
  };
  const int status = become("/bin/true", nullptr);
  if (status == no_cage) GTEST_SKIP() << "this kernel has no seccomp";
  EXPECT_EQ(status, 0);
  EXPECT_EQ(become("/bin/false", nullptr), 1);
  EXPECT_NE(become("/usr/bin/touch", file("new").c_str()), 0);
  EXPECT_FALSE(fs::exists(file("new")));
}

TEST_F(ServerCage, KillsAChildThatTakesTooLongAndLetsItAbort) {
  const auto end_of_child = [](const std::function<void()>& child, int signal) {
    return [child, signal] {
      const pid_t pid = ::fork();
      if (pid == 0) {
        child();
        ::_exit(0);
      }
      if (pid < 0) return 250;
      if (signal != 0 && ::kill(pid, signal) != 0) return 251;
      int status = 0;
      ::waitpid(pid, &status, 0);
      return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    };
  };
  const auto wait_forever = [] {
    std::array<int, 2> ends{};
    char octet = 0;
    if (::pipe(ends.data()) == 0) (void)!::read(ends[0], &octet, 1);
  };
  const int killed = inside(server(), end_of_child(wait_forever, SIGKILL));
  if (killed == no_cage) GTEST_SKIP() << "this kernel has no seccomp";
  EXPECT_EQ(killed, SIGKILL);
  const auto abort = [] {
    const rlimit none{0, 0};
    ::setrlimit(RLIMIT_CORE, &none);
    std::signal(SIGABRT, SIG_DFL);
    std::abort();
  };
  EXPECT_EQ(inside(server(), end_of_child(abort, 0)), SIGABRT);
}

TEST_F(ServerCage, WritesOnlyWhereItMay) {
  for (const char* name : {"copies", "socket", "other"}) {
    fs::create_directory(folder / name);
    std::ofstream(folder / name / "file") << "x";
  }
  Freedom freedom = server();
  freedom.rewritable.push_back(folder / "copies");
  freedom.removable_folders = {folder / "socket"};
  const auto error_in_cage = [&](const std::function<long()>& deed) {
    return in_child([&] {
      const Held held = close(freedom);
      return held.by_paths && held.by_system_calls ? error_of(deed()) : no_cage;
    });
  };
  const auto without_name = [&](const char* name) {
    return error_in_cage(
        [&] { return static_cast<long>(::open((folder / name).c_str(), O_TMPFILE | O_EXCL | O_RDWR, 0600)); });
  };
  const auto removal = [&](const char* name) {
    return error_in_cage([&] { return static_cast<long>(::unlink((folder / name / "file").c_str())); });
  };
  const int first = without_name("other");
  if (first == no_cage) GTEST_SKIP() << "this kernel has no Landlock";
  EXPECT_EQ(first, EACCES);
  const int allowed = without_name("copies");
  EXPECT_TRUE(allowed == 0 || allowed == EOPNOTSUPP) << allowed;
  EXPECT_EQ(without_name("socket"), EACCES);
  EXPECT_EQ(removal("copies"), EACCES);
  EXPECT_EQ(removal("other"), EACCES);
  EXPECT_EQ(removal("socket"), 0);
  for (const auto& [name, error] : {std::pair("copies/file", 0), std::pair("other/file", EACCES)}) {
    EXPECT_EQ(error_in_cage([&] { return static_cast<long>(::open((folder / name).c_str(), O_WRONLY)); }), error)
        << name;
    EXPECT_EQ(error_in_cage([&] { return static_cast<long>(::open((folder / name).c_str(), O_RDONLY)); }), 0) << name;
  }
}

TEST_F(ServerCage, SpeaksTcpToNameServersAloneAndListensNowhereElse) {
  if (landlock_version() < 4) GTEST_SKIP() << "Landlock decides about TCP since its version 4";
  const int other = inside(server(), [] { return connection_error(9); });
  if (other == no_cage) GTEST_SKIP() << "this kernel has no seccomp";
  EXPECT_EQ(other, EACCES);
  EXPECT_NE(inside(server(), [] { return connection_error(53); }), EACCES);
  EXPECT_EQ(inside(server(),
                   [] {
                     sockaddr_in any{};
                     any.sin_family = AF_INET;
                     return error_of(::bind(::socket(AF_INET, SOCK_STREAM, 0), reinterpret_cast<const sockaddr*>(&any),
                                            sizeof any));
                   }),
            EACCES);
}

TEST_F(ServerCage, OfATalkerHasSocketsFoldersWhereItMayAndNoPrograms) {
  Freedom talker;
  talker.may_talk = true;
  talker.writable_folders = {folder.string()};
  talker.may_make_folders = true;
  const auto listen_and_connect = [] {
    sockaddr_in any{};
    any.sin_family = AF_INET;
    const int listener = ::socket(AF_INET, SOCK_STREAM, 0);
    if (::bind(listener, reinterpret_cast<const sockaddr*>(&any), sizeof any) != 0 || ::listen(listener, 1) != 0)
      return errno;
    const int error = connection_error(9);
    return error == ECONNREFUSED ? 0 : error;
  };
  const int talked = inside(talker, listen_and_connect);
  if (talked == no_cage) GTEST_SKIP() << "this kernel has no seccomp";
  EXPECT_EQ(talked, 0);
  const std::string made = folder / "made";
  EXPECT_EQ(inside(talker, [&] { return error_of(::mkdir(made.c_str(), 0700)); }), 0);
  EXPECT_EQ(inside(talker, [&] { return error_of(::rename(made.c_str(), (folder / "other").c_str())); }), 0);
  EXPECT_EQ(inside(talker, [] { return error_of(::fork()); }), EACCES);
  EXPECT_EQ(inside(talker,
                   [] {
                     const char* arguments[] = {"true", nullptr};
                     return error_of(::execv("/bin/true", const_cast<char**>(arguments)));
                   }),
            EACCES);
  talker.may_make_folders = false;
  EXPECT_EQ(inside(talker, [&] { return error_of(::mkdir(made.c_str(), 0700)); }), EACCES);
  if (landlock_version() < 1) return;
  talker.may_make_folders = true;
  EXPECT_EQ(inside(talker, [] { return error_of(::mkdir("/tmp/geminga-talker", 0700)); }), EACCES);
}

TEST_F(ServerCage, LooksIntoNoOtherProcess) {
  if (landlock_version() < 1) GTEST_SKIP() << "this kernel has no Landlock";
  const std::string process = "/proc/" + std::to_string(::getpid());
  for (const char* name : {"/mem", "/environ", "/maps"}) {
    const int error = inside(server(), [&] {
      const int opened = ::open((process + name).c_str(), O_RDONLY);
      std::array<char, 16> octets{};
      return error_of(opened < 0 ? opened : ::read(opened, octets.data(), octets.size()));
    });
    if (error == no_cage) GTEST_SKIP() << "this kernel has no seccomp";
    EXPECT_TRUE(error == EACCES || error == EPERM) << name << ": " << error;
  }
}

TEST_F(ServerCage, ReachesNoOtherProcess) {
  if (landlock_version() < 6) GTEST_SKIP() << "Landlock decides about signals since its version 6";
  const pid_t other = ::fork();
  if (other == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    while (true) ::pause();
  }
  const int error = inside(server(), [&] { return error_of(::kill(other, SIGKILL)); });
  const int alive = ::kill(other, 0);
  ::kill(other, SIGKILL);
  ::waitpid(other, nullptr, 0);
  if (error == no_cage) GTEST_SKIP() << "this kernel has no seccomp";
  EXPECT_EQ(error, EPERM);
  EXPECT_EQ(alive, 0);
}

TEST_F(ServerCage, OfRootHasNoCapabilitiesButToReadFilesAndToUseLowPorts) {
  if (::geteuid() != 0) GTEST_SKIP() << "nobody but root has any";
  const int status = inside(server(), [] {
    std::ifstream text("/proc/self/status");
    std::string line;
    while (std::getline(text, line)) {
      if (!line.starts_with("CapEff:")) continue;
      constexpr unsigned long long allowed = 1U << 2U | 1U << 10U;  // CAP_DAC_READ_SEARCH, CAP_NET_BIND_SERVICE
      return (std::stoull(line.substr(8), nullptr, 16) & ~allowed) == 0 ? 0 : 1;
    }
    return 2;
  });
  if (status == no_cage) GTEST_SKIP() << "this kernel has no seccomp";
  EXPECT_EQ(status, 0);
}

}  // namespace
}  // namespace geminga::cage
