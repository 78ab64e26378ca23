// geminga-query --watch: every change as it comes, until a signal or the daemon's end.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <sstream>

#include "tools/clients/bench.hpp"

namespace geminga::tools {
namespace {

using testing::HasSubstr;

TEST(Watch, PrintsEveryChangeAsOneJsonObjectALine) {
  Bench bench;
  auto watch = bench.start("geminga-query", {"--watch", "--json", "services"});
  Talk peer = bench.talk();
  peer.say("1 pub create mode=oto text=camera port=5000 rate=15");
  ASSERT_TRUE(watch->wait_for("\"event\":\"add\"")) << watch->said();
  peer.say("1 pub modify rate=30");
  ASSERT_TRUE(watch->wait_for("\"event\":\"modify\"")) << watch->said();
  peer.say("1 pub remove");
  ASSERT_TRUE(watch->wait_for("\"event\":\"del\"")) << watch->said();
  watch->signal(SIGINT);
  EXPECT_EQ(watch->wait(), 0);
  std::istringstream lines(watch->said());
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) EXPECT_TRUE(parsed(line).is_object());
  EXPECT_EQ(count, 3) << watch->said();
}

TEST(Watch, PrintsChangesAsLinesForAReader) {
  Bench bench;
  auto watch = bench.start("geminga-query", {"--watch", "match", "soccer:TrackedObject"});
  Talk peer = bench.talk();
  peer.say("1 pub create mode=oto concept=soccer:BallInfo port=5000");
  ASSERT_TRUE(watch->wait_for("+ ")) << watch->said();
  peer.say("1 pub remove");
  ASSERT_TRUE(watch->wait_for("- ")) << watch->said();
  EXPECT_THAT(watch->said(), HasSubstr("soccer:BallInfo  narrower 1  oto  127.0.0.1:5000"));
  watch->signal(SIGTERM);
  EXPECT_EQ(watch->wait(), 0);
}

TEST(Watch, EndsWithThreeWhenTheDaemonGoes) {
  Bench bench;
  auto watch = bench.start("geminga-query", {"--watch", "participants"});
  ASSERT_TRUE(watch->wait_for("robot0"));
  bench.stop_daemon();
  EXPECT_EQ(watch->wait(), 3);
  EXPECT_THAT(watch->said(), HasSubstr("geminga-query: the daemon at "));
}

TEST(Watch, GoesWithListsOnly) {
  Bench bench;
  for (const std::vector<std::string>& words : {std::vector<std::string>{"status"},
                                                {"ontology"},
                                                {"explain", "soccer:BallInfo", "soccer:TrackedObject"},
                                                {"why", "00000001/1/1", "00000001/1/2"}}) {
    std::vector<std::string> line{"--watch"};
    line.insert(line.end(), words.begin(), words.end());
    EXPECT_EQ(bench.query(line).status, 2) << words[0];
  }
}

}  // namespace
}  // namespace geminga::tools
