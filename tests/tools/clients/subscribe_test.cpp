// geminga-subscribe against a real daemon.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/json/object.hpp>
#include <csignal>
#include <sstream>

#include "tools/clients/bench.hpp"

namespace geminga::tools {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

TEST(Subscribe, PrintsEventsUntilItsCount) {
  Bench bench;
  Talk provider = bench.talk();
  provider.say("0 sys hello name=vision");
  ASSERT_TRUE(provider.line_with({"0 msg hello"}));
  provider.say("1 pub create mode=otm/stream concept=soccer:SharedBallInfo port=5000 rate=30");
  EXPECT_THAT(provider.lines_until_pong(), IsEmpty());
  const auto words = bench.run("geminga-subscribe", {"soccer:TrackedObject", "--count", "1"});
  EXPECT_EQ(words.status, 0) << words.errors;
  EXPECT_THAT(words.out, StartsWith("+ vision@robot0  soccer:SharedBallInfo  narrower 2  otm/stream  127.0.0.1:5000"));
  const auto document = bench.run("geminga-subscribe", {"soccer:TrackedObject", "--count", "1", "--json"});
  EXPECT_EQ(document.status, 0);
  const auto event = parsed(document.out).as_object();
  EXPECT_EQ(event.at("event"), "add");
  EXPECT_EQ(event.at("concept"), "soccer:SharedBallInfo");
  EXPECT_EQ(event.at("port").as_int64(), 5000);
  EXPECT_EQ(event.at("attributes").at("rate"), "30");
}

TEST(Subscribe, PrintsWhatChangesAndWhatIsGone) {
  Bench bench;
  auto subscribe = bench.start("geminga-subscribe", {"soccer:BallInfo", "soccer:GoalInfo"});
  Talk provider = bench.talk();
  provider.say("1 pub create mode=otm/stream concept=soccer:BallInfo port=5000");
  ASSERT_TRUE(subscribe->wait_for("+ ")) << subscribe->said();
  provider.say("1 pub modify port=5001");
  ASSERT_TRUE(subscribe->wait_for("  (port was 5000)\n")) << subscribe->said();
  EXPECT_THAT(subscribe->said(), HasSubstr("\n~ "));
  provider.say("1 pub remove");
  ASSERT_TRUE(subscribe->wait_for("  withdrawn\n")) << subscribe->said();
  EXPECT_THAT(subscribe->said(), ContainsRegex("\n- [^\n]*  soccer:BallInfo  [0-9a-f]+/[0-9]+/1  withdrawn\n"));
  provider.say("2 pub create mode=otm/stream concept=soccer:GoalInfo port=5002");
  ASSERT_TRUE(subscribe->wait_for("soccer:GoalInfo")) << subscribe->said();
  subscribe->signal(SIGINT);
  EXPECT_EQ(subscribe->wait(), 0);
}

TEST(Subscribe, StampsItsEventsAndNamesWhatIsGone) {
  Bench bench;
  auto lines = bench.start("geminga-subscribe", {"text=camera", "--timestamps"});
  auto objects = bench.start("geminga-subscribe", {"--text", "camera", "--json"});
  Talk provider = bench.talk();
  provider.say("0 sys hello name=eye");
  provider.say("1 pub create mode=otm/stream text=camera port=5000 rate=15");
  ASSERT_TRUE(lines->wait_for("+ ")) << lines->said();
  ASSERT_TRUE(objects->wait_for("add")) << objects->said();
  provider.say("1 pub modify rate=30 lens=wide");
  ASSERT_TRUE(lines->wait_for("  (rate was 15, lens was absent)\n")) << lines->said();
  provider.say("1 pub remove");
  ASSERT_TRUE(lines->wait_for("withdrawn\n")) << lines->said();
  ASSERT_TRUE(objects->wait_for("withdrawn")) << objects->said();
  EXPECT_THAT(lines->said(), ContainsRegex("^[0-9-]+T[0-9:.]+Z [+] eye@robot0 [^\n]*\n"
                                           "[0-9-]+T[0-9:.]+Z ~ eye@robot0 [^\n]*\n[0-9-]+T[0-9:.]+Z - eye@robot0"));
  for (auto* subscribe : {lines.get(), objects.get()}) {
    subscribe->signal(SIGTERM);
    EXPECT_EQ(subscribe->wait(), 0);
  }
  std::istringstream said(objects->said());
  std::vector<boost::json::object> events;
  for (std::string line; std::getline(said, line);) events.push_back(parsed(line).as_object());
  ASSERT_EQ(events.size(), 3U) << objects->said();
  for (const auto& event : events) {
    EXPECT_THAT(std::string(event.at("time").as_string()),
                testing::MatchesRegex("[0-9]{4}-[0-9]{2}-[0-9]{2}T[0-9]{2}:[0-9]{2}:[0-9]{2}[.][0-9]{3}Z"));
  }
  EXPECT_EQ(events[1].at("former"), (boost::json::object{{"attributes", {{"rate", "15"}, {"lens", nullptr}}}}));
  EXPECT_EQ(events[2].at("reason"), "withdrawn");
  EXPECT_EQ(events[2].at("text"), "camera");
  EXPECT_EQ(events[2].at("name"), "eye");
}

TEST(Subscribe, EndsWithFourWhenItsTimeIsOverWithNothing) {
  Bench bench;
  const auto nothing = bench.run("geminga-subscribe", {"--text", "nothing", "--timeout", "0.05"});
  EXPECT_EQ(nothing.status, 4);
  EXPECT_THAT(nothing.out, IsEmpty());
  Talk provider = bench.talk();
  provider.say("1 pub create mode=otm/stream text=camera port=5000");
  EXPECT_THAT(provider.lines_until_pong(), IsEmpty());
  // A busy machine needs longer until the event is there.
  int status = 4;
  for (int tenths = 3; status == 4 && tenths < 600; tenths *= 3) {
    const std::string time = std::to_string(tenths / 10) + '.' + std::to_string(tenths % 10);
    status = bench.run("geminga-subscribe", {"--text", "camera", "--timeout", time}).status;
  }
  EXPECT_EQ(status, 0) << "something was told";
  EXPECT_EQ(bench.run("geminga-subscribe", {"--text", "camera", "--timeout", "0.3", "--count", "2"}).status, 4)
      << "less than was asked for";
}

TEST(Subscribe, AsksForProvidersDegreeWhereAndLimit) {
  Bench bench;
  Talk provider = bench.talk();
  provider.say("0 sys hello name=vision");
  ASSERT_TRUE(provider.line_with({"0 msg hello"}));
  provider.say("1 pub create mode=otm/stream concept=soccer:SharedBallInfo port=5000 rate=30");
  EXPECT_THAT(provider.lines_until_pong(), IsEmpty());
  const auto expect = [&](int status, std::vector<std::string> words) {
    // An event ends it at once; it waits for the whole time only where no event is to come.
    words.insert(words.begin(), {"soccer:BallInfo", "--count", "1", "--timeout", status == 0 ? "100" : "0.2"});
    EXPECT_EQ(bench.run("geminga-subscribe", words).status, status) << testing::PrintToString(words);
  };
  expect(0, {});
  expect(4, {"--degree", "exact"});
  expect(0, {"--provider", "robot7,robot0/vision"});
  expect(4, {"--provider", "robot7"});
  expect(0, {"--where", "rate >= 30"});
  expect(4, {"--where", "rate > 30"});
  expect(0, {"--limit", "1"});
  expect(4, {"--mode", "otm/pubsub"});
}

TEST(Subscribe, EndsWithTwoOnANameThatTheOntologyDoesNotKnow) {
  Bench bench;
  EXPECT_EQ(bench.run("geminga-subscribe", {"soccer:BallInfo", "soccer:Bal"}).status, 2);
  EXPECT_EQ(bench.run("geminga-subscribe", {"soccer:BallInfo", "--where", "rate >"}).status, 2);
}

TEST(Subscribe, EndsWithThreeWhenTheDaemonGoes) {
  Bench bench;
  Talk provider = bench.talk();
  provider.say("1 pub create mode=otm/stream text=camera port=5000");
  EXPECT_THAT(provider.lines_until_pong(), IsEmpty());
  auto subscribe = bench.start("geminga-subscribe", {"--text", "camera"});
  ASSERT_TRUE(subscribe->wait_for("+ "));
  bench.stop_daemon();
  EXPECT_EQ(subscribe->wait(), 3);
}

TEST(Subscribe, AsksAgainWhenTheDaemonIsBackAndItIsKept) {
  Bench bench;
  auto subscribe = bench.start("geminga-subscribe", {"--text", "camera", "--keep"});
  {
    Talk provider = bench.talk();
    provider.say("1 pub create mode=otm/stream text=camera port=5000");
    ASSERT_TRUE(subscribe->wait_for("+ ")) << subscribe->said();
  }
  bench.stop_daemon();
  ASSERT_TRUE(subscribe->wait_for("trying again")) << subscribe->said();
  subscribe->forget();
  bench.start_daemon();
  Talk provider = bench.talk();
  provider.say("1 pub create mode=otm/stream text=camera port=5000");
  ASSERT_TRUE(subscribe->wait_for("+ ")) << subscribe->said();
  subscribe->signal(SIGTERM);
  EXPECT_EQ(subscribe->wait(), 0);
}

}  // namespace
}  // namespace geminga::tools
