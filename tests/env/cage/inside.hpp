// Deeds in a child that closes a cage around itself first.
#ifndef GEMINGA_TESTS_ENV_CAGE_INSIDE_HPP
#define GEMINGA_TESTS_ENV_CAGE_INSIDE_HPP

#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <functional>

#include "env/cage/cage.hpp"

namespace geminga::cage {

inline constexpr int no_cage = 200;  ///< the status of a child on a system without a cage

/// The exit status of a child that does this, or 1000 + N if signal N ended it.
inline int in_child(const std::function<int()>& deed) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(deed());
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
}

/// The same within a cage.
inline int inside(const Freedom& freedom, const std::function<int()>& deed) {
  return in_child([&] { return close(freedom).by_system_calls ? deed() : no_cage; });
}

inline int error_of(long result) { return result < 0 ? errno : 0; }

inline long call(long number, long a = 0, long b = 0, long c = 0, long d = 0, long e = 0) {
  return ::syscall(number, a, b, c, d, e);
}

}  // namespace geminga::cage

#endif
