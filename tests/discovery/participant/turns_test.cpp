// Clients take turns: what one of them asks for costs another one a bounded part of it, counted and not timed.
#include <gtest/gtest.h>

#include "discovery/participant/knowledge/work.hpp"
#include "sim/client.hpp"
#include "sim/host.hpp"
#include "sim/world.hpp"

namespace geminga::participant {
namespace {

using std::chrono::milliseconds;

/// A host with a provider of many services, and the ends of answers that all clients but one were told.
class TurnsTest : public testing::Test {
 protected:
  TurnsTest() {
    host.switch_on();
    world.run_for(milliseconds(200));
    sim::Client& provider = client("provider");
    for (int number = 1; number <= services; ++number) {
      const std::string id = std::to_string(number);
      provider.say(id + " pub create mode=otm/pubsub text=x port=" + id + " rate=" + id);
    }
    world.run_for(milliseconds(1));
  }

  sim::Client& client(const std::string& name) {
    sim::Client& one = world.add_client(name);
    one.on_line = [this, name](std::string_view line, const gcnp::Statement&) {
      if (line.find(" msg end ") != std::string_view::npos) ++ends;
      if (line.find(" pub ") != std::string_view::npos) ++events;
      if (line.find(" msg pong") != std::string_view::npos) order.push_back(name);
    };
    one.connect(host);
    return one;
  }

  static constexpr int services = 250;
  sim::World world{sim::World::seed_or(1)};
  sim::Host& host = world.add_host("robot1");
  int ends = 0;
  int events = 0;
  std::vector<std::string> order;  ///< in which clients were told pong
};

TEST_F(TurnsTest, APingWaitsForOneTurnAndNotForTheQueriesOfTenOthers) {
  constexpr int abusers = 10;
  constexpr int queries = 100;
  std::string question;
  for (int number = 1; number <= queries; ++number) {
    question += std::to_string(number) + " query match where=\"rate > 400 and rate < 3\"\n";
  }
  for (int number = 0; number < abusers; ++number) client("abuser").send_bytes(question);
  sim::Client& victim = client("victim");
  int ends_before_pong = -1;
  victim.on_line = [&](std::string_view, const gcnp::Statement&) { ends_before_pong = ends; };
  victim.say("0 sys ping");
  world.run_for(milliseconds(1));
  // Each query looks at 250 services and judges them.
  constexpr int work_of_query = services * static_cast<int>(cost_of_entry + cost_of_judgement);
  EXPECT_GE(ends_before_pong, 0) << "no pong came";
  EXPECT_LE(ends_before_pong, static_cast<int>(work_in_turn) / work_of_query + 1);
  EXPECT_EQ(ends, abusers * queries) << "the others are answered, too";
}

TEST_F(TurnsTest, TheOneThatUsedTheLeastLatelyIsNext) {
  sim::Client& busy = client("busy");
  sim::Client& quiet = client("quiet");
  std::string question;
  for (int number = 1; number <= 20; ++number) question += std::to_string(number) + " query services text=none\n";
  busy.send_bytes(question);
  world.run_for(milliseconds(1));
  // More than a turn for both together, so that they are told in different ones.
  busy.send_bytes(question + "0 sys ping\n");
  quiet.send_bytes(question.substr(0, question.size() / 3) + "\n0 sys ping\n");
  world.run_for(milliseconds(1));
  EXPECT_EQ(order, (std::vector<std::string>{"quiet", "busy"}));
}

TEST_F(TurnsTest, WhatManyServicesMeetIsToldInPiecesAndNobodyWaitsForAllOfThem) {
  sim::Client& greedy = client("greedy");
  sim::Client& victim = client("victim");
  int events_before_pong = -1;
  victim.on_line = [&](std::string_view, const gcnp::Statement&) { events_before_pong = events; };
  std::string requests;
  for (int number = 1; number <= 20; ++number) {
    requests += std::to_string(number) + " sub create mode=otm/pubsub text=x\n";
  }
  greedy.send_bytes(requests);
  victim.say("0 sys ping");
  world.run_for(milliseconds(5));
  EXPECT_GE(events_before_pong, 0) << "no pong came";
  EXPECT_LE(events_before_pong, 2 * static_cast<int>(work_in_turn / cost_of_event));
  EXPECT_EQ(events, 20 * services);
  for (std::uint32_t number = 1; number <= 20; ++number) EXPECT_EQ(greedy.view(number).size(), services);
}

TEST_F(TurnsTest, APeerWithManyServicesLeavesPieceByPiece) {
  sim::Client& consumer = client("consumer");
  for (int number = 1; number <= 20; ++number) {
    consumer.say(std::to_string(number) + " sub create mode=otm/pubsub text=x");
  }
  world.run_for(milliseconds(5));
  sim::Client& many = client("many");
  for (int number = 1; number <= services; ++number) {
    many.say(std::to_string(number) + " pub create mode=otm/pubsub text=x port=1");
  }
  world.run_for(milliseconds(5));
  ASSERT_EQ(consumer.view(7).size(), 2U * services);
  sim::Client& victim = client("victim");
  events = 0;
  int events_before_pong = -1;
  victim.on_line = [&](std::string_view, const gcnp::Statement&) { events_before_pong = events; };
  many.hang_up();
  victim.say("0 sys ping");
  world.run_for(milliseconds(5));
  EXPECT_GE(events_before_pong, 0) << "no pong came";
  EXPECT_LE(events_before_pong, 2 * static_cast<int>(work_in_turn / cost_of_event));
  EXPECT_EQ(consumer.view(7).size(), services);
}

/// The cost of one change of a service for others: one event for each that asked for it, and no more in a turn than one
/// statement may make.
TEST_F(TurnsTest, APingWaitsForOneStatementOfAFloodOfChangesThatManyAskedToHearOf) {
  constexpr int requests = 250;
  for (const char* name : {"a", "b", "c"}) {
    sim::Client& curious = client(name);
    for (int number = 1; number <= requests; ++number) {
      curious.say(std::to_string(number) + " sub create mode=otm/pubsub text=flood");
    }
  }
  sim::Client& flooder = client("flooder");
  flooder.say("1 pub create mode=otm/pubsub text=flood port=1");
  world.run_for(milliseconds(10));
  sim::Client& victim = client("victim");
  int events_before_pong = -1;
  victim.on_line = [&](std::string_view, const gcnp::Statement&) { events_before_pong = events; };
  events = 0;
  std::string changes;
  for (int number = 1; number <= 200; ++number) changes += "1 pub modify rate=" + std::to_string(number) + "\n";
  flooder.send_bytes(changes);
  victim.say("0 sys ping");
  world.run_for(milliseconds(10));
  EXPECT_GE(events_before_pong, 0) << "no pong came";
  EXPECT_LE(events_before_pong, 2 * 3 * requests);
  EXPECT_EQ(events, 200 * 3 * requests);
}

TEST_F(TurnsTest, ALongAnswerGoesOnAsSoonAsWhatWasSaidHasGone) {
  sim::Client& wordy = client("wordy");
  const std::string long_value(200, 'x');
  for (int number = 1; number <= services; ++number) {
    wordy.say(std::to_string(number) + " pub create mode=otm/pubsub text=y port=1 a=" + long_value +
              " b=" + long_value);
  }
  world.run_for(milliseconds(5));
  wordy.say("999 query services text=y");
  world.run_for(milliseconds(5));
  EXPECT_EQ(ends, 1) << "more than may be unread is said in one turn, and the client reads it all";
}

TEST_F(TurnsTest, AUserWithAllTheConnectionsDoesNotKeepAnotherOut) {
  const auto run = [&](const std::string& user) -> sim::Client& {
    sim::Client& one = world.add_client(user);
    one.user = user;
    one.connect(host);
    one.say("1 pub create mode=otm/stream text=pose port=1");
    world.run_for(milliseconds(1));
    return one;
  };
  sim::Client* last = nullptr;
  for (std::size_t number = 1; number < host.settings.limits.peers; ++number) last = &run("greedy");
  EXPECT_TRUE(last->is_connected()) << "the provider has one place and the greedy user all the others";
  EXPECT_TRUE(run("honest").is_connected());
  EXPECT_FALSE(last->is_connected()) << "its last one gives way";
  EXPECT_FALSE(run("greedy").is_connected()) << "it has the most already";
  EXPECT_TRUE(run("honest").is_connected());
}

TEST_F(TurnsTest, ManyConnectionsOfOneProgramLeaveRoomForTheServiceOfAnother) {
  for (int number = 0; number < 64; ++number) {
    sim::Client& greedy = client("greedy");
    for (int service = 1; service <= 64; ++service) {
      greedy.say(std::to_string(service) + " pub create mode=otm/stream text=pose port=1");
    }
    world.run_for(milliseconds(1));
  }
  sim::Client& honest = client("honest");
  honest.say("1 pub create mode=otm/stream text=mine port=1");
  honest.say("2 query services filter=mine");
  world.run_for(milliseconds(5));
  ASSERT_EQ(honest.lines.size(), 2U);
  EXPECT_EQ(honest.lines.back(), "2 msg end count=1");
}

TEST_F(TurnsTest, AnHonestPublisherIsNotChargedForWhatOthersAskedFor) {
  for (int number = 0; number < 3; ++number) {
    sim::Client& curious = client("curious");
    for (int request = 1; request <= 200; ++request) {
      curious.say(std::to_string(request) + " sub create mode=otm/stream text=pose");
    }
  }
  world.run_for(milliseconds(1500));
  sim::Client& honest = client("honest");
  honest.say("1 pub create mode=otm/stream text=pose port=1");
  for (int change = 1; change <= 200; ++change) honest.say("1 pub modify rate=" + std::to_string(change));
  world.run_for(milliseconds(50));
  EXPECT_TRUE(honest.lines.empty()) << honest.lines.front();
}

}  // namespace
}  // namespace geminga::participant
