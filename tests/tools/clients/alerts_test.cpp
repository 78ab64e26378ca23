// Rules of alerts and what is made of counts; and geminga-query alerts with a daemon.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "query/alerts/alert_watch.hpp"
#include "query/alerts/rules.hpp"
#include "query/alerts/words.hpp"
#include "tools/clients/bench.hpp"

namespace geminga::query::alerts {
namespace {

using std::chrono::seconds;
using testing::HasSubstr;

std::string first_error(const std::string& text) {
  const auto rules = read_rules(text, "a.toml");
  return rules ? "" : rules.error().front();
}

TEST(Rules, SayWhatIsCountedAndForHowLong) {
  const auto rules = read_rules(
      "[[rule]]\nname = \"ball\"\nconcept = \"soccer:BallInfo\"\nwhere = \"rate >= 10\"\nat-least = 1\nfor = 2.5\n"
      "[[rule]]\nname = \"eyes\"\nparticipants = \"canSee some Ball\"\nat-most = 3\n",
      "a.toml");
  ASSERT_TRUE(rules) << rules.error().front();
  ASSERT_EQ(rules->size(), 2U);
  EXPECT_EQ((*rules)[0].question.kind, "match");
  EXPECT_EQ((*rules)[0].time, std::chrono::milliseconds(2500));
  EXPECT_EQ(counted_words((*rules)[0]), "soccer:BallInfo where rate >= 10");
  EXPECT_EQ((*rules)[1].question, (Question{"participants", {{"concept", "canSee some Ball"}}}));
  EXPECT_EQ(wanted_words((*rules)[1]), "at most 3");
  EXPECT_EQ((*rules)[1].origin, "a.toml:7");
}

TEST(Rules, AreRefusedWithFileAndLineAndWhatToDo) {
  const std::string rule = "[[rule]]\nname = \"a\"\n";
  const std::vector<std::pair<std::string, std::string>> cases{
      {"", "a.toml:1: no rule"},
      {"[[rule]\n", "a.toml:1: "},
      {"name = 1\n", "a.toml:1: unknown key 'name'"},
      {"[[rule]]\ntext = \"x\"\nat-least = 1\n", "a.toml:1: the rule has no name"},
      {rule + "text = \"x\"\n", "a.toml:1: the rule has no count"},
      {rule + "at-least = 1\n", "a.toml:1: a rule counts one thing"},
      {rule + "text = \"x\"\nparticipants = \"y\"\nat-least = 1\n", "text is about services"},
      {rule + "text = \"x\"\nat-leest = 1\n", "a.toml:4: unknown key 'at-leest': did you mean 'at-least'?"},
      {rule + "text = \"x\"\nat-least = -1\n", "a.toml:4: at-least must be a whole number from 0"},
      {rule + "text = \"x\"\nat-least = 0\n", "always holds"},
      {rule + "text = \"x\"\nat-least = 3\nat-most = 2\n", "no count can hold"},
      {rule + "text = \"x\"\nat-least = 1\nfor = \"3 s\"\n", "a.toml:5: for must be a number of seconds"},
      {rule + "text = \"x\"\nat-least = 1\nfor = 86401\n", "a.toml:5: for must be"},
      {rule + "text = 7\nat-least = 1\n", "a.toml:3: text must be a text"},
      {rule + "text = \"x\"\nat-least = 1\n" + rule, "is that of a.toml:1, too"},
  };
  for (const auto& [text, error] : cases) EXPECT_THAT(first_error(text), HasSubstr(error)) << text;
}

TEST(Rules, AreAtMostSoManyWithNamesOfSoManyOctets) {
  for (const std::size_t count : {max_rules - 1, max_rules, max_rules + 1}) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i)
      text += "[[rule]]\nname = \"" + std::to_string(i) + "\"\ntext = \"x\"\nat-least = 1\n";
    EXPECT_EQ(first_error(text).empty(), count <= max_rules) << count;
  }
  for (const std::size_t octets : {max_rule_name_bytes - 1, max_rule_name_bytes, max_rule_name_bytes + 1}) {
    const std::string text = "[[rule]]\nname = \"" + std::string(octets, 'x') + "\"\ntext = \"x\"\nat-least = 1\n";
    EXPECT_EQ(first_error(text).empty(), octets <= max_rule_name_bytes) << octets;
  }
}

const std::vector<Rule> one_rule{
    {.name = "ball", .question = {"match", {}}, .at_least = 1, .at_most = {}, .time = seconds(3), .origin = {}}};

base::Instant at(int second) { return base::Instant() + seconds(second); }

TEST(AlertWatch, RaisesOnceTheCountHasBeenWrongForItsTimeAndClearsAtOnce) {
  AlertWatch watch(one_rule);
  EXPECT_FALSE(watch.counted(0, 1, at(0)));
  EXPECT_FALSE(watch.counted(0, 0, at(1)));
  EXPECT_EQ(watch.next_due(), at(4));
  EXPECT_FALSE(watch.counted(0, 0, at(3)));
  const auto raised = watch.counted(0, 0, at(4));
  ASSERT_TRUE(raised);
  EXPECT_EQ(line(one_rule[0], *raised), "raised ball: 0 services (), wanted are at least 1: wrong for 3.0 s");
  EXPECT_FALSE(watch.counted(0, 0, at(9)));
  const auto cleared = watch.counted(0, 2, at(10));
  ASSERT_TRUE(cleared);
  EXPECT_EQ(cleared->kind, Happening::Kind::cleared);
  EXPECT_EQ(cleared->lasted, seconds(9));
  EXPECT_EQ(watch.next_due(), base::never);
}

TEST(AlertWatch, BeginsAnewWhereTheCountWasRightOrUnknownMeanwhile) {
  for (const bool is_unknown : {false, true}) {
    AlertWatch watch(one_rule);
    EXPECT_FALSE(watch.counted(0, 0, at(0)));
    if (is_unknown) {
      EXPECT_TRUE(watch.not_counted(0, "no class is that"));
      EXPECT_FALSE(watch.not_counted(0, "no class is that"));
    } else {
      EXPECT_FALSE(watch.counted(0, 1, at(2)));
    }
    EXPECT_FALSE(watch.counted(0, 0, at(3)));
    EXPECT_FALSE(watch.counted(0, 0, at(5)));
    EXPECT_TRUE(watch.counted(0, 0, at(6)));
  }
}

TEST(AlertWatch, KeepsWhatIsRaisedWhileNothingIsCounted) {
  AlertWatch watch(one_rule);
  EXPECT_FALSE(watch.counted(0, 0, at(0)));
  EXPECT_TRUE(watch.counted(0, 0, at(3)));
  EXPECT_TRUE(watch.not_counted(0, "gone"));
  EXPECT_EQ(watch.alerts()[0].state, Alert::State::raised);
  EXPECT_TRUE(watch.counted(0, 1, at(4)));
}

}  // namespace
}  // namespace geminga::query::alerts
