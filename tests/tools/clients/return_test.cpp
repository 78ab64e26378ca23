// A daemon that goes and comes back: services and requests that it does not confirm are shown as gone.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/json/object.hpp>
#include <csignal>
#include <sstream>

#include "client/scripted_daemon.hpp"
#include "tools/clients/bench.hpp"

namespace geminga::tools {
namespace {

using client::Conversation;
using client::ScriptedDaemon;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

std::string added(int number) {
  const std::string port = std::to_string(5000 + number);
  return "1 pub add service=5e6f7a8b/2/" + std::to_string(number) +
         " provider=5e6f7a8b/2 name=vision id=7 degree=exact distance=0 mode=otm/stream address=10.0.0.2 port=" + port +
         " protocol=udp priority=0 participant_name=robot5";
}

/// A connection with the services `numbers` when the request is made.
ScriptedDaemon::Script telling(const std::vector<int>& numbers, bool goes) {
  return [numbers, goes](Conversation& talk) {
    talk.welcome();
    talk.hear();
    for (const int number : numbers) talk.say(added(number));
    talk.expect("0 sys ping");
    talk.say("0 msg pong");
    if (!goes) talk.wait_for_end();
  };
}

std::unique_ptr<Process> start(const std::string& program, std::vector<std::string> words) {
  words.insert(words.begin(), system::program(program));
  return std::make_unique<Process>(Process::Start{.words = words, .environment = {}, .before = {}});
}

TEST(Return, TellsAsGoneWhatIsNotToldAgain) {
  ScriptedDaemon daemon({telling({1, 2}, true), telling({2, 3}, false)});
  auto subscribe = start("geminga-subscribe", {"--id", "7", "--keep", "--connect", daemon.address()});
  ASSERT_TRUE(subscribe->wait_for("trying again")) << subscribe->said();
  subscribe->forget();
  ASSERT_TRUE(subscribe->wait_for("unconfirmed")) << subscribe->said();
  EXPECT_THAT(subscribe->said(), HasSubstr("- vision@robot5  7  5e6f7a8b/2/1  unconfirmed\n"));
  EXPECT_THAT(subscribe->said(), Not(ContainsRegex("- [^\n]*5e6f7a8b/2/2"))) << "it was told again";
  subscribe->signal(SIGTERM);
  EXPECT_EQ(subscribe->wait(), 0);
}

TEST(Return, TellsAsGoneWhatWasToldAgainOnceAndNotAfterASecondReturn) {
  ScriptedDaemon daemon({telling({1}, true), telling({1}, true), telling({}, false)});
  auto subscribe = start("geminga-subscribe", {"--id", "7", "--keep", "--json", "--connect", daemon.address()});
  ASSERT_TRUE(subscribe->wait_for("\"event\":\"del\"")) << subscribe->said();
  subscribe->signal(SIGTERM);
  EXPECT_EQ(subscribe->wait(), 0);
  std::istringstream lines(subscribe->said());
  std::vector<std::string> events;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with('{')) continue;
    const auto event = parsed(line).as_object();
    events.emplace_back(event.at("event").as_string());
    EXPECT_EQ(event.at("service"), "5e6f7a8b/2/1");
    EXPECT_EQ(event.at("port").as_int64(), 5001) << "what is gone is named whole";
  }
  EXPECT_EQ(events, (std::vector<std::string>{"add", "add", "del"}));
}

TEST(Return, CountsWhatIsToldAsGone) {
  ScriptedDaemon daemon({telling({1, 2}, true), telling({}, false)});
  auto subscribe = start("geminga-subscribe", {"--id", "7", "--keep", "--count", "3", "--connect", daemon.address()});
  EXPECT_EQ(subscribe->wait(), 0);
  EXPECT_THAT(subscribe->said(), HasSubstr("5e6f7a8b/2/1  unconfirmed\n"));
  EXPECT_THAT(subscribe->said(), Not(HasSubstr("5e6f7a8b/2/2  unconfirmed\n"))) << "it ended before";
}

TEST(Return, OfAKilledDaemonTakesItsServicesAway) {
  Bench bench;
  auto subscribe = bench.start("geminga-subscribe", {"--text", "camera", "--keep"});
  Talk provider = bench.talk();
  provider.say("0 sys hello name=eye");
  provider.say("1 pub create mode=otm/stream text=camera port=5000");
  ASSERT_TRUE(subscribe->wait_for("+ eye@robot0")) << subscribe->said();
  bench.lab().daemon(0).signal(SIGKILL);
  EXPECT_EQ(bench.lab().daemon(0).wait(), 128 + SIGKILL);  // its port is free only then
  ASSERT_TRUE(subscribe->wait_for("trying again")) << subscribe->said();
  bench.start_daemon();
  ASSERT_TRUE(subscribe->wait_for("unconfirmed")) << subscribe->said();
  EXPECT_THAT(subscribe->said(), ContainsRegex("\n- eye@robot0  \"camera\"  [0-9a-f]+/[0-9]+/1  unconfirmed\n"));
  subscribe->signal(SIGTERM);
  EXPECT_EQ(subscribe->wait(), 0);
}

TEST(Return, TakesTheConsumersOfAPublicationAway) {
  Bench bench;
  auto publish =
      bench.start("geminga-publish", {"--text", "camera", "--mode", "otm/pubsub", "--port", "5000", "--keep"});
  ASSERT_TRUE(publish->wait_for("offering")) << publish->said();
  Talk consumer = bench.talk();
  consumer.say("0 sys hello name=world");
  consumer.say("1 sub create mode=otm/pubsub text=camera port=6000");
  ASSERT_TRUE(publish->wait_for("+ world@robot0")) << publish->said();
  bench.lab().daemon(0).signal(SIGKILL);
  EXPECT_EQ(bench.lab().daemon(0).wait(), 128 + SIGKILL);  // its port is free only then
  ASSERT_TRUE(publish->wait_for("trying again")) << publish->said();
  bench.start_daemon();
  ASSERT_TRUE(publish->wait_for("unconfirmed")) << publish->said();
  publish->signal(SIGTERM);
  EXPECT_EQ(publish->wait(), 0);
}

}  // namespace
}  // namespace geminga::tools
