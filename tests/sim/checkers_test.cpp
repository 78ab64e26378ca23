// Each checker can fail: the world is broken on purpose, and the checker must say so.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "sim/robots.hpp"

namespace geminga::sim {
namespace {

using std::chrono::milliseconds;
using std::chrono::minutes;
using std::chrono::seconds;
using testing::Contains;
using testing::IsEmpty;
using testing::StartsWith;

/// Two hosts; what the second one's module is told can be invented.
class Checkers : public testing::Test {
 protected:
  Checkers() : world(World::seed_or(50), {}, [this](const std::string& words) { complaints.push_back(words); }) {
    for (Host* host : {&here, &there}) host->switch_on();
    for (const auto& module : team.modules()) module->run();
    world.run_for(seconds(3));
    EXPECT_TRUE(team.is_right()) << team.complaints();
    EXPECT_THAT(complaints, IsEmpty());
  }

  /// The daemon of `here` says a line to its module, which it never said.
  void invent(const std::string& line) {
    here_module.client().receive(env::StreamId{1}, line + "\r\n");
    world.run_for(milliseconds(1));
  }
  [[nodiscard]] static std::string add(const std::string& word, const std::string& address, int port) {
    return "2 pub add service=" + word +
           " provider=00000001/1 text=ball degree=exact distance=0 mode=otm/stream address=" + address +
           " port=" + std::to_string(port) + " protocol=udp";
  }
  [[nodiscard]] int port() { return there_module.offers().at(1).port; }

  std::vector<std::string> complaints;
  World world;
  Team team{world, {.missing = seconds(4), .surplus = seconds(12)}};
  Host& here = world.add_host("here");
  Host& there = world.add_host("there");
  Module& here_module = make(here);
  Module& there_module = make(there);

 private:
  Module& make(Host& host) {
    Module& module = team.add(host, host.name() + "-module");
    module.offer("ball", stream);
    module.wish("ball", stream);
    return module;
  }
};

TEST_F(Checkers, SayNothingOfATeamThatIsWell) {
  there_module.withdraw(1);
  world.run_for(seconds(20));
  there.crash();
  world.run_for(seconds(20));
  EXPECT_THAT(complaints, IsEmpty());
}

TEST_F(Checkers, FindAServiceThatNobodyOffers) {
  invent(add("00000001/1/9", "10.0.0.2", 999));
  EXPECT_THAT(complaints, Contains(StartsWith("false match")));
}

TEST_F(Checkers, FindAServiceOfAnotherMode) {
  const std::uint32_t other = there_module.offer("ball", pubsub);
  world.run_for(seconds(1));
  EXPECT_THAT(complaints, IsEmpty());
  invent(add("00000001/1/9", "10.0.0.2", there_module.offers().at(other).port));
  EXPECT_THAT(complaints, Contains(StartsWith("false match")));
}

TEST_F(Checkers, FindAServiceThatComesBackWithoutANewLife) {
  const int was = port();
  there_module.withdraw(1);
  world.run_for(seconds(1));
  invent(add("00000001/1/9", "10.0.0.2", was));
  EXPECT_THAT(complaints, Contains(StartsWith("returned")));
}

TEST_F(Checkers, AllowAServiceToComeBackWithANewLife) {
  there.crash();
  world.run_for(seconds(20));
  there.switch_on();
  world.run_for(seconds(20));
  EXPECT_TRUE(team.is_right()) << team.complaints();
  EXPECT_THAT(complaints, IsEmpty());
}

TEST_F(Checkers, FindAServiceThatStandsAfterItsDeadline) {
  invent(add("00000001/1/9", "10.0.0.2", port()));
  world.run_for(seconds(11));
  EXPECT_THAT(complaints, IsEmpty());
  world.run_for(seconds(2));
  EXPECT_THAT(complaints, Contains(StartsWith("surplus")));
}

TEST_F(Checkers, FindAServiceThatIsNotTold) {
  world.air.loss = 1;
  there_module.offer("ball", stream);
  world.run_for(seconds(6));
  EXPECT_THAT(complaints, Contains(StartsWith("missing")));
}

TEST_F(Checkers, WaitForWhatIsMissingUntilFaultsAreOver) {
  team.ledger().excuse_missing_until(world.now() + seconds(10));
  world.air.loss = 1;
  there_module.offer("ball", stream);
  world.run_for(seconds(13));
  EXPECT_THAT(complaints, testing::Not(Contains(StartsWith("missing"))));
  world.run_for(seconds(2));
  EXPECT_THAT(complaints, Contains(StartsWith("missing")));
}

TEST_F(Checkers, FindEventsThatDoNotFollowEachOther) {
  invent("2 pub del service=00000001/1/77 reason=withdrawn");
  EXPECT_THAT(complaints, Contains(StartsWith("events: gone without having been told")));
  invent("2 pub modify service=00000001/1/77 address=10.0.0.2 port=1");
  EXPECT_THAT(complaints, Contains(StartsWith("events: changed without having been told")));
  invent(add("00000001/1/9", "10.0.0.2", port()));
  invent(add("00000001/1/9", "10.0.0.2", port()));
  EXPECT_THAT(complaints, Contains(StartsWith("events: told twice")));
}

TEST_F(Checkers, FindAnErrorWhereNoneIsDue) {
  here_module.client().say("7 pub create nonsense");
  world.run_for(milliseconds(1));
  EXPECT_THAT(complaints, Contains(StartsWith("errors")));
}

TEST_F(Checkers, FindTwoParticipantsOfOneIdentifier) {
  here_module.client().receive(env::StreamId{1},
                               "0 msg hello participant=" + there_module.client().participant() + " peer=1\r\n");
  world.run_for(seconds(6));
  EXPECT_THAT(complaints, Contains(StartsWith("identifiers")));
}

TEST_F(Checkers, CountALivingHostThatIsToldToBeGone) {
  std::string word;
  for (const auto& [service, event] : here_module.client().view(2)) {
    if (service.starts_with(there_module.client().participant())) word = service;
  }
  ASSERT_FALSE(word.empty());
  invent("2 pub del service=" + word + " reason=expired");
  EXPECT_EQ(team.false_departures().size(), 1U);
}

}  // namespace
}  // namespace geminga::sim
