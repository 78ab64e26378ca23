// geminga-query --watch: every change as it comes, until a signal or the daemon's end.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/json/object.hpp>
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
  for (std::string line; std::getline(lines, line); ++count) {
    const auto event = parsed(line).as_object();
    EXPECT_THAT(std::string(event.at("time").as_string()),
                testing::MatchesRegex("[0-9]{4}-[0-9]{2}-[0-9]{2}T[0-9]{2}:[0-9]{2}:[0-9]{2}[.][0-9]{3}Z"));
    EXPECT_EQ(event.at("text"), "camera") << "what is gone is named, too";
    if (event.at("event") == "modify") {
      EXPECT_EQ(event.at("former"), (boost::json::object{{"attributes", {{"rate", "15"}}}}));
    }
    if (event.at("event") == "del") {
      EXPECT_EQ(event.at("reason"), "withdrawn");
    }
  }
  EXPECT_EQ(count, 3) << watch->said();
}

TEST(Watch, BeginsLinesWithTheTimeWhereItIsToldTo) {
  Bench bench;
  Talk peer = bench.talk();
  peer.say("1 pub create mode=oto text=camera port=5000");
  EXPECT_THAT(peer.lines_until_pong(), testing::IsEmpty());
  auto watch = bench.start("geminga-query", {"--watch", "--timestamps", "services"});
  ASSERT_TRUE(watch->wait_for("camera")) << watch->said();
  EXPECT_THAT(watch->said(), testing::ContainsRegex("^[0-9-]+T[0-9:.]+Z [+] "));
  watch->signal(SIGTERM);
  EXPECT_EQ(watch->wait(), 0);
  EXPECT_EQ(bench.query({"--timestamps", "services"}).status, 2) << "a table has no time";
}

TEST(Watch, SaysWhyARecordIsGone) {
  Bench bench;
  Talk peer = bench.talk();
  peer.say("1 pub create mode=oto text=camera port=5000 rate=30");
  EXPECT_THAT(peer.lines_until_pong(), testing::IsEmpty());
  auto services = bench.start("geminga-query", {"--watch", "services"});
  auto fast = bench.start("geminga-query", {"--watch", "services", "rate=30"});
  ASSERT_TRUE(services->wait_for("+ ")) << services->said();
  ASSERT_TRUE(fast->wait_for("+ ")) << fast->said();
  peer.say("1 pub modify rate=5");
  ASSERT_TRUE(fast->wait_for("/1  changed\n")) << fast->said();
  ASSERT_TRUE(services->wait_for("  (rate was 30)\n")) << services->said();
  peer.say("1 pub remove");
  ASSERT_TRUE(services->wait_for("/1  withdrawn\n")) << services->said();
  for (auto* watch : {services.get(), fast.get()}) {
    watch->signal(SIGTERM);
    EXPECT_EQ(watch->wait(), 0);
  }
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
