// A kernel that lacks a part of the cage, played by a filter around the program.
#ifndef GEMINGA_TESTS_SYSTEM_KERNEL_WITHOUT_HPP
#define GEMINGA_TESTS_SYSTEM_KERNEL_WITHOUT_HPP

#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>

namespace geminga::system {

inline constexpr std::uint32_t landlock_create_ruleset = 444;

/// Lets one system call fail in this process and in its successors as if the kernel did not know it, and prctl() with
/// `option` as if it did not know that, unless the option is 0.
inline void take_away(std::uint32_t call, std::uint32_t option = 0) {
  const std::uint32_t number = offsetof(seccomp_data, nr);
  const std::uint32_t argument = offsetof(seccomp_data, args);
  sock_filter filter[] = {
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, number),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, call, 5, 0),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_prctl, 0, 3),
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, argument),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, option == 0 ? UINT32_MAX : option, 0, 1),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EINVAL),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | ENOSYS),
  };
  const sock_fprog program{sizeof filter / sizeof *filter, filter};
  ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  if (::syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, 0, &program) != 0) ::_exit(99);
}

}  // namespace geminga::system

#endif
