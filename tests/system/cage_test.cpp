// The cage of a real daemon: closed around all its threads, and open to whatever a reload may ask for.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <set>

#include "support/lab.hpp"
#include "system/folder.hpp"
#include "system/kernel_without.hpp"

namespace geminga::system {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// The values of this line of /proc/PID/task/*/status over all threads.
std::set<std::string> of_threads(pid_t pid, const std::string& key) {
  std::set<std::string> values;
  for (const auto& thread : fs::directory_iterator("/proc/" + std::to_string(pid) + "/task")) {
    std::ifstream status(thread.path() / "status");
    for (std::string line; std::getline(status, line);) {
      if (line.starts_with(key + ":\t")) values.insert(line.substr(key.size() + 2));
    }
  }
  return values;
}

bool has_landlock() { return ::syscall(landlock_create_ruleset, nullptr, 0, 1) > 0; }

std::string cage_of(Talk& talk) {
  const auto status = talk.query("status");
  return status.size() == 1 ? field(status[0], "cage") : "";
}

/// A daemon on the first host, on a kernel that lacks something.
struct Poorer {
  Poorer(Lab& lab, const std::string& wish, const std::function<void()>& take)
      : process([&] {
          auto start = lab.on(0, {program("gemingad"), "--interface", lab.interface_of(0), "--cage", wish, "--gcnp",
                                  "127.0.0.1:" + std::to_string(lab.gcnp_port(0))});
          start.before = [enter = start.before, take] {
            if (enter) enter();
            take();
          };
          return start;
        }()) {}
  Process process;
};

TEST(Cage, IsClosedAroundEveryThreadOfTheDaemon) {
  const Folder folder;
  Lab lab(1);
  lab.start(0, {"--peer", "localhost", "--ontology", folder.write("zoo.ttl", animals)});
  lab.daemon(0).signal(SIGHUP);  // it compiles once more
  ASSERT_TRUE(lab.daemon(0).wait_for("is in force")) << lab.daemon(0).said();
  EXPECT_THAT(lab.daemon(0).said(), HasSubstr(has_landlock() ? "in its cage: system calls by seccomp, files by Landlock"
                                                             : "this kernel has no Landlock"));
  const pid_t pid = lab.daemon(0).pid();
  EXPECT_THAT(of_threads(pid, "NoNewPrivs"), testing::ElementsAre("1"));
  EXPECT_THAT(of_threads(pid, "Seccomp"), testing::ElementsAre("2"));
  constexpr unsigned long long allowed = 1U << 2U | 1U << 10U;  // CAP_DAC_READ_SEARCH, CAP_NET_BIND_SERVICE
  for (const std::string& capabilities : of_threads(pid, "CapPrm"))
    EXPECT_EQ(std::stoull(capabilities, nullptr, 16) & ~allowed, 0U) << capabilities;
  Talk talk = lab.talk(0);
  EXPECT_EQ(cage_of(talk), has_landlock() ? "calls,files" : "calls");
}

TEST(Cage, LeavesAllThatAReloadMayAskFor) {
  const Folder started;
  const Folder later;  // nothing of it is known when the cage is closed
  const std::string file = started.write("geminga.toml", "interval = 0.1\n");
  Lab lab(1);
  const std::string socket = started.path("gcnp.socket");
  lab.start(0, {"--config", file, "--gcnp-socket", socket, "--state-folder", started.path("state")});
  const auto reload = [&](const std::string& text, const std::string& said) {
    (void)started.write("geminga.toml", "interval = 0.1\n" + text);
    lab.daemon(0).forget();
    lab.daemon(0).signal(SIGHUP);
    return lab.daemon(0).wait_for(said);
  };
  const std::string zoo = later.write("zoo.ttl", animals);
  EXPECT_TRUE(reload("ontology = \"" + zoo + "\"\n", "is in force")) << lab.daemon(0).said();
  const std::string compiled = later.path("zoo.geminga");
  ASSERT_EQ(
      run({.words = {program("geminga-ontology"), "compile", zoo, "-o", compiled}, .environment = {}, .before = {}})
          .status,
      0);
  EXPECT_TRUE(reload("ontology = \"" + compiled + "\"\n", "is in force")) << lab.daemon(0).said();
  const std::string key = later.path("team.key");
  ASSERT_EQ(refused({"--generate-key", key}).status, 0);
  EXPECT_TRUE(reload("key-file = \"" + key + "\"\n", "announcements: encrypted")) << lab.daemon(0).said();
  // Sockets of another port and group, and names, which are resolved one after the other.
  const std::string air = "key-file = \"" + key + "\"\nport = 4999\nmulticast = \"239.192.47.99\"\n";
  EXPECT_TRUE(reload(air + "peer = [\"localhost\", \"no-such-host.invalid\"]\n", "cannot be resolved: Host not found"))
      << lab.daemon(0).said();
  EXPECT_THAT(lab.daemon(0).said(),
              AllOf(HasSubstr("peer no-such-host.invalid"), Not(HasSubstr("peer localhost:4999 cannot be resolved")),
                    Not(HasSubstr("Permission denied"))));
  EXPECT_TRUE(reload(air + "log-format = \"json\"\n", "{\"time\":")) << lab.daemon(0).said();
  lab.daemon(0).signal(SIGTERM);
  EXPECT_EQ(lab.daemon(0).wait(), 0);
  EXPECT_FALSE(fs::exists(socket)) << "it removes its socket";
  EXPECT_TRUE(fs::exists(started.path("state/identity")));
}

TEST(Cage, IsGoneWithoutWhereTheKernelHasNoneUnlessItIsRequired) {
  struct Case {
    const char* lacks;
    std::function<void()> take;
    std::string left;
  };
  const std::vector<Case> cases{
      {"no Landlock", [] { take_away(landlock_create_ruleset); }, "calls"},
      {"no seccomp", [] { take_away(SYS_seccomp, PR_SET_SECCOMP); }, has_landlock() ? "files" : "none"}};
  for (const auto& [lacks, take, left] : cases) {
    Lab lab(1);
    {
      Poorer daemon(lab, "wanted", take);
      ASSERT_TRUE(daemon.process.wait_for("ready: ")) << daemon.process.said();
      EXPECT_THAT(daemon.process.said(), AllOf(HasSubstr("warn"), HasSubstr(lacks)));
      Talk talk = lab.talk(0);
      EXPECT_EQ(cage_of(talk), left);
    }
    Poorer daemon(lab, "required", take);
    EXPECT_EQ(daemon.process.wait(), 2);
    EXPECT_THAT(daemon.process.said(),
                AllOf(HasSubstr("gemingad: this kernel has "), HasSubstr(lacks), HasSubstr("say cage = \"wanted\"")));
  }
}

TEST(Cage, StaysOpenWhereTheOwnerSaysSo) {
  Lab lab(1);
  lab.start(0, {"--cage", "none"});
  EXPECT_THAT(lab.daemon(0).said(), HasSubstr("in no cage"));
  EXPECT_THAT(of_threads(lab.daemon(0).pid(), "Seccomp"), testing::ElementsAre("0"));
  Talk talk = lab.talk(0);
  EXPECT_EQ(cage_of(talk), "none");
}

}  // namespace
}  // namespace geminga::system
