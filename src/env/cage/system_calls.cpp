// The list of the system calls that reading, reasoning and writing need.
#include "env/cage/system_calls.hpp"

#include <fcntl.h>
#include <linux/netlink.h>
#include <linux/sockios.h>
#include <netinet/in.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <initializer_list>
#include <span>

namespace geminga::cage {
namespace {

/// With any arguments these reach nothing but this process, its open files, and what it may read. Those that an
/// architecture does not have are passed over.
constexpr std::array plain{
    // files
    SCMP_SYS(read), SCMP_SYS(readv), SCMP_SYS(pread64), SCMP_SYS(write), SCMP_SYS(writev), SCMP_SYS(pwrite64),
    SCMP_SYS(lseek), SCMP_SYS(close), SCMP_SYS(dup), SCMP_SYS(dup2), SCMP_SYS(dup3), SCMP_SYS(pipe), SCMP_SYS(pipe2),
    SCMP_SYS(stat), SCMP_SYS(lstat), SCMP_SYS(fstat), SCMP_SYS(newfstatat), SCMP_SYS(statx), SCMP_SYS(statfs),
    SCMP_SYS(fstatfs), SCMP_SYS(access), SCMP_SYS(faccessat), SCMP_SYS(faccessat2), SCMP_SYS(readlink),
    SCMP_SYS(readlinkat), SCMP_SYS(getdents64), SCMP_SYS(getcwd), SCMP_SYS(umask), SCMP_SYS(fadvise64),
    SCMP_SYS(memfd_create), SCMP_SYS(ftruncate), SCMP_SYS(copy_file_range), SCMP_SYS(poll), SCMP_SYS(ppoll),
    // memory and threads
    SCMP_SYS(munmap), SCMP_SYS(mremap), SCMP_SYS(madvise), SCMP_SYS(brk), SCMP_SYS(futex), SCMP_SYS(set_robust_list),
    SCMP_SYS(rseq), SCMP_SYS(set_tid_address), SCMP_SYS(sched_yield), SCMP_SYS(sched_getaffinity), SCMP_SYS(exit),
    SCMP_SYS(exit_group),
    // itself
    SCMP_SYS(rt_sigaction), SCMP_SYS(rt_sigprocmask), SCMP_SYS(rt_sigreturn), SCMP_SYS(sigaltstack),
    SCMP_SYS(restart_syscall), SCMP_SYS(getpid), SCMP_SYS(getppid), SCMP_SYS(gettid), SCMP_SYS(getuid),
    SCMP_SYS(geteuid), SCMP_SYS(getgid), SCMP_SYS(getegid), SCMP_SYS(getpgrp), SCMP_SYS(getrlimit), SCMP_SYS(setrlimit),
    SCMP_SYS(getrusage), SCMP_SYS(times), SCMP_SYS(uname), SCMP_SYS(sysinfo), SCMP_SYS(getrandom), SCMP_SYS(wait4),
    SCMP_SYS(capget), SCMP_SYS(capset),
    // time
    SCMP_SYS(clock_gettime), SCMP_SYS(clock_getres), SCMP_SYS(gettimeofday), SCMP_SYS(time), SCMP_SYS(clock_nanosleep),
    SCMP_SYS(setitimer),
    // a narrower cage
    SCMP_SYS(seccomp), SCMP_SYS(landlock_create_ruleset), SCMP_SYS(landlock_add_rule),
    SCMP_SYS(landlock_restrict_self)};

constexpr std::array to_become{SCMP_SYS(execve), SCMP_SYS(arch_prctl)};
constexpr std::array to_write_files{SCMP_SYS(open),      SCMP_SYS(openat), SCMP_SYS(rename),   SCMP_SYS(renameat),
                                    SCMP_SYS(renameat2), SCMP_SYS(unlink), SCMP_SYS(unlinkat), SCMP_SYS(fchmod)};
constexpr std::array to_make_folders{SCMP_SYS(mkdir), SCMP_SYS(mkdirat), SCMP_SYS(rmdir), SCMP_SYS(fsync)};
constexpr std::array to_be_sanitized{
    SCMP_SYS(mmap),           SCMP_SYS(getdents),          SCMP_SYS(mprotect),   SCMP_SYS(ptrace),
    SCMP_SYS(prctl),          SCMP_SYS(personality),       SCMP_SYS(arch_prctl), SCMP_SYS(process_vm_readv),
    SCMP_SYS(sched_getparam), SCMP_SYS(sched_getscheduler)};

/// Calls without a look at their arguments: what is done with sockets, and waiting for many things at once.
constexpr std::array to_talk{
    // sockets
    SCMP_SYS(bind), SCMP_SYS(listen), SCMP_SYS(accept), SCMP_SYS(accept4), SCMP_SYS(connect), SCMP_SYS(shutdown),
    SCMP_SYS(getsockname), SCMP_SYS(getpeername), SCMP_SYS(getsockopt), SCMP_SYS(send), SCMP_SYS(sendto),
    SCMP_SYS(sendmsg), SCMP_SYS(sendmmsg), SCMP_SYS(recv), SCMP_SYS(recvfrom), SCMP_SYS(recvmsg), SCMP_SYS(recvmmsg),
    // waiting
    SCMP_SYS(epoll_create), SCMP_SYS(epoll_create1), SCMP_SYS(epoll_ctl), SCMP_SYS(epoll_wait), SCMP_SYS(epoll_pwait),
    SCMP_SYS(epoll_pwait2), SCMP_SYS(eventfd2), SCMP_SYS(timerfd_create), SCMP_SYS(timerfd_settime),
    SCMP_SYS(timerfd_gettime), SCMP_SYS(select), SCMP_SYS(pselect6), SCMP_SYS(signalfd4), SCMP_SYS(rt_sigpending),
    // files and memory
    SCMP_SYS(fallocate), SCMP_SYS(getcpu), SCMP_SYS(membarrier)};
/// Calls of a server beside these.
constexpr std::array to_serve{// the child that compiles the ontology
                              SCMP_SYS(execve),      SCMP_SYS(arch_prctl), SCMP_SYS(setpgid),
                              SCMP_SYS(close_range), SCMP_SYS(waitid),     SCMP_SYS(pidfd_open)};
constexpr std::array to_remove_files{SCMP_SYS(unlink), SCMP_SYS(unlinkat)};

class Filter {
 public:
  Filter() : context_(seccomp_init(SCMP_ACT_ERRNO(EACCES))) {}
  ~Filter() {
    if (context_ != nullptr) seccomp_release(context_);
  }
  Filter(const Filter&) = delete;
  Filter& operator=(const Filter&) = delete;

  void allow(std::span<const int> calls) {
    for (const int call : calls) seccomp_rule_add(context_, SCMP_ACT_ALLOW, call, 0);
  }
  void allow(int call, scmp_arg_cmp argument) { seccomp_rule_add(context_, SCMP_ACT_ALLOW, call, 1, argument); }
  void allow(int call, std::initializer_list<scmp_arg_cmp> arguments) {
    seccomp_rule_add_array(context_, SCMP_ACT_ALLOW, call, static_cast<unsigned>(arguments.size()), arguments.begin());
  }
  /// Fails as if the kernel did not know the call, so that the C library takes an older one.
  void hide(int call) { seccomp_rule_add(context_, SCMP_ACT_ERRNO(ENOSYS), call, 0); }
  /// From here on rules are for this processor alone. Call it before the first rule.
  void translate_to(std::uint32_t processor) {
    if (seccomp_arch_native() == processor) return;
    seccomp_arch_add(context_, processor);
    seccomp_arch_remove(context_, seccomp_arch_native());
  }
  [[nodiscard]] bool load() { return context_ != nullptr && seccomp_load(context_) == 0; }
  /// Writes the program; false: there was not enough memory, or the file could not be written.
  [[nodiscard]] bool write(int file) { return context_ != nullptr && seccomp_export_bpf(context_, file) == 0; }

 private:
  scmp_filter_ctx context_;
};

scmp_arg_cmp equals(unsigned argument, std::uint64_t value) { return {argument, SCMP_CMP_EQ, value, 0}; }
scmp_arg_cmp masked(unsigned argument, std::uint64_t mask, std::uint64_t value) {
  return {argument, SCMP_CMP_MASKED_EQ, mask, value};
}

/// Allows threads, but no namespaces, and processes to a server alone. clone3() has its flags in memory, where no
/// filter sees them.
void allow_threads(Filter& filter, bool may_serve) {
  constexpr std::uint64_t namespaces =
      CLONE_NEWNS | CLONE_NEWUTS | CLONE_NEWIPC | CLONE_NEWUSER | CLONE_NEWPID | CLONE_NEWNET | CLONE_NEWCGROUP;
  filter.allow(SCMP_SYS(clone), masked(0, CLONE_THREAD | CLONE_VM | namespaces, CLONE_THREAD | CLONE_VM));
  if (may_serve) {
    filter.allow(SCMP_SYS(clone), masked(0, CLONE_VM | namespaces, 0));
    filter.allow(std::array{SCMP_SYS(fork)});
  }
  filter.hide(SCMP_SYS(clone3));
  // The tracer that looks for leaks shares our memory, and is not traced itself.
  constexpr std::uint64_t tracer = CLONE_VM | CLONE_UNTRACED;
  if (is_sanitized) filter.allow(SCMP_SYS(clone), masked(0, tracer | namespaces, tracer));
}

/// Allows to open files for reading; a server may write into what is there, and make a file without a name.
void allow_opening(Filter& filter, bool may_serve) {
  constexpr std::uint64_t making = O_CREAT | O_TRUNC | O_APPEND;
  constexpr std::uint64_t writing = O_WRONLY | O_RDWR | making;
  const std::uint64_t forbidden = may_serve ? making : writing;
  filter.allow(SCMP_SYS(open), masked(1, forbidden, 0));
  filter.allow(SCMP_SYS(openat), masked(2, forbidden, 0));
}

/// Allows signals and limits for the own process only: abort() sends a signal to itself.
void allow_on_itself(Filter& filter) {
  const auto self = static_cast<std::uint64_t>(::getpid());
  filter.allow(SCMP_SYS(tgkill), equals(0, self));
  filter.allow(SCMP_SYS(kill), equals(0, self));
  filter.allow(SCMP_SYS(prlimit64), equals(0, 0));
  filter.allow(SCMP_SYS(prlimit64), equals(0, self));
  for (const int option : {PR_SET_NO_NEW_PRIVS, PR_SET_SECCOMP, PR_GET_SECCOMP, PR_SET_NAME, PR_CAPBSET_READ})
    filter.allow(SCMP_SYS(prctl), equals(0, static_cast<std::uint64_t>(option)));
}

/// Allows commands on descriptors, except those that send signals to an owner or input to a terminal.
void allow_on_descriptors(Filter& filter) {
  for (const int command : {F_DUPFD, F_DUPFD_CLOEXEC, F_GETFD, F_SETFD, F_GETFL})
    filter.allow(SCMP_SYS(fcntl), equals(1, static_cast<std::uint64_t>(command)));
  for (const unsigned long request : {static_cast<unsigned long>(TCGETS), static_cast<unsigned long>(TIOCGWINSZ)})
    filter.allow(SCMP_SYS(ioctl), equals(1, request));
}

/// Forbids executable memory that was ever writable, so that only code that was there before runs. A server maps the
/// libraries of its child, and those by which names are resolved, for executing only.
void allow_memory(Filter& filter, const Freedom& freedom) {
  if (freedom.may_become) return filter.allow(std::array{SCMP_SYS(mmap), SCMP_SYS(mprotect)});
  filter.allow(SCMP_SYS(mmap), masked(2, PROT_EXEC, 0));
  if (freedom.may_serve) filter.allow(SCMP_SYS(mmap), masked(2, PROT_EXEC | PROT_WRITE, PROT_EXEC));
  filter.allow(SCMP_SYS(mprotect), masked(2, PROT_EXEC, 0));
}

/// Allows sockets of UDP, TCP, this host, and the kernel's news of interfaces; no raw ones, and none of any other
/// family.
void allow_sockets(Filter& filter) {
  constexpr std::uint64_t kind = 0xf;  // beside it are SOCK_CLOEXEC and SOCK_NONBLOCK
  for (const int call : {SCMP_SYS(socket), SCMP_SYS(socketpair)}) filter.allow(call, equals(0, AF_UNIX));
  for (const std::uint64_t family : {std::uint64_t{AF_INET}, std::uint64_t{AF_INET6}}) {
    for (const std::uint64_t protocol : {std::uint64_t{0}, std::uint64_t{IPPROTO_TCP}})
      filter.allow(SCMP_SYS(socket), {equals(0, family), masked(1, kind, SOCK_STREAM), equals(2, protocol)});
    for (const std::uint64_t protocol : {std::uint64_t{0}, std::uint64_t{IPPROTO_UDP}})
      filter.allow(SCMP_SYS(socket), {equals(0, family), masked(1, kind, SOCK_DGRAM), equals(2, protocol)});
  }
  filter.allow(SCMP_SYS(socket), {equals(0, AF_NETLINK), equals(2, NETLINK_ROUTE)});
  for (const int level : {SOL_SOCKET, int{IPPROTO_IP}, int{IPPROTO_IPV6}, int{IPPROTO_TCP}, int{IPPROTO_UDP}})
    filter.allow(SCMP_SYS(setsockopt), equals(1, static_cast<std::uint64_t>(level)));
  for (const int request : {FIONBIO, FIONREAD, SIOCGIFNAME, SIOCGIFINDEX, SIOCGIFFLAGS, SIOCGIFMTU})
    filter.allow(SCMP_SYS(ioctl), equals(1, static_cast<std::uint64_t>(request)));
  filter.allow(SCMP_SYS(fcntl), equals(1, F_SETFL));
}

/// Allows to end a child, and the child to end itself by abort(): its number is not known yet.
void allow_children(Filter& filter) {
  filter.allow(SCMP_SYS(kill), equals(1, SIGKILL));
  filter.allow(SCMP_SYS(tgkill), equals(2, SIGABRT));
  for (const int option : {PR_SET_PDEATHSIG, PR_GET_DUMPABLE, PR_SET_DUMPABLE})
    filter.allow(SCMP_SYS(prctl), equals(0, static_cast<std::uint64_t>(option)));
}

void add_rules(Filter& filter, const Freedom& freedom) {
  filter.allow(plain);
  allow_threads(filter, freedom.may_serve);
  allow_opening(filter, freedom.may_serve);
  allow_on_itself(filter);
  allow_on_descriptors(filter);
  allow_memory(filter, freedom);
  if (freedom.may_become) filter.allow(to_become);
  if (freedom.may_talk || freedom.may_serve) {
    filter.allow(to_talk);
    allow_sockets(filter);
  }
  if (freedom.may_serve) {
    filter.allow(to_serve);
    allow_children(filter);
  }
  if (!freedom.removable_folders.empty()) filter.allow(to_remove_files);
  if (!freedom.writable_folders.empty()) filter.allow(to_write_files);
  if (freedom.may_make_folders) filter.allow(to_make_folders);
  if (is_sanitized) filter.allow(to_be_sanitized);
}

}  // namespace

bool restrict_system_calls(const Freedom& freedom) {
  Filter filter;
  add_rules(filter, freedom);
  return filter.load();
}

bool write_filter(const Freedom& freedom, Processor processor, int file) {
  Filter filter;
  filter.translate_to(processor == Processor::aarch64 ? SCMP_ARCH_AARCH64 : SCMP_ARCH_X86_64);
  add_rules(filter, freedom);
  return filter.write(file);
}

}  // namespace geminga::cage
