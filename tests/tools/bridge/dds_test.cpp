// geminga-bridge dds beside programs of Cyclone DDS that use the names of ROS 2.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "support/lab.hpp"

namespace geminga::system {
namespace {

using testing::HasSubstr;

class Dds : public testing::Test {
 protected:
  void SetUp() override {
    if (!lab_.has_namespaces()) GTEST_SKIP() << "no network namespaces can be made";
    lab_.start(0, {"--ontology", GEMINGA_SOURCE_DIR "/ontology/core.ttl", "--ontology",
                   GEMINGA_SOURCE_DIR "/ontology/ros.ttl"});
    bridge_ = std::make_unique<Process>(lab_.on(0, {program("geminga-bridge"), "dds", "--domain", "3"}));
    ASSERT_TRUE(bridge_->wait_for("looking at domain 3")) << bridge_->said();
  }
  std::unique_ptr<Process> robot(std::vector<std::string> words) {
    words.insert(words.begin(), {program("ros_robot"), "3"});
    Process::Start start = lab_.on(1, std::move(words));
    start.environment["CYCLONEDDS_URI"] =
        "<CycloneDDS><Domain><Discovery><LeaseDuration>1 s</LeaseDuration></Discovery></Domain></CycloneDDS>";
    auto made = std::make_unique<Process>(std::move(start));
    EXPECT_TRUE(made->wait_for("there")) << made->said();
    return made;
  }
  /// Waits until an answer has a line with all these words, or has none.
  bool says(const std::string& query, const std::vector<std::string>& words, bool is_there = true) {
    Talk asker = lab_.talk(0);
    return asker.wait_until(query, [&](const std::vector<std::string>& lines) {
      const bool found = std::ranges::any_of(lines, [&](const std::string& line) {
        return std::ranges::all_of(words, [&](const auto& word) { return line.contains(word); });
      });
      return found == is_there;
    });
  }

  Lab lab_{2};
  std::unique_ptr<Process> bridge_;
};

TEST_F(Dds, ShowsARobotWithRosBesideOursAndWhyAQosDoesNotFit) {
  Talk module = lab_.talk(0);
  module.say("7 sub create mode=otm/stream concept=geminga:RangeScan");
  const auto robot = this->robot({"w", "scan",  "rt/scan",   "best_effort",  //
                                  "w", "thing", "rt/thing",  "reliable",     //
                                  "r", "scan",  "rt/scan",   "reliable",     //
                                  "r", "thing", "rt/thing",  "best_effort",  //
                                  "w", "thing", "rt/rosout", "best_effort"});
  const auto told = module.line_with({"7 pub add"});
  ASSERT_TRUE(told);
  for (const char* word : {"concept=ros:SensorMsgsLaserScan", "degree=narrower", "protocol=dds", "topic=/scan",
                           "type=sensor_msgs/msg/LaserScan", "domain=3", "reliability=best_effort"}) {
    EXPECT_THAT(*told, HasSubstr(word));
  }
  EXPECT_TRUE(says("services", {"text=my_msgs/msg/Thing", "topic=/thing", "used=1"}));
  EXPECT_TRUE(says("services", {"rosout"}, false));
  EXPECT_TRUE(says("requests unmatched=1", {"topic=/scan", "why=where", "reliability"}))
      << "a reliable reader and a writer that is none";
  EXPECT_TRUE(says("requests unmatched=1", {"topic=/thing"}, false));
  const auto fitting = this->robot({"w", "scan", "rt/scan", "reliable"});
  EXPECT_TRUE(says("requests unmatched=1", {"topic=/scan"}, false));
  fitting->signal(SIGTERM);
  EXPECT_EQ(fitting->wait(), 0);
  EXPECT_TRUE(says("requests unmatched=1", {"topic=/scan"}));
  robot->signal(SIGTERM);
  EXPECT_EQ(robot->wait(), 0);
  EXPECT_TRUE(says("services", {"protocol=dds"}, false));
  EXPECT_TRUE(says("requests", {"topic="}, false));
}

TEST_F(Dds, ShowsProgramsOfFastDdsToo) {
  if (!std::filesystem::exists(program("fast_robot"))) GTEST_SKIP() << "Fast DDS is not installed";
  Process robot(lab_.on(1, {program("fast_robot"), "3", "w", "rt/scan"}));
  ASSERT_TRUE(robot.wait_for("there")) << robot.said();
  EXPECT_TRUE(says("services", {"concept=ros:SensorMsgsLaserScan", "topic=/scan", "reliability=reliable"}));
  Process node(lab_.on(1, {program("fast_robot"), "3", "r", "rt/other"}));
  EXPECT_TRUE(says("requests unmatched=1", {"topic=/other", "why=where"}));
  for (Process* one : {&robot, &node}) {
    one->signal(SIGTERM);
    EXPECT_EQ(one->wait(), 0);
  }
  EXPECT_TRUE(says("services", {"protocol=dds"}, false));
}

TEST_F(Dds, HealsWhenTheDaemonComesBackAndLeavesNothingBehind) {
  const auto robot = this->robot({"w", "scan", "rt/scan", "best_effort"});
  EXPECT_TRUE(says("services", {"topic=/scan"}));
  lab_.daemon(0).signal(SIGKILL);
  EXPECT_EQ(lab_.daemon(0).wait(), 128 + SIGKILL);
  lab_.start(0);
  EXPECT_TRUE(says("services", {"text=sensor_msgs/msg/LaserScan", "topic=/scan"})) << "this daemon has no ontology";
  const auto doomed = this->robot({"w", "thing", "rt/thing", "reliable"});
  EXPECT_TRUE(says("services", {"topic=/thing"}));
  doomed->signal(SIGKILL);
  EXPECT_TRUE(says("services", {"topic=/thing"}, false)) << "its lease has ended";
  bridge_->signal(SIGTERM);
  EXPECT_EQ(bridge_->wait(), 0);
  EXPECT_TRUE(says("services", {"topic=/scan"}, false));
}

}  // namespace
}  // namespace geminga::system
