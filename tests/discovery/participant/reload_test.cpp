// Another ontology for a host that is full of services: in turns, beside its clients, counted and not timed.
#include <gtest/gtest.h>

#include "discovery/participant/knowledge/work.hpp"
#include "sim/client.hpp"
#include "sim/host.hpp"
#include "sim/small_ontology.hpp"
#include "sim/world.hpp"

namespace geminga::participant {
namespace {

using std::chrono::milliseconds;

/// Balls and opponents are offered, and asked for as what they are and as tracked objects.
class ReloadTest : public testing::Test {
 protected:
  ReloadTest() {
    host.ontology = sim::small_ontology("soccer");
    host.switch_on();
    world.run_for(milliseconds(200));
    consumer.on_line = [this](std::string_view line, const gcnp::Statement&) {
      if (line.find(" pub ") != std::string_view::npos) ++events;
    };
    for (sim::Client* one : {&provider, &consumer, &victim}) one->connect(host);
    for (int number = 1; number <= services; ++number) {
      say(provider, number, std::string("pub create mode=otm/stream port=1 concept=soccer:") + kind(number));
      say(consumer, number, std::string("sub create mode=otm/stream concept=soccer:") + wish(number));
    }
    world.run_for(milliseconds(50));
    EXPECT_EQ(consumer.view(1).size(), services);
    events = 0;
  }

  static void say(sim::Client& who, int number, const std::string& what) {
    who.say(std::to_string(number) + " " + what);
  }
  static const char* kind(int number) { return number % 2 == 0 ? "Ball" : "Opponent"; }
  static const char* wish(int number) {
    return number % 4 == 1 ? "TrackedObject" : number % 4 == 2 ? "Ball" : number % 4 == 3 ? "Opponent" : "Frame";
  }

  /// Asks for a pong at the instant of the reload; gives how many events were told before it came.
  int events_before_pong(const char* ontology) {
    int before = -1;
    victim.on_line = [&](std::string_view, const gcnp::Statement&) { before = events; };
    victim.say("0 sys ping");
    host.reload(sim::small_ontology(ontology));
    world.run_for(milliseconds(50));
    victim.on_line = nullptr;
    return before;
  }

  /// The events of one turn, for clients and for the ontology, and those of one step beyond it.
  static constexpr int told_in_turn = 2 * static_cast<int>(work_in_turn / cost_of_event) + 200;
  static constexpr int services = 200;
  sim::World world{sim::World::seed_or(1)};
  sim::Host& host = world.add_host("robot1");
  int events = 0;
  sim::Client& provider = world.add_client("provider");
  sim::Client& consumer = world.add_client("consumer");
  sim::Client& victim = world.add_client("victim");
};

TEST_F(ReloadTest, APingWaitsForOneTurnAndNotForTheWholeRegistry) {
  const int before = events_before_pong("ballless");
  EXPECT_GE(before, 0) << "no pong came";
  EXPECT_LE(before, told_in_turn);
  // Half of what is offered is gone: for those who asked for tracked objects and for those who asked for balls.
  EXPECT_EQ(events, (services / 4 + services / 4) * (services / 2));
  EXPECT_EQ(consumer.view(1).size(), services / 2);
  EXPECT_EQ(consumer.view(2).size(), 0U);
  EXPECT_EQ(consumer.view(3).size(), services / 2);
}

TEST_F(ReloadTest, OneThatChangesNothingTellsNothing) {
  EXPECT_GE(events_before_pong("soccer"), 0);
  EXPECT_EQ(events, 0);
}

TEST_F(ReloadTest, AnotherThatComesMeanwhileIsBehindItAndOnlyTheLastCounts) {
  host.reload(sim::small_ontology("ballless"));
  host.reload(sim::small_ontology("sensors"));
  host.reload(sim::small_ontology("soccer"));
  world.run_for(milliseconds(50));
  EXPECT_EQ(consumer.view(1).size(), services);
  EXPECT_EQ(consumer.view(2).size(), services / 2);
  EXPECT_EQ(events, 2 * (services / 4 + services / 4) * (services / 2)) << "sensors was never in force";
}

TEST_F(ReloadTest, WhatIsSaidMeanwhileHoldsWhenItIsOver) {
  host.reload(sim::small_ontology("ballless"));
  say(provider, 500, "pub create mode=otm/stream port=1 concept=soccer:Opponent");
  say(provider, 1, "pub remove");
  say(provider, 3, "pub modify port=7");
  say(consumer, 500, "sub create mode=otm/stream concept=soccer:TrackedObject");
  say(consumer, 3, "sub modify concept=soccer:Frame");
  world.run_for(milliseconds(50));
  EXPECT_EQ(consumer.view(1).size(), services / 2);
  EXPECT_EQ(consumer.view(500).size(), services / 2);
  EXPECT_EQ(consumer.view(3).size(), 0U);
  EXPECT_EQ(consumer.view(7).size(), services / 2);
  host.reload(sim::small_ontology("soccer"));
  world.run_for(milliseconds(50));
  EXPECT_EQ(consumer.view(500).size(), services);
}

TEST_F(ReloadTest, AClientThatLeavesMeanwhileIsGone) {
  host.reload(sim::small_ontology("ballless"));
  provider.hang_up();
  world.run_for(milliseconds(50));
  EXPECT_EQ(consumer.view(1).size(), 0U);
  EXPECT_EQ(consumer.view(3).size(), 0U);
}

TEST_F(ReloadTest, AQueryIsAnsweredByTheOntologyInForce) {
  host.reload(sim::small_ontology("ballless"));
  // Before any turn the old one is in force, and the answer that it would have begun is never cut.
  victim.say("1 query match concept=soccer:TrackedObject");
  world.run_for(milliseconds(50));
  ASSERT_FALSE(victim.lines.empty());
  EXPECT_TRUE(victim.lines.back() == "1 msg end count=" + std::to_string(services / 2) ||
              victim.lines.back().starts_with("1 503 "))
      << victim.lines.back();
}

}  // namespace
}  // namespace geminga::participant
