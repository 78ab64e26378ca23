// The effect of forged datagrams on a participant: it lasts until the participant speaks again.
#include <gmock/gmock.h>

#include <functional>
#include <limits>
#include <string>

#include "discovery/announcement/limits.hpp"
#include "discovery/membership/forged_rig.hpp"
#include "discovery/membership/schedule/deadline.hpp"
#include "support/rounds.hpp"

namespace geminga::membership {
namespace {

struct Lie {
  std::string what;
  std::function<void(announcement::Announcement&)> forge;
};

/// Each field of a state changed, alone, and together with numbers that make the state look newer.
std::vector<Lie> lies() {
  const std::vector<Lie> fields = {
      {"no services", [](announcement::Announcement& lie) { lie.peers.clear(); }},
      {"another port", [](announcement::Announcement& lie) { lie.peers[0].publications[0].publication.port = 6666; }},
      {"another address",
       [](announcement::Announcement& lie) { lie.peers[0].publications[0].publication.address = "10.0.0.66"; }},
      {"another sender's address", [](announcement::Announcement& lie) { lie.addresses = {"10.0.0.66"}; }},
      {"no sender's address", [](announcement::Announcement& lie) { lie.addresses.clear(); }},
      {"another name", [](announcement::Announcement& lie) { lie.name = "liar"; }},
      {"another peer's name", [](announcement::Announcement& lie) { lie.peers[0].name = "liar"; }},
      {"another digest", [](announcement::Announcement& lie) { lie.ontology_digest = 66; }},
      {"the shortest interval", [](announcement::Announcement& lie) { lie.interval = announcement::min_interval; }},
      {"the longest interval", [](announcement::Announcement& lie) { lie.interval = announcement::max_interval; }},
      {"a subscription instead",
       [](announcement::Announcement& lie) {
         lie.peers[0].publications.clear();
         lie.peers[0].subscriptions = {{5, announcement::simple_subscription()}};
       }},
      {"one of many parts", [](announcement::Announcement& lie) { lie.part_count = 7; }},
      {"withheld services",
       [](announcement::Announcement& lie) {
         lie.peers[0].publications.clear();
         lie.peers[0].withheld = {5};
       }},
      {"nothing but its numbers", [](announcement::Announcement&) {}},
  };
  constexpr auto most = std::numeric_limits<std::uint64_t>::max();
  const std::vector<Lie> numbers = {
      {"the next", [](announcement::Announcement& lie) { ++lie.revision, ++lie.sequence; }},
      {"the same revision", [](announcement::Announcement& lie) { ++lie.sequence; }},
      {"the same sequence", [](announcement::Announcement& lie) { ++lie.revision; }},
      {"the greatest step",
       [](announcement::Announcement& lie) { lie.revision += announcement::max_revision_step, ++lie.sequence; }},
      {"the highest revision", [](announcement::Announcement& lie) { lie.revision = most, ++lie.sequence; }},
      {"the highest sequence", [](announcement::Announcement& lie) { ++lie.revision, lie.sequence = most; }},
      {"a sequence out of the window", [](announcement::Announcement& lie) { ++lie.revision, lie.sequence += 1000; }},
      {"a lower revision", [](announcement::Announcement& lie) { --lie.revision, ++lie.sequence; }},
      {"all zero", [](announcement::Announcement& lie) { lie.revision = lie.sequence = 0; }},
      {"another link", [](announcement::Announcement& lie) { ++lie.revision, ++lie.sequence, lie.link = 9; }},
  };
  std::vector<Lie> all;
  for (const auto& field : fields) {
    for (const auto& number : numbers) {
      all.push_back({field.what + ", " + number.what, [=](announcement::Announcement& lie) {
                       field.forge(lie);
                       number.forge(lie);
                     }});
    }
  }
  return all;
}

void expect_truth(const Air& air, const std::string& what) {
  EXPECT_TRUE(air.is_right()) << what << "\n" << testing::PrintToString(air.registry.services);
  const auto known = air.rig.table.neighbours().find(victim);
  ASSERT_TRUE(known) << what;
  EXPECT_EQ(known->name, "robot1") << what;
  EXPECT_EQ(known->ontology_digest, 0U) << what;
  EXPECT_EQ(known->interval, interval) << what;
  EXPECT_EQ(known->address, "10.0.0.1") << what;
  EXPECT_LE(known->deadline, air.now + patience(interval, {.loss = 1})) << what;
}

TEST(Forged, StatesFromTheSameAddressLastUntilTheirVictimSpeaks) {
  for (const auto& lie : lies()) {
    for (const int copies : {1, 2, 5}) {
      Air air;
      for (int i = 0; i < 5; ++i, air.pass(interval)) (void)air.say();
      (void)air.say();
      air.pass(seconds(1));
      for (int copy = 0; copy < copies; ++copy) {
        auto forged = air.truth();
        forged.sequence = air.sequence + static_cast<std::uint64_t>(copy);
        forged.revision = 10;
        air.revision = 10;
        lie.forge(forged);
        // The victim is at revision 10 as well, unless it was not heard yet.
        (void)air.hear(forged, "10.0.0.1");
      }
      const auto what = lie.what + ", " + std::to_string(copies) + " times";
      EXPECT_TRUE(air.rig.table.neighbours().is_known(victim)) << what;
      air.pass(seconds(1));
      (void)air.say();
      air.pass(interval);
      (void)air.say();
      air.pass(seconds(1));
      expect_truth(air, what);
      // Nothing of the lie comes back, and nothing of the victim is lost later.
      for (int i = 0; i < 10; ++i, air.pass(interval)) (void)air.say();
      expect_truth(air, what + ", later");
      EXPECT_TRUE(air.rig.table.neighbours().find(victim)->is_complete) << what;
    }
  }
}

TEST(Forged, StatesThatGoOnDoNothingToWhatTheirVictimGoesOnSaying) {
  for (auto lie : lies())
    for (const bool is_counting : {false, true}) {
      lie.what += is_counting ? ", counting on" : "";
      Air air;
      for (int i = 0; i < 5; ++i, air.pass(interval)) (void)air.say();
      for (int i = 0; i < 200; ++i) {
        if (i % 20 == 0) (void)air.say();
        // After the first contradiction the true services are there at every instant.
        if (i > 40) {
          for (const auto number : {5U, 6U, 7U}) {
            const auto key = ServiceKey{victim, PeerId{1}, number};
            const auto is = air.registry.services.find(key);
            ASSERT_NE(is, air.registry.services.end()) << lie.what << ", " << number << " at step " << i;
            const std::string should = number == 7U ? "sub of robot1/vision" : "10.0.0.1:5000 of robot1/vision";
            ASSERT_EQ(is->second, should) << lie.what << " at step " << i;
          }
        }
        auto forged = air.truth();
        forged.sequence = air.sequence;
        lie.forge(forged);
        if (is_counting) forged.sequence += static_cast<std::uint64_t>(i);
        (void)air.hear(forged, "10.0.0.1");
        air.pass(milliseconds(100));
      }
      (void)air.say();
      air.pass(interval);
      (void)air.say();
      air.pass(interval + milliseconds(1));
      (void)air.say();
      expect_truth(air, lie.what);
    }
}

TEST(Forged, OldWordsThatGoOnDelayAChangeUntilTwoIntervalsAfterThemAndNoNewService) {
  Air air;
  for (int i = 0; i < 5; ++i, air.pass(interval)) (void)air.say();
  const auto old = air.truth();
  const auto repeat = [&] {
    auto forged = old;
    forged.sequence = air.sequence;
    (void)air.hear(forged, "10.0.0.1");
  };
  auto lie = old;
  lie.name = "liar";
  lie.sequence = air.sequence;
  EXPECT_EQ(air.hear(lie, "10.0.0.1"), Hearing::contradiction);
  air.port = 7000;
  ++air.revision;
  for (int i = 0; i < 30; ++i) {
    auto state = air.truth();
    state.peers[0].publications.push_back({8, announcement::simple_publication()});
    (void)air.say(state);
    // It cannot be told from a true sender whose services somebody wants to redirect: what was believed stays.
    EXPECT_EQ(air.registry.services.at({victim, PeerId{1}, 5}), "10.0.0.1:5000 of robot1/vision") << i;
    EXPECT_TRUE(air.registry.services.contains({victim, PeerId{1}, 8})) << i;
    air.pass(interval / 2);
    repeat();
    air.pass(interval / 2);
  }
  ++air.revision;
  for (int i = 0; i < 4; ++i, air.pass(interval)) (void)air.say();
  EXPECT_TRUE(air.is_right()) << testing::PrintToString(air.registry.services);
}

TEST(Forged, RevisionFarFromTheLastIsBelievedOnlyWhenItIsRepeated) {
  for (const auto& [step, hearing] : {std::pair{announcement::max_revision_step - 1, Hearing::known},
                                      {announcement::max_revision_step, Hearing::known},
                                      {announcement::max_revision_step + 1, Hearing::leap}}) {
    Air air;
    (void)air.say();
    air.revision += step;
    EXPECT_EQ(air.say(), hearing) << step;
    EXPECT_EQ(air.say(), Hearing::known) << step;
  }
}

TEST(Forged, StatesFromAnotherAddressAreNotBelieved) {
  for (const auto& lie : lies()) {
    Air air;
    for (int i = 0; i < 20; ++i) {
      (void)air.say();
      EXPECT_TRUE(air.is_right()) << lie.what;
      for (int copy = 0; copy < 2; ++copy) {
        auto forged = air.truth();
        forged.sequence = air.sequence;
        lie.forge(forged);
        (void)air.hear(forged, "10.0.0.66");
        (void)air.say();
        EXPECT_TRUE(air.is_right()) << lie.what;
      }
      air.pass(interval);
    }
    expect_truth(air, lie.what);
  }
}

TEST(Forged, CopiesFromAnotherAddressAreIgnored) {
  Air air;
  std::vector<announcement::Announcement> heard;
  for (int i = 0; i < 100; ++i) {
    auto state = air.truth();
    state.addresses.clear();  // the source is all that tells where its services are
    state.sequence = ++air.sequence;
    heard.push_back(state);
    (void)air.hear(state, "10.0.0.1");
    for (const auto& each : heard) EXPECT_EQ(air.hear(each, "10.0.0.66"), Hearing::copied);
    EXPECT_TRUE(air.is_right());
    air.pass(milliseconds(500));
  }
}

TEST(Forged, AnAddressChangesWithTheSecondDatagramFromTheNewOne) {
  Air air;
  (void)air.say();
  auto moved = air.truth();
  moved.revision = 2;
  moved.addresses = {"10.0.0.9"};
  moved.sequence = 2;
  EXPECT_EQ(air.hear(moved, "10.0.0.9"), Hearing::elsewhere);
  EXPECT_EQ(air.hear(moved, "10.0.0.9"), Hearing::copied) << "the same one again proves nothing";
  EXPECT_TRUE(air.is_right());
  air.pass(milliseconds(20));
  moved.sequence = 3;
  EXPECT_EQ(air.hear(moved, "10.0.0.9"), Hearing::known);
  EXPECT_EQ(air.rig.table.neighbours().find(victim)->address, "10.0.0.9");
  EXPECT_EQ(air.registry.services.at({victim, PeerId{1}, 5}), "10.0.0.9:5000 of robot1/vision");
}

TEST(Forged, AnAddressThatSpeaksAgainHasNeverMoved) {
  Air air;
  for (int i = 0; i < 5; ++i, air.pass(interval)) (void)air.say();
  auto forged = air.truth();
  forged.addresses = {"10.0.0.66"};
  forged.revision = 2;
  const auto forge = [&] {
    ++forged.sequence;
    return air.hear(forged, "10.0.0.66");
  };
  forged.sequence = 1000;
  (void)forge();
  EXPECT_EQ(forge(), Hearing::known) << "nothing speaks against it yet";
  EXPECT_FALSE(air.is_right());
  EXPECT_EQ(air.say(), Hearing::contradiction);
  EXPECT_TRUE(air.is_right());
  // The way is not moved again while the victim speaks at least every other interval.
  for (int i = 0; i < 100; ++i) {
    EXPECT_NE(forge(), Hearing::known) << i;
    EXPECT_TRUE(air.is_right()) << i;
    air.pass(milliseconds(100));
    if (i % 20 == 0) (void)air.say();
  }
}

TEST(Forged, AddressesFromTheAddressThatAWayWasMovedFromAreNotBelievedAtTheirFirstWord) {
  Air air;
  for (int i = 0; i < 5; ++i, air.pass(interval)) (void)air.say();
  auto forged = air.truth();
  forged.revision = 2;
  for (forged.sequence = 100; forged.sequence < 102; ++forged.sequence) (void)air.hear(forged, "10.0.0.66");
  forged.addresses = {"10.0.0.66"};
  forged.revision = 3;
  for (int i = 0; i < 3; ++i) (void)air.hear(forged, "10.0.0.1");
  (void)air.say();
  EXPECT_TRUE(air.is_right()) << testing::PrintToString(air.registry.services);
}

TEST(Forged, AddressesFromBeforeAForgedMoveAreUndoneWithIt) {
  Air air;
  for (int i = 0; i < 5; ++i, air.pass(interval)) (void)air.say();
  auto forged = air.truth();
  forged.addresses = {"10.0.0.66"};
  forged.revision = 2;
  forged.sequence = 100;
  (void)air.hear(forged, "10.0.0.1");
  for (forged.sequence = 101; forged.sequence < 103; ++forged.sequence) (void)air.hear(forged, "10.0.0.66");
  air.pass(announcement::overtaken_time);
  (void)air.say();
  EXPECT_TRUE(air.is_right()) << testing::PrintToString(air.registry.services);
}

TEST(Forged, WaysFromElsewhereAreNotOpenedBesideOneThatLives) {
  for (const auto* source : {"10.0.0.1", "10.0.0.66"}) {
    Air air;
    (void)air.say();
    for (std::uint32_t link = 1; link < 100; ++link) {
      auto forged = air.truth();
      forged.peers.clear();
      forged.link = link;
      forged.revision = 100;
      forged.sequence = 100;
      EXPECT_EQ(air.hear(forged, source), Hearing::elsewhere) << link;
      EXPECT_TRUE(air.is_right());
    }
    EXPECT_EQ(air.rig.table.neighbours().find(victim)->paths.size(), 1U);
  }
}

TEST(Forged, IntervalOfAStrangerCountsOnlyUpToABound) {
  for (const auto announced :
       {announcement::stranger_interval - milliseconds(1), base::Duration(announcement::stranger_interval),
        announcement::stranger_interval + milliseconds(1), base::Duration(announcement::max_interval)}) {
    Air air;
    auto state = air.truth();
    state.interval = announced;
    (void)air.say(state);
    EXPECT_EQ(air.rig.table.neighbours().find(victim)->deadline,
              rig_start + patience(std::min<base::Duration>(announced, announcement::stranger_interval), {}));
    (void)air.say(state);
    EXPECT_EQ(air.rig.table.neighbours().find(victim)->deadline, rig_start + patience(announced, {}));
  }
}

/// Anything that an attacker may send in the name of the victim: true fields or any others.
announcement::Announcement random_lie(base::Random& random, const Air& air) {
  auto lie = random.chance(0.5) ? air.truth() : announcement::random_announcement(random);
  lie.group = "default";
  lie.participant = victim;
  lie.boot = random.chance(0.9) ? announcement::BootNonce{1} : announcement::BootNonce{random.below(5)};
  lie.link = random.chance(0.8) ? 0 : static_cast<std::uint32_t>(random.below(3));
  lie.sequence = random.chance(0.7) ? air.sequence + random.below(4) : random.next() >> random.below(64);
  lie.revision = random.chance(0.7) ? air.revision + random.below(3) : random.next() >> random.below(64);
  if (random.chance(0.3)) lie.part_count = static_cast<std::uint32_t>(1 + random.below(4));
  if (random.chance(0.3)) lie.peers.clear();
  if (random.chance(0.3)) lie.interval = milliseconds(50 + random.below(59'950));
  lie.kind = random.chance(0.9) ? announcement::Kind::state : announcement::Kind::goodbye;
  return lie;
}

TEST(Forged, NothingRandomOutlastsItsSenderByTwoIntervals) {
  for (std::uint64_t seed = 1; seed <= test::rounds(300U); ++seed) {
    base::Random random(seed);
    Air air;
    auto next = air.now;
    const auto live = [&](base::Duration time, double lies_a_step, bool is_changing) {
      for (const auto end = air.now + time; air.now < end; air.pass(milliseconds(50))) {
        const bool is_changed = is_changing && random.chance(0.01);
        if (is_changed) {
          ++air.revision;
          air.port = static_cast<std::uint16_t>(1 + random.below(60'000));
        }
        if (is_changed || air.now >= next) {
          (void)air.say();
          next = air.now + random.between(interval - interval / 10, interval + interval / 10);
        }
        if (!random.chance(lies_a_step)) continue;
        const auto* source = random.chance(0.7) ? "10.0.0.1" : "10.0.0.66";
        (void)air.hear(random_lie(random, air), source);
      }
    };
    live(seconds(5), 0, true);
    live(seconds(30), 0.01 + 0.5 * random.unit(), true);
    live(2 * interval, 0, false);
    // The lies are over for two intervals, and nothing has changed since. One more announcement may be on its way.
    (void)air.say();
    EXPECT_TRUE(air.is_right()) << "seed " << seed << "\n" << testing::PrintToString(air.registry.services);
    const auto known = air.rig.table.neighbours().find(victim);
    ASSERT_TRUE(known) << "seed " << seed;
    EXPECT_EQ(known->name, "robot1") << "seed " << seed;
    EXPECT_EQ(known->interval, interval) << "seed " << seed;
    EXPECT_EQ(known->address, "10.0.0.1") << "seed " << seed;
  }
}

}  // namespace
}  // namespace geminga::membership
