#include "ontology/command/limits.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <functional>

#include "ontology/command/exit_status.hpp"

namespace geminga::ontology {
namespace {

/// The exit status of a child that runs this and exits with the result.
int in_child(const std::function<int()>& deed) {
  const pid_t child = fork();
  if (child == 0) _exit(deed());
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

TEST(Limits, TheTimeLimitEndsTheProgramWithItsOwnStatus) {
  EXPECT_EQ(in_child([] {
              limit_time(1);
              // A call into a library, without which ThreadSanitizer never hands the signal on.
              for (;;) (void)std::chrono::steady_clock::now();
              return 0;
            }),
            static_cast<int>(Exit::timed_out));
}

TEST(Limits, TheMemoryLimitIsSet) {
  EXPECT_EQ(in_child([] {
              limit_memory(4096);
              rlimit limit{};
              getrlimit(RLIMIT_AS, &limit);
              return limit.rlim_cur == rlim_t{4096} << 20U ? 0 : 1;
            }),
            0);
}

TEST(Limits, OfTriplesAreThoseThatAreNamedElseHalfOfTheMemoryElseOneGibibyte) {
  constexpr std::size_t mebibyte = std::size_t{1} << 20U;
  WorkLimits limits;
  EXPECT_EQ(graph_octets(limits), 1024 * mebibyte);
  limits.memory_mib = 512;
  EXPECT_EQ(graph_octets(limits), 256 * mebibyte);
  limits.graph_mib = 5;
  EXPECT_EQ(graph_octets(limits), 5 * mebibyte);
}

}  // namespace
}  // namespace geminga::ontology
