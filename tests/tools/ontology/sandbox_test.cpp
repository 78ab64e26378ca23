// What the program can no longer do once it has forbidden itself the world.
#include "sandbox.hpp"

#include <gtest/gtest.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <functional>

#include "command.hpp"

namespace geminga::ontology {
namespace {

/// The exit status of a child that does this and exits with what it returns.
int in_child(const std::function<int()>& deed) {
  const pid_t child = fork();
  if (child == 0) _exit(deed());
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

int error_of(long result) { return result < 0 ? errno : 0; }

TEST(Sandbox, SocketsTracesAndOtherProgramsAreForbidden) {
  const auto run_true = [] {
    const char* arguments[] = {"true", nullptr};
    return error_of(execv("/bin/true", const_cast<char**>(arguments)));
  };
  for (const int domain : {AF_INET, AF_INET6, AF_UNIX, AF_NETLINK}) {
    EXPECT_EQ(in_child([&] {
                forbid_the_world(false);
                return error_of(socket(domain, SOCK_STREAM, 0));
              }),
              EACCES)
        << "domain " << domain;
  }
  EXPECT_EQ(in_child([] {
              forbid_the_world(false);
              return error_of(ptrace(PTRACE_TRACEME, 0, nullptr, nullptr));
            }),
            may_trace ? 0 : EACCES);
  EXPECT_EQ(in_child([&] {
              forbid_the_world(false);
              return run_true();
            }),
            EACCES);
  EXPECT_EQ(in_child([&] {
              forbid_the_world(true);
              return run_true();
            }),
            0);
}

TEST(Sandbox, TheTimeLimitEndsTheProgramWithItsOwnStatus) {
  EXPECT_EQ(in_child([] {
              limit_time(1);
              for (volatile unsigned spin = 0;;) spin = spin + 1;
              return 0;
            }),
            static_cast<int>(Exit::timed_out));
}

TEST(Sandbox, TheMemoryLimitIsSet) {
  EXPECT_EQ(in_child([] {
              limit_memory(4096);
              rlimit limit{};
              getrlimit(RLIMIT_AS, &limit);
              return limit.rlim_cur == rlim_t{4096} << 20U ? 0 : 1;
            }),
            0);
}

}  // namespace
}  // namespace geminga::ontology
