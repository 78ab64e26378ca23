// Questions to daemons that answer, lie, flood, keep silent and vanish.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>

#include <chrono>
#include <string>
#include <vector>

#include "client/scripted_daemon.hpp"
#include "web/asking/daemon_asker.hpp"

namespace geminga::web {
namespace {

using client::Conversation;
using client::ScriptedDaemon;
using testing::SizeIs;
using Kind = ClientError::Kind;

constexpr std::chrono::seconds patience{60};

/// The asker and its loop.
struct Rig {
  explicit Rig(const std::string& address, std::chrono::milliseconds timeout = std::chrono::seconds(60))
      : asker(reactor, {*client::endpoint(address)}, timeout) {
    asker.start();
  }

  /// Turns the loop until this holds. False: patience ended first.
  bool until(const std::function<bool()>& holds) {
    const auto end = std::chrono::steady_clock::now() + patience;
    while (!holds()) {
      if (std::chrono::steady_clock::now() >= end) return false;
      pollfd ready{.fd = reactor.descriptor(), .events = POLLIN, .revents = 0};
      ::poll(&ready, 1, 1000);
      reactor.process();
    }
    return true;
  }
  bool until_up() {
    return until([this] { return asker.presence().is_up; });
  }
  void ask(const Query& query) {
    asker.ask(query, [this](Outcome outcome) { outcomes.push_back(std::move(outcome)); });
  }
  bool until_answered(std::size_t count) {
    return until([this, count] { return outcomes.size() >= count; });
  }

  client::Reactor reactor{[](const std::string& reason) { ADD_FAILURE() << reason; }};
  DaemonAsker asker;
  std::vector<Outcome> outcomes;
};

/// The number of a line of GCNP.
std::string number_of(const std::string& line) { return line.substr(0, line.find(' ')); }

void answer(Conversation& daemon, const std::string& line) {
  daemon.say(number_of(line) + " msg status state=ready uptime=1.000");
  daemon.say(number_of(line) + " msg end count=1");
}

TEST(Asker, AsksTheSameOnceAtATimeAndGivesTheAnswerToAll) {
  ScriptedDaemon daemon([](Conversation& talk) {
    EXPECT_EQ(talk.hear(), "0 sys hello name=geminga-web") << "and asks for no keys";
    talk.say("0 msg hello version=1 participant=1a2b3c4d peer=3 name=us ontology=-");
    const std::string first = talk.hear();
    EXPECT_THAT(first, testing::EndsWith(" query status"));
    const std::string second = talk.hear();
    EXPECT_THAT(second, testing::EndsWith(" query match text=\"two words\""));
    answer(talk, second);
    answer(talk, first);
    talk.wait_for_end();
  });
  Rig rig(daemon.address());
  ASSERT_TRUE(rig.until_up());
  rig.ask({"status"});
  rig.ask({"status"});
  rig.ask({"match", {{"text", "two words"}}});
  ASSERT_TRUE(rig.until_answered(3));
  for (const Outcome& outcome : rig.outcomes) {
    ASSERT_TRUE(outcome->has_value());
    EXPECT_THAT(outcome->value().records, SizeIs(1));
    EXPECT_EQ(outcome->value().end["count"], "1");
  }
}

TEST(Asker, SaysWhyThereIsNoDaemonAndFindsItLater) {
  const std::uint16_t port = client::free_port();
  Rig rig("127.0.0.1:" + std::to_string(port));
  rig.ask({"status"});
  ASSERT_THAT(rig.outcomes, SizeIs(1));
  EXPECT_EQ((*rig.outcomes[0]).error().kind, Kind::unreachable);
  ASSERT_TRUE(rig.until([&] { return rig.asker.presence().reason.contains("start gemingad"); }));
}

TEST(Asker, ConnectsAgainToADaemonThatVanishes) {
  ScriptedDaemon daemon({[](Conversation& talk) {
                           talk.hear();
                           talk.say("0 msg hello version=1 participant=1a2b3c4d peer=3 name=us ontology=-");
                           talk.hear();  // and dies before it has answered
                         },
                         [](Conversation& talk) {
                           talk.hear();
                           talk.say("0 msg hello version=1 participant=1a2b3c4d peer=3 name=us ontology=-");
                           answer(talk, talk.hear());
                           talk.wait_for_end();
                         }});
  Rig rig(daemon.address());
  ASSERT_TRUE(rig.until_up());
  rig.ask({"status"});
  ASSERT_TRUE(rig.until_answered(1));
  ASSERT_FALSE(rig.outcomes[0]->has_value());
  EXPECT_EQ(rig.outcomes[0]->error().kind, Kind::closed);
  ASSERT_TRUE(rig.until_up());
  rig.ask({"status"});
  ASSERT_TRUE(rig.until_answered(2));
  EXPECT_TRUE(rig.outcomes[1]->has_value());
}

TEST(Asker, LeavesADaemonThatDoesNotAnswerInTime) {
  const ScriptedDaemon::Script silent = [](Conversation& talk) {
    talk.hear();
    talk.say("0 msg hello version=1 participant=1a2b3c4d peer=3 name=us ontology=-");
    talk.wait_for_end();
  };
  // On a busy machine a hello may be late, too, and the asker comes again.
  ScriptedDaemon daemon(std::vector<ScriptedDaemon::Script>(100, silent));
  Rig rig(daemon.address(), std::chrono::milliseconds(200));
  ASSERT_TRUE(rig.until_up());
  rig.ask({"status"});
  rig.ask({"participants"});
  ASSERT_TRUE(rig.until_answered(2));
  EXPECT_EQ(rig.outcomes[0]->error().kind, Kind::timed_out);
  EXPECT_FALSE(rig.outcomes[1]->has_value());
  EXPECT_FALSE(rig.asker.presence().is_up);
}

TEST(Asker, GivesTheCodeOfARefusal) {
  ScriptedDaemon daemon([](Conversation& talk) {
    talk.hear();
    talk.say("0 msg hello version=1 participant=1a2b3c4d peer=3 name=us ontology=-");
    talk.say(number_of(talk.hear()) + " 422 unknown concept");
    talk.wait_for_end();
  });
  Rig rig(daemon.address());
  ASSERT_TRUE(rig.until_up());
  rig.ask({"match", {{"concept", "x:Y"}}});
  ASSERT_TRUE(rig.until_answered(1));
  EXPECT_EQ(rig.outcomes[0]->error().kind, Kind::refused);
  EXPECT_EQ(rig.outcomes[0]->error().code, ErrorCode::impossible);
  EXPECT_EQ(rig.outcomes[0]->error().text, "unknown concept");
}

TEST(Asker, TakesNoNoticeOfWhatNobodyAsked) {
  ScriptedDaemon daemon([](Conversation& talk) {
    talk.hear();
    talk.say("0 msg hello version=1 participant=1a2b3c4d peer=3 name=us ontology=-");
    const std::string line = talk.hear();
    for (int i = 0; i < 1000; ++i) {
      talk.say("77 msg status state=lie");
      talk.say("78 msg end count=9");
      talk.say("5 pub del service=1a2b3c4d/1/1 reason=left");
      talk.say("0 msg news x=1");
      talk.say("79 404 no such request");
    }
    answer(talk, line);
    talk.wait_for_end();
  });
  Rig rig(daemon.address());
  ASSERT_TRUE(rig.until_up());
  rig.ask({"status"});
  ASSERT_TRUE(rig.until_answered(1));
  ASSERT_TRUE(rig.outcomes[0]->has_value());
  EXPECT_EQ(rig.outcomes[0]->value().records.front()["state"], "ready");
}

TEST(Asker, LeavesWhatSpeaksAnotherProtocol) {
  ScriptedDaemon daemon([](Conversation& talk) {
    talk.hear();
    talk.say("HTTP/1.1 400 Bad Request");
    talk.wait_for_end();
  });
  Rig rig(daemon.address());
  ASSERT_TRUE(rig.until([&] { return rig.asker.presence().reason.contains("does not speak GCNP"); }));
}

/// A daemon that answers with so many octets, counted as the limit counts them, ends the answer and then closes.
void answer_with(Conversation& talk, std::size_t octets) {
  talk.hear();
  talk.say("0 msg hello version=1 participant=1a2b3c4d peer=3 name=us ontology=-");
  const std::string number = number_of(talk.hear());
  const std::size_t of_end = line_cost + parameter_cost + std::string("count1").size();
  octets -= of_end;
  constexpr std::size_t longest = 60'000;
  constexpr std::size_t of_line = line_cost + parameter_cost + 1;  // with the key `a`
  while (octets > 0) {
    std::size_t value = std::min(octets - of_line, longest);
    const std::size_t left = octets - of_line - value;
    if (left > 0 && left < of_line) value -= of_line;  // the last line needs room for its key
    talk.say(number + " msg status a=" + std::string(value, 'x'));
    octets -= of_line + value;
  }
  talk.say(number + " msg end count=1");
  talk.wait_for_end();
}

TEST(Asker, BoundsAnAnswer) {
  for (const int beyond : {-1, 0, 1}) {
    ScriptedDaemon daemon(
        [&](Conversation& talk) { answer_with(talk, max_answer_octets + static_cast<std::size_t>(beyond)); });
    Rig rig(daemon.address());
    ASSERT_TRUE(rig.until_up());
    rig.ask({"status"});
    ASSERT_TRUE(rig.until_answered(1));
    EXPECT_EQ(rig.outcomes[0]->has_value(), beyond <= 0) << beyond;
    EXPECT_EQ(rig.asker.presence().is_up, beyond <= 0) << beyond;
  }
}

TEST(Asker, BoundsTheQuestionsThatWait) {
  ScriptedDaemon daemon([](Conversation& talk) {
    talk.hear();
    talk.say("0 msg hello version=1 participant=1a2b3c4d peer=3 name=us ontology=-");
    talk.wait_for_end();
  });
  Rig rig(daemon.address());
  ASSERT_TRUE(rig.until_up());
  for (std::size_t i = 0; i < max_open_questions; ++i) rig.ask({"match", {{"text", std::to_string(i)}}});
  EXPECT_THAT(rig.outcomes, SizeIs(0));
  rig.ask({"match", {{"text", "0"}}});
  EXPECT_THAT(rig.outcomes, SizeIs(0)) << "the same question waits with the first";
  rig.ask({"match", {{"text", "one more"}}});
  ASSERT_THAT(rig.outcomes, SizeIs(1));
  EXPECT_EQ(rig.outcomes[0]->error().code, ErrorCode::too_many);
}

TEST(Asker, RefusesWhatGcnpCannotCarry) {
  ScriptedDaemon daemon([](Conversation& talk) {
    talk.welcome();
    talk.wait_for_end();
  });
  Rig rig(daemon.address());
  ASSERT_TRUE(rig.until_up());
  rig.ask({"match", {{"text", "\xff"}}});
  rig.ask({"match", {{"a b", "x"}}});
  rig.ask({"match", {{"text", std::string(70'000, 'x')}}});
  ASSERT_THAT(rig.outcomes, SizeIs(3));
  for (const Outcome& outcome : rig.outcomes) EXPECT_EQ(outcome->error().kind, Kind::wrong_use);
}

TEST(RecentAnswers, LiveForTheirTimeAndNoLonger) {
  RecentAnswers recent;
  const auto outcome = std::make_shared<const Result<Answer, ClientError>>(Answer{});
  const base::Instant now{};
  recent.put({"status"}, outcome, 1, now);
  EXPECT_EQ(recent.find({"status"}, now + answer_life - std::chrono::nanoseconds(1)), outcome);
  EXPECT_EQ(recent.find({"participants"}, now), nullptr);
  EXPECT_EQ(recent.find({"status"}, now + answer_life), nullptr);
  EXPECT_EQ(recent.size(), 0U);
}

TEST(RecentAnswers, AreSoMany) {
  const auto outcome = std::make_shared<const Result<Answer, ClientError>>(Answer{});
  for (const int beyond : {-1, 0, 1}) {
    RecentAnswers recent;
    const std::size_t count = max_recent_answers + static_cast<std::size_t>(beyond);
    for (std::size_t i = 0; i < count; ++i) recent.put({std::to_string(i)}, outcome, 1, {});
    EXPECT_EQ(recent.find({"0"}, {}) != nullptr, beyond <= 0) << beyond;
    EXPECT_NE(recent.find({std::to_string(count - 1)}, {}), nullptr);
    RecentAnswers large;
    large.put({"a"}, outcome, max_recent_octets - 1, {});
    large.put({"b"}, outcome, 1 + static_cast<std::size_t>(beyond), {});
    EXPECT_EQ(large.find({"a"}, {}) != nullptr, beyond <= 0) << beyond;
  }
}

}  // namespace
}  // namespace geminga::web
