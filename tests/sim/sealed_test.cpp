// Teams that seal, among them and beside them those who may not be heard: forgers, recordings, robots with other keys.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iostream>
#include <string>
#include <vector>

#include "discovery/sealing/rig.hpp"
#include "sim/liar.hpp"
#include "sim/robots.hpp"

namespace geminga::sim {
namespace {

using sealing::Mode;
using sealing::Policy;
using sealing::policy;
using std::chrono::milliseconds;
using std::chrono::minutes;
using std::chrono::seconds;

constexpr Bounds patient = {.missing = seconds(30), .surplus = seconds(30)};

/// Robots that all seal in the same way.
struct Sealed : Robots {
  Sealed(std::uint64_t seed, int count, double loss, const Policy& how)
      : Robots(World::seed_or(seed), count, {.loss = loss, .longest_delay = milliseconds(5)}, patient) {
    for (const auto& host : world.hosts()) host->settings.sealing = how;
  }

  /// All at once.
  base::Duration start_together() {
    for (const auto& host : world.hosts()) host->switch_on();
    for (const auto& module : team.modules()) module->run();
    const auto begin = world.now();
    while (!team.is_right() && world.now() - begin < seconds(60)) world.run_for(milliseconds(10));
    return world.now() - begin;
  }

  /// While it runs.
  void adopt(std::size_t host_number, const Policy& how) {
    host(host_number).event([&](participant::Participant& participant) { participant.set_sealing(how); });
  }
  void adopt_one_after_the_other(const Policy& how) {
    for (std::size_t i = 0; i < world.hosts().size(); ++i) {
      adopt(i, how);
      world.run_for(seconds(7));
    }
  }

  /// The datagrams on the air from now on.
  void record() {
    world.on_transmit = [this](const Host&, std::string_view datagram) { recording.emplace_back(datagram); };
  }
  void replay(base::Duration spacing, const std::string& source) {
    world.on_transmit = nullptr;
    for (const std::string& datagram : recording) {
      world.inject(source, datagram);
      world.run_for(spacing);
    }
  }
  std::vector<std::string> recording;
};

const Policy encrypted = policy(Mode::encrypted, {1});
const Policy plain;

/// The mean of some starts.
double start_ms(int robots, double loss, const Policy& how) {
  const int starts = robots > 10 ? 1 : 5;
  double sum = 0;
  for (int seed = 1; seed <= starts; ++seed) {
    Sealed team(static_cast<std::uint64_t>(seed), robots, loss, how);
    sum += std::chrono::duration<double, std::milli>(team.start_together()).count();
  }
  return sum / starts;
}

TEST(Sealed, TeamsStartAsQuicklyAsPlainOnes) {
  for (const int robots : {2, 10, 30}) {
    for (const double loss : {0.0, 0.1, 0.3, 0.5}) {
      if (robots == 30 && loss != 0.3) continue;  // it takes long to simulate
      const double without = start_ms(robots, loss, plain);
      const double with = start_ms(robots, loss, encrypted);
      std::cout << robots << " robots at " << loss << ": " << without << " ms plain, " << with << " ms sealed\n";
      EXPECT_LE(with, 1.5 * without + 150) << robots << " robots at " << loss;
    }
  }
}

TEST(Sealed, TeamsSayAtMostTwentyFiveOctetsASecondMore) {
  const auto octets_a_second = [](const Policy& how) {
    Sealed team(5, 10, 0, how);
    (void)team.start_together();
    team.world.run_for(seconds(10));
    const auto before = team.world.datagram_bytes();
    team.world.run_for(minutes(5));
    return static_cast<double>(team.world.datagram_bytes() - before) / 300 / 10;
  };
  const double without = octets_a_second(plain);
  const double with = octets_a_second(encrypted);
  const double rotating = octets_a_second(policy(Mode::encrypted, {1, 2}));
  std::cout << without << " B/s plain, " << with << " sealed, " << rotating << " in a rotation\n";
  EXPECT_LE(with, without + 25);
  EXPECT_LE(rotating, without + 25);
}

TEST(Sealed, TeamsLoseNobodyUnderLoss) {
  Sealed team(6, 10, 0.3, encrypted);
  team.start();
  EXPECT_TRUE(team.team.settle(seconds(30)));
  team.world.run_for(minutes(10));
  EXPECT_TRUE(team.team.is_right()) << team.world.when() << "\n" << team.team.complaints();
  EXPECT_THAT(team.team.false_departures(), testing::IsEmpty());
}

TEST(Sealed, TeamsHearNothingOfAForgerWhateverItSays) {
  Sealed team(7, 5, 0, encrypted);
  Liar liar(team.world);
  team.start();
  EXPECT_TRUE(team.team.settle(seconds(5)));
  announcement::Announcement lie;
  lie.group = "default";
  lie.participant = ParticipantId(7);
  lie.boot = announcement::BootNonce(7);
  lie.name = "forger";
  base::Random random(7);
  team.record();
  team.world.run_for(seconds(10));
  const std::vector<std::string> heard = team.recording;
  const std::size_t events = team.team.events();
  for (int i = 0; i < 3000; ++i) {
    ++lie.sequence;
    liar.say(lie, Liar::address_of(team.host(0)));
    std::string bent = heard[random.below(heard.size())];
    bent[random.below(bent.size())] ^= static_cast<char>(1 + random.below(255));
    team.world.inject(Liar::address_of(team.host(1)), bent);
    team.world.inject("10.0.0.66", heard[random.below(heard.size())]);
    team.world.run_for(milliseconds(10));
  }
  EXPECT_TRUE(team.team.is_right()) << team.team.complaints();
  EXPECT_EQ(team.team.events(), events) << "nobody was told anything";
  EXPECT_THAT(team.team.false_departures(), testing::IsEmpty());
  const auto status = team.world.ask(team.host(0), "status");
  ASSERT_FALSE(status.empty());
  for (const char* word : {"sealing_plain=3", "sealing_forged=", "sealing_replayed=", "participants=5"}) {
    EXPECT_THAT(status.front(), testing::HasSubstr(word));
  }
  for (const char* word : {"contradicted", "contested", "redraws"}) {
    EXPECT_THAT(status.front(), testing::Not(testing::HasSubstr(word)));
  }
}

TEST(Sealed, TeamsLearnOfADeathInTimeThoughSomebodyReplaysTheDeadOne) {
  Sealed team(8, 5, 0, encrypted);
  team.record();
  team.start();
  EXPECT_TRUE(team.team.settle(seconds(5)));
  team.world.run_for(seconds(20));
  team.host(2).crash();
  const auto killed = team.world.now();
  team.replay(milliseconds(5), Liar::address_of(team.host(2)));
  while (!team.team.is_right() && team.world.now() - killed < seconds(60)) team.world.run_for(milliseconds(20));
  EXPECT_LE(team.world.now() - killed, milliseconds(4600)) << team.world.when();
  team.world.run_for(seconds(20));
  EXPECT_TRUE(team.team.is_right()) << team.team.complaints();
}

TEST(Sealed, TeamsHearNothingOfARecordingOfYesterday) {
  for (const bool is_mixed_with_today : {false, true}) {
    Sealed team(9, 5, 0, encrypted);
    team.record();
    team.start();
    EXPECT_TRUE(team.team.settle(seconds(5)));
    team.world.run_for(seconds(20));
    for (const auto& host : team.world.hosts()) host->crash();
    team.world.run_for(minutes(60));
    const std::vector<std::string> yesterday = team.recording;
    team.host(0).switch_on();
    team.host(1).switch_on();
    if (is_mixed_with_today) {
      EXPECT_TRUE(team.team.settle(seconds(5)));
      team.world.run_for(seconds(5));
    }
    team.replay(milliseconds(3), "10.0.0.3");
    EXPECT_TRUE(team.team.settle(seconds(5))) << team.team.complaints();
    for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
      EXPECT_THAT(team.world.ask(team.host(i), "participants"), testing::SizeIs(3)) << "two of them, and the end";
      EXPECT_THAT(team.world.ask(team.host(i), "status").front(), testing::HasSubstr("sealing_unproved="));
    }
  }
}

TEST(Sealed, TeamsTakeInANewcomerInSpiteOfAFloodOfRecordings) {
  Sealed team(10, 4, 0, encrypted);
  Host& newcomer = team.add("newcomer");
  newcomer.settings.sealing = encrypted;
  // A month of recordings: three hundred sessions.
  std::vector<std::string> month;
  for (int i = 0; i < 300; ++i) {
    sealing::Member once(1000 + i, encrypted);
    month.push_back(sealing::text_of(once.say("claim")));
  }
  for (std::size_t i = 0; i < 4; ++i) team.host(i).switch_on();
  for (const auto& module : team.team.modules()) module->run();
  EXPECT_TRUE(team.team.settle(seconds(10)));
  bool is_flooding = true;
  team.world.every(milliseconds(1), [&] {
    if (!is_flooding) return;
    for (int i = 0; i < 5; ++i) team.world.inject("10.0.0.66", month[team.world.random().below(month.size())]);
  });
  team.world.run_for(seconds(5));
  newcomer.switch_on();
  EXPECT_TRUE(team.team.settle(seconds(5))) << team.team.complaints();
  team.world.run_for(seconds(20));
  is_flooding = false;
  EXPECT_TRUE(team.team.is_right()) << team.team.complaints();
  EXPECT_THAT(team.team.false_departures(), testing::IsEmpty());
}

TEST(Sealed, TeamsRotateTheirKeyWhileTheyRunAndNobodyIsLost) {
  Sealed team(11, 5, 0.1, encrypted);
  team.start();
  EXPECT_TRUE(team.team.settle(seconds(10)));
  const std::size_t events = team.team.events();
  for (const Policy& step :
       {policy(Mode::encrypted, {1, 2}), policy(Mode::encrypted, {2, 1}), policy(Mode::encrypted, {2})}) {
    team.adopt_one_after_the_other(step);
    EXPECT_TRUE(team.team.is_right()) << team.team.complaints();
  }
  EXPECT_EQ(team.team.events(), events);
  EXPECT_THAT(team.team.false_departures(), testing::IsEmpty());
}

TEST(Sealed, TeamsShowWhoLacksWhichKey) {
  Sealed team(12, 3, 0, policy(Mode::encrypted, {1, 2}));
  team.host(1).settings.sealing = encrypted;
  team.host(2).settings.sealing = policy(Mode::encrypted, {3});
  team.start();
  team.world.run_for(seconds(10));
  const std::string first = to_string(sealing::key_of(1).id());
  const std::string second = to_string(sealing::key_of(2).id());
  const std::string third = to_string(sealing::key_of(3).id());
  const auto lines = team.world.ask(team.host(0), "security");
  EXPECT_THAT(lines, testing::Contains("1 msg security mode=encrypted keys=" + first + "," + second));
  EXPECT_THAT(lines, testing::Contains(testing::EndsWith("name=robot2 protection=encrypted key=" + first +
                                                         " keys=" + first + " lacks=" + second)));
  EXPECT_THAT(lines, testing::Contains(testing::HasSubstr("source=\"10.0.0.3 on eth0\" protection=encrypted key=" +
                                                          third + " rejected=unknown-key count=")));
  EXPECT_THAT(lines, testing::Not(testing::Contains(testing::HasSubstr("name=robot3"))));
}

TEST(Sealed, TeamsGoFromPlainToEncryptedWhileTheyRunAndNobodyIsLost) {
  Sealed team(13, 5, 0.1, plain);
  team.start();
  EXPECT_TRUE(team.team.settle(seconds(10)));
  const std::size_t events = team.team.events();
  for (const Mode mode : {Mode::prepared, Mode::mixed, Mode::encrypted}) {
    team.adopt_one_after_the_other(policy(mode, {1}));
    EXPECT_TRUE(team.team.is_right()) << to_string(mode) << team.team.complaints();
  }
  EXPECT_EQ(team.team.events(), events);
  EXPECT_THAT(team.team.false_departures(), testing::IsEmpty());
}

TEST(Sealed, TeamsOfOtherKeysOnOneLinkDoNotSeeEachOther) {
  Sealed team(14, 4, 0, encrypted);
  team.team.is_excused = true;  // its oracle knows nothing of keys
  team.host(2).settings.sealing = policy(Mode::encrypted, {2});
  team.host(3).settings.sealing = plain;
  team.start();
  team.world.run_for(seconds(10));
  EXPECT_THAT(team.world.ask(team.host(0), "participants"), testing::SizeIs(3));
  EXPECT_THAT(team.world.ask(team.host(2), "participants"), testing::SizeIs(2));
  EXPECT_THAT(team.world.ask(team.host(3), "participants"), testing::SizeIs(2));
}

TEST(SealedTeam, AnswersWhoeverHasTheKeyAndForLongOnlyWhoHasProvedItself) {
  Sealed robots(41, 2, 0, policy(Mode::encrypted, {1}));
  robots.host(0).hears_strangers_alone = true;
  robots.start_together();
  const std::vector<base::Duration>& answered = robots.host(0).answered;
  ASSERT_GE(answered.size(), 2U);
  EXPECT_EQ(answered.front(), base::Duration(0)) << "it has proved nothing, and is to hear what it is asked";
  EXPECT_EQ(answered.back(), seconds(10)) << "as long as it may live";
  robots.world.run_for(seconds(2));
  const auto before = answered.size();
  robots.world.inject("10.0.0.77", "G no seal at all that would open by any key of the team");
  robots.world.inject("10.0.0.77", "plain");
  robots.world.run_for(milliseconds(1));
  EXPECT_EQ(answered.size(), before);
}

TEST(SealedTeam, WithoutKeysNobodyIsAnsweredAlone) {
  Robots robots(World::seed_or(42), 3, {});
  for (const auto& host : robots.world.hosts()) host->hears_strangers_alone = true;
  robots.start();
  robots.world.run_for(seconds(10));
  for (const auto& host : robots.world.hosts()) EXPECT_TRUE(host->answered.empty());
}

}  // namespace
}  // namespace geminga::sim
