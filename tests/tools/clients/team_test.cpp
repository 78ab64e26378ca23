// geminga-query team, and participants --missing, with two robots that say what they are.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>

#include "support/lab.hpp"

namespace geminga::tools {
namespace {

using system::Lab;
using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

class Team : public testing::Test {
 protected:
  Team() {
    const std::vector<std::string> ontology{"--ontology", GEMINGA_SOURCE_DIR "/ontology", "--describe"};
    const std::vector<std::string> descriptions{"Robot and hasPart some Gripper and hasPart some ThermalCamera",
                                                "Robot and hasPart some ThermalCamera"};
    for (std::size_t host = 0; host < descriptions.size(); ++host) {
      auto flags = ontology;
      flags.push_back(descriptions[host]);
      lab_.begin(host, flags);
    }
    for (std::size_t host = 0; host < descriptions.size(); ++host) lab_.wait_until_ready(host);
  }

  [[nodiscard]] system::Process::Start start_of(std::size_t host, std::vector<std::string> words) const {
    words.insert(words.begin(), system::program("geminga-query"));
    auto start = lab_.on(host, std::move(words));
    start.environment = {{"GEMINGA_CONNECT", "127.0.0.1:" + std::to_string(lab_.gcnp_port(host))}};
    return start;
  }
  /// Asks the daemon of the first robot.
  [[nodiscard]] system::Ran query(std::vector<std::string> words) const {
    return system::run(start_of(0, std::move(words)));
  }

  Lab lab_{2};
};

TEST_F(Team, IsChosenByWhatRobotsSayThatTheyAreAndSaysWhatIsMissingWhereNobodyCan) {
  system::Process watch(
      start_of(0, {"--watch", "team", "--need", "canSee some WarmThing", "--need", "hasPart some Gripper"}));
  ASSERT_TRUE(watch.wait_for("robot1  canSee some WarmThing")) << watch.said();
  ASSERT_TRUE(watch.wait_for("robot0  hasPart some Gripper")) << watch.said();

  const auto both = query({"team", "--need", "1: canSee some WarmThing", "--need", "hasPart some Gripper"});
  EXPECT_EQ(both.status, 0);
  EXPECT_THAT(both.said, AllOf(ContainsRegex("1: canSee some WarmThing +robot1 "), ContainsRegex("Gripper +robot0 ")));

  const auto one = query({"team", "--need", "1 shared: canSee some WarmThing", "--need", "hasPart some Gripper"});
  EXPECT_EQ(one.status, 0);
  EXPECT_THAT(one.said, AllOf(HasSubstr("robot0"), Not(HasSubstr("robot1")))) << "as few robots as can be";

  const auto nobody = query({"team", "--need", "2: hasPart some Gripper", "--need", "shared: canSee some WarmThing"});
  EXPECT_EQ(nobody.status, 1);
  EXPECT_THAT(nobody.said, HasSubstr("role 1 (2: hasPart some Gripper) lacks 1 of 2; known to suit it: 1\n"));
  EXPECT_THAT(nobody.said, ContainsRegex("robot1 \\([0-9a-f]+\\) comes near: not known: capability:hasPart some "
                                         "capability:Gripper\n"));
  EXPECT_THAT(nobody.said, Not(HasSubstr("role 2")));
  EXPECT_THAT(nobody.said, ContainsRegex("the least that the team lacks:\ngeminga-query:   robot1 \\([0-9a-f]+\\) "
                                         "would hold role 1: not known: capability:hasPart some capability:Gripper\n"));
  const auto document = query({"--json", "team", "--need", "2: hasPart some Gripper"});
  EXPECT_EQ(document.status, 1);
  EXPECT_THAT(document.said, AllOf(HasSubstr("\"found\":false"), HasSubstr("\"lacking\":1"),
                                   HasSubstr("\"missing\":[\"capability:hasPart some capability:Gripper\"]")));

  // A conjunct that two roles of a robot lack counts once, and a condition counts, too.
  const auto least =
      query({"--json", "team", "--need", "shared: hasPart some Mast", "--need",
             "shared: hasPart some Mast and hasPart some Sonar", "--need", "3: hasPart some ThermalCamera", "--need",
             "shared: hasPart some Gripper where battery >= 30 %"});
  EXPECT_EQ(least.status, 1);
  EXPECT_THAT(least.said, AllOf(HasSubstr("\"lack\":{\"least\":true,\"count\":3,\"to_come\":[0,0,1,0]"),
                                ContainsRegex("\"roles\":\\[1,2(,4)?\\],\"missing\":\\[[^,]*Mast\",[^,]*Sonar\"\\]"),
                                HasSubstr("\"conditions\":[\"battery >= 30 %\"]")));

  const std::string example = GEMINGA_SOURCE_DIR "/examples/rescue-team/task.ttl";
  const auto file = query({"team", example});
  EXPECT_EQ(file.status, 1) << "nobody moves";
  EXPECT_THAT(file.said,
              AllOf(HasSubstr("role 1 (searcher) lacks 1 of 1"), HasSubstr("role 3 (watcher) lacks 1 of 1")));
  const auto other = query({"team", example, "--task", "rest"});
  EXPECT_EQ(other.status, 2);
  EXPECT_THAT(other.said, HasSubstr("has no task 'rest': name one by --task, there are 'find people and free them'\n"));
  EXPECT_EQ(query({"team"}).status, 2);
  EXPECT_EQ(query({"team", example, "--need", "hasPart some Gripper"}).status, 2);

  const auto near = query({"participants", "hasPart some Gripper", "--missing"});
  EXPECT_EQ(near.status, 0);
  EXPECT_THAT(near.said, AllOf(ContainsRegex("robot0 +narrower"), ContainsRegex("robot1 +-.*hasPart some cap")))
      << "those who are it come first";
  const auto near_document = query({"--json", "participants", "hasPart some Gripper", "--missing"});
  EXPECT_THAT(near_document.said, AllOf(ContainsRegex("\"id\":\"[0-9a-f]+\",\"name\":\"robot1\",\"addresses\":"),
                                        HasSubstr("\"missing\":[\"capability:hasPart some capability:Gripper\"]"),
                                        Not(HasSubstr("participant_name"))))
      << "those who come near have the fields of participants";
  EXPECT_EQ(query({"participants", "Robot"}).status, 0)
      << "a local name is enough alone, as it is within an expression";

  const auto unknown = query({"team", "--need", "hasPart some Arm", "--need", "hasPart some Gripprr"});
  EXPECT_EQ(unknown.status, 2);
  EXPECT_THAT(unknown.said, HasSubstr("role 2 (hasPart some Gripprr): "));
  const auto condition = query({"team", "--need", "hasPart some Gripper where battery >> 3"});
  EXPECT_EQ(condition.status, 2);
  EXPECT_THAT(condition.said, HasSubstr("role 1 (hasPart some Gripper where battery >> 3): where: "));

  EXPECT_EQ(system::run(start_of(1, {"describe", "--none"})).status, 0);
  EXPECT_TRUE(watch.wait_for("lacks 1 of 1")) << watch.said();
  watch.signal(SIGTERM);
  EXPECT_EQ(watch.wait(), 0) << watch.said();
}

}  // namespace
}  // namespace geminga::tools
