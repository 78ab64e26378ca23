// tools/demo as a careless user runs it: its team lives until it is stopped, and then nothing is left.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "support/process.hpp"

namespace geminga::tools {
namespace {

namespace fs = std::filesystem;
using system::Process;
using system::Ran;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

/// A user of tools/demo with a runtime folder of its own, which marks every process of its team.
class Demo : public testing::Test {
 protected:
  Demo() {
    const fs::path temporary = fs::temp_directory_path();
    // Hosts on the loopback interface have ports of their own, and every team uses the same ports.
    const fs::path alone = temporary / ("geminga-demo-test-" + std::to_string(::getuid()) + ".lock");
    alone_ = ::open(alone.c_str(), O_CREAT | O_RDWR | O_CLOEXEC | O_NOFOLLOW, 0600);
    EXPECT_EQ(::flock(alone_, LOCK_EX), 0);
    std::string path = temporary / "geminga-demo-test-XXXXXX";
    if (::mkdtemp(path.data()) != nullptr) folder_ = path;
  }
  ~Demo() override {
    (void)demo({"--stop"});
    for (const pid_t process : left()) ::kill(process, SIGKILL);
    fs::remove_all(folder_);
    ::close(alone_);
  }

  [[nodiscard]] Process::Start start(std::vector<std::string> words) const {
    words.insert(words.begin(), GEMINGA_SOURCE_DIR "/tools/demo");
    return {.words = std::move(words),
            .environment = {{"XDG_RUNTIME_DIR", folder_}, {"GEMINGA_DEMO_PROGRAMS", GEMINGA_BINARY_DIR "/bin"}},
            .before = {}};
  }
  [[nodiscard]] Ran demo(std::vector<std::string> words) const { return system::run(start(std::move(words))); }

  /// Waits until the team's process of that name has said `text`.
  [[nodiscard]] bool is_logged(const std::string& name, const std::string& text) const {
    const std::string log = folder_ + "/geminga-demo-" + std::to_string(::getuid()) + "/log/" + name;
    // It polls: with inotify tail never reads a file that comes to be between its first look and its watch.
    const std::vector<std::string> words{"/usr/bin/tail", "---disable-inotify", "-s", "0.1", "-F", log};
    Process reader({.words = words, .environment = {}, .before = {}});
    return reader.wait_for(text);
  }
  /// The processes with the folder in their environment.
  [[nodiscard]] std::vector<pid_t> left() const {
    std::vector<pid_t> found;
    for (const auto& entry : fs::directory_iterator("/proc")) {
      const pid_t process = std::atoi(entry.path().filename().c_str());
      if (process <= 0) continue;
      std::ifstream file(entry.path() / "environ");
      const std::string environment{std::istreambuf_iterator<char>(file), {}};
      if (environment.contains("XDG_RUNTIME_DIR=" + folder_)) found.push_back(process);
    }
    return found;
  }
  void expect_nothing_left() const {
    EXPECT_THAT(left(), IsEmpty());
    EXPECT_TRUE(fs::is_empty(folder_)) << "files are left";
  }

  std::string folder_;
  int alone_ = -1;
};

TEST_F(Demo, KeepsTheTeamUntilItIsStoppedAsTheReadmeSays) {
  Process keep(start({"--keep"}));
  ASSERT_TRUE(keep.wait_for("The team goes on")) << keep.said();
  EXPECT_EQ(keep.wait(), 0) << "the terminal is given back: " << keep.said();
  EXPECT_THAT(keep.said(), HasSubstr("shows the team in a browser"));
  EXPECT_THAT(keep.said(), HasSubstr("sar:LimbSighting is at 3.00 2.00 on the field"))
      << "the other team is understood";

  const Ran unmatched = demo({"--in", "monitor", "geminga-query", "requests", "--unmatched"});
  EXPECT_EQ(unmatched.status, 0);
  EXPECT_THAT(unmatched.said, HasSubstr("soccer:RefereeBoxInfo"));
  const Ran robot = demo({"--in", "robot6", "geminga-query", "participants"});
  EXPECT_THAT(robot.said, HasSubstr("monitor"));
  const Ran rescue = demo({"--in", "rescue1", "geminga-query", "participants"});
  EXPECT_THAT(rescue.said, HasSubstr("robot1"));
  const Ran nowhere = demo({"--in", "robot7", "true"});
  EXPECT_EQ(nowhere.status, 2);
  EXPECT_THAT(nowhere.said, StartsWith("demo: there is no host 'robot7': use one of: monitor rescue1 robot1 "));
  for (const std::vector<std::string>& words : {std::vector<std::string>{"--keep"}, {}}) {
    const Ran again = demo(words);
    EXPECT_EQ(again.status, 1);
    EXPECT_THAT(again.said, StartsWith("demo: a team is running already: "));
  }
  EXPECT_EQ(demo({"--in", "monitor", "geminga-query", "participants"}).status, 0) << "the first team does not notice";

  const Ran stop = demo({"--stop"});
  EXPECT_EQ(stop.status, 0) << stop.said;
  expect_nothing_left();
  for (const std::vector<std::string>& words : {std::vector<std::string>{"--stop"}, {"--in", "monitor", "true"}}) {
    const Ran none = demo(words);
    EXPECT_EQ(none.status, 1);
    EXPECT_EQ(none.said, "demo: no team is running: start one with tools/demo --keep\n");
  }
}

TEST_F(Demo, LeavesNothingWhenItIsInterrupted) {
  for (const std::vector<std::string>& words : {std::vector<std::string>{"--keep"}, {}, {"--lo"}}) {
    for (const std::string moment : {"Seven", "modules start", "switched off"}) {
      Process interrupted(start(words));
      const bool is_there = interrupted.wait_for(moment);
      if (interrupted.said().contains("already in use")) GTEST_SKIP() << "somebody's team is on the loopback interface";
      ASSERT_TRUE(is_there) << interrupted.said();
      if (moment == "switched off") {
        ASSERT_TRUE(is_logged("watcher", "robot4"));
      }
      interrupted.signal(SIGINT);
      EXPECT_EQ(interrupted.wait(), 130) << moment << ": " << interrupted.said();
      expect_nothing_left();
    }
  }
}

TEST_F(Demo, ClearsWhatAKilledTeamLeft) {
  Process killed(start({}));
  ASSERT_TRUE(killed.wait_for("modules start")) << killed.said();
  killed.signal(SIGKILL);
  EXPECT_EQ(killed.wait(), 128 + SIGKILL);
  const Ran none = demo({"--in", "monitor", "true"});
  EXPECT_EQ(none.status, 1);
  expect_nothing_left();
}

TEST_F(Demo, DoesNotEndAProcessThatTookANumberOfItsTeam) {
  Process stranger({.words = {"/bin/cat", "/dev/zero"}, .environment = {}, .before = {}});
  const std::string state = folder_ + "/geminga-demo-" + std::to_string(::getuid());
  fs::create_directories(state + "/hosts");
  std::ofstream(state + "/way") << "lo\n";
  std::ofstream(state + "/pids") << "1 1\n" << stranger.pid() << " 1\n" << stranger.pid() << " \n";
  EXPECT_EQ(demo({"--stop"}).status, 1);
  EXPECT_FALSE(fs::exists(state));
  EXPECT_EQ(::kill(stranger.pid(), 0), 0);
  siginfo_t ended{};
  EXPECT_EQ(::waitid(P_PID, static_cast<id_t>(stranger.pid()), &ended, WEXITED | WNOHANG | WNOWAIT), 0);
  EXPECT_EQ(ended.si_pid, 0) << "the stranger has been ended";
}

TEST_F(Demo, EndsWithTwoOnWhatItDoesNotUnderstand) {
  for (const std::vector<std::string>& words : {std::vector<std::string>{"--kep"},
                                                {"--keep", "--kep"},
                                                {"--stop", "now"},
                                                {"--keep", "--stop"},
                                                {"--in"},
                                                {"team"}}) {
    const Ran ran = demo(words);
    EXPECT_EQ(ran.status, 2) << ran.said;
    EXPECT_THAT(ran.said, HasSubstr("see tools/demo --help"));
  }
  const Ran help = demo({"--help"});
  EXPECT_EQ(help.status, 0);
  EXPECT_THAT(help.said, HasSubstr("tools/demo --stop"));
}

TEST(Scripts, SayWhatTheyAreForWithoutBuildingFirst) {
  const std::string root = GEMINGA_SOURCE_DIR;
  for (const std::string script : {"/examples/rescue-team/run", "/tools/simulate", "/tools/demo"}) {
    const auto help = system::run({.words = {root + script, "--help"}, .environment = {}, .before = {}});
    EXPECT_EQ(help.status, 0) << script;
    EXPECT_THAT(help.said, testing::Not(testing::HasSubstr("Building"))) << script;
    EXPECT_THAT(help.said, testing::HasSubstr(" team")) << script;
  }
}

}  // namespace
}  // namespace geminga::tools
