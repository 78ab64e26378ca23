// An attacker on the link can do nothing to a team that lasts. GEMINGA_SEED chooses another seed.
#include "sim/liar.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "discovery/announcement/limits.hpp"
#include "sim/team.hpp"
#include "support/rounds.hpp"

namespace geminga::sim {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr auto interval = seconds(2);
constexpr const char* stranger = "10.0.0.66";

/// Three robots that offer and want the same things of each other, and a liar. That no view is wrong for longer than
/// two intervals is checked all the time by the team.
struct Attack {
  explicit Attack(std::uint64_t seed)
      : world(seed), team(world, {.missing = 2 * interval, .surplus = seconds(25)}), liar(world) {
    team.ledger().tampered_until(base::never);
    for (const char* name : {"robot1", "robot2", "robot3"}) add(name);
    world.run_for(seconds(30));
    EXPECT_TRUE(team.is_right()) << world.when() << "\n" << team.complaints();
  }

  Host& add(const std::string& name) {
    Host& host = world.add_host(name);
    Module& module = team.add(host, name + "-vision");
    for (const char* what : {"ball", "obstacles", "lines"}) module.offer(what, "otm/stream");
    for (const char* what : {"ball", "lines"}) module.wish(what, "otm/stream");
    host.switch_on();
    module.run();
    return host;
  }
  [[nodiscard]] const Host& victim() const { return *world.hosts().front(); }
  void expect_right(const std::string& what) {
    EXPECT_TRUE(team.is_right()) << what << ", " << world.when() << "\n" << team.complaints();
  }

  World world;
  Team team;
  Liar liar;
};

struct Lie {
  std::string what;
  std::function<void(announcement::Announcement&)> forge;
};

std::vector<Lie> lies() {
  constexpr auto most = std::numeric_limits<std::uint64_t>::max();
  return {
      {"a peer emptied with the highest revision",
       [](auto& lie) {
         lie.peers.clear();
         lie.revision = most;
       }},
      {"a peer emptied with the next revision",
       [](auto& lie) {
         lie.peers.clear();
         ++lie.revision, ++lie.sequence;
       }},
      {"a peer emptied with the highest sequence",
       [](auto& lie) {
         lie.peers.clear();
         ++lie.revision, lie.sequence = most;
       }},
      {"services redirected with the highest revision",
       [](auto& lie) {
         lie.addresses = {stranger};
         lie.revision = most, ++lie.sequence;
       }},
      {"services redirected with the next revision",
       [](auto& lie) {
         for (auto& peer : lie.peers) {
           for (auto& one : peer.publications) one.publication.address = stranger;
         }
         ++lie.revision, ++lie.sequence;
       }},
      {"services redirected with the same revision",
       [](auto& lie) {
         lie.addresses = {stranger};
         ++lie.sequence;
       }},
      {"the shortest interval",
       [](auto& lie) {
         lie.interval = announcement::min_interval;
         ++lie.revision, ++lie.sequence;
       }},
      {"a goodbye",
       [](auto& lie) {
         lie.kind = announcement::Kind::goodbye;
         lie.peers.clear();
         ++lie.sequence;
       }},
      {"another incarnation under its identifier", [](auto& lie) { lie.boot = announcement::BootNonce{66}; }},
  };
}

TEST(Liar, EmptiesRedirectsOrHidesNobodyForLongerThanTwoIntervals) {
  for (const auto& lie : lies()) {
    for (const bool is_own_address : {false, true}) {
      Attack attack(World::seed_or(21));
      for (int i = 0; i < 3; ++i) {
        auto forged = attack.liar.last_state(attack.victim());
        lie.forge(forged);
        // A clash is another matter: both who have an identifier give it up.
        if (forged.boot == announcement::BootNonce{66} && !is_own_address) continue;
        attack.liar.say(forged, is_own_address ? stranger : Liar::address_of(attack.victim()));
        // A host that hears the goodbye before the lie takes the liar for a newcomer, which goes at its deadline.
        attack.world.run_for(forged.boot == announcement::BootNonce{66} ? 3 * interval : 2 * interval);
        attack.expect_right(lie.what);
        attack.world.run_for(seconds(20));
        attack.expect_right(lie.what + ", later");
      }
    }
  }
}

TEST(Liar, GoesOnWithoutEffectOnWhatIsSaidAgain) {
  for (const auto& lie : lies()) {
    if (lie.what == "another incarnation under its identifier")
      continue;  // a clash: both who have an identifier give it up
    Attack attack(World::seed_or(22));
    int right = 0;
    for (int i = 0; i < 600; ++i) {
      auto forged = attack.liar.last_state(attack.victim());
      lie.forge(forged);
      attack.liar.say(forged, Liar::address_of(attack.victim()));
      attack.world.run_for(milliseconds(100));
      right += attack.team.is_right() ? 1 : 0;
    }
    EXPECT_GE(right, 600 - 25) << lie.what << ": wrong for longer than from one announcement to the next";
    attack.world.run_for(2 * interval);
    attack.expect_right(lie.what + ", after it");
  }
}

TEST(Liar, SaysGoodbyeEverySecondAndHidesNobodyAfterTheFirst) {
  Attack attack(World::seed_or(23));
  for (int i = 0; i < 60; ++i) {
    auto goodbye = attack.liar.last_state(attack.victim());
    goodbye.kind = announcement::Kind::goodbye;
    goodbye.peers.clear();
    ++goodbye.sequence;
    attack.liar.say(goodbye, Liar::address_of(attack.victim()));
    attack.world.run_for(seconds(1));
    if (i >= 3) attack.expect_right("after goodbye " + std::to_string(i));
  }
}

TEST(Liar, CopiesDatagramsFromAnotherAddressWithoutEffect) {
  Attack attack(World::seed_or(24));
  for (int i = 0; i < 30; ++i) {
    attack.liar.replay(attack.victim(), stranger);
    attack.world.run_for(milliseconds(100));
    attack.expect_right("after replay " + std::to_string(i));
    attack.world.run_for(seconds(1));
    attack.expect_right("a second later");
  }
}

TEST(Liar, FloodsWithAHundredThousandIdentitiesAndKeepsNoRobotOut) {
  const auto count = test::rounds<std::uint32_t>(100'000);
  const std::uint32_t arrival = count * 3 / 10;
  for (const auto& [sources, copies] : {std::pair{1U, 1U}, {250U, 1U}, {250U, 2U}}) {
    Attack attack(World::seed_or(25));
    auto forged = attack.liar.last_state(attack.victim());
    forged.peers.clear();
    forged.interval = announcement::max_interval;
    for (std::uint32_t number = 0; number < count; ++number) {
      const auto identity = number / copies;
      forged.participant = ParticipantId{0x10000000 + identity};
      forged.boot = announcement::BootNonce{identity};
      forged.sequence = number;
      attack.liar.say(forged, "10.0.7." + std::to_string(1 + identity % sources));
      if (number % 10 == 9) attack.world.run_for(milliseconds(1));
      if (number == arrival) attack.add("robot4");
      // The team complains by itself about whoever is missing for longer than two intervals.
      if (number > arrival + 10'000 * 4 && number % 1000 == 0) attack.expect_right("in the flood");
    }
    attack.world.run_for(2 * interval);
    attack.expect_right("after the flood");
  }
}

TEST(Liar, FloodsWithServicesAndLeavesRoomForThoseOfARobot) {
  Attack attack(World::seed_or(26));
  auto forged = attack.liar.last_state(attack.victim());
  auto one = forged.peers.at(0).publications.at(0);
  one.publication.identity = TextIdentity{"nonsense"};
  one.publication.attributes.clear();
  for (std::uint32_t participant = 1; participant <= 9; ++participant) {
    forged.participant = ParticipantId{0x10000000 + participant};
    forged.boot = announcement::BootNonce{participant};
    forged.peers = {{PeerId{1}, "liar", {}, {}, {}, {}}};
    for (std::uint32_t number = 1; number <= announcement::max_services_per_participant; ++number) {
      one.number = number;
      forged.peers[0].publications.push_back(one);
    }
    for (int copy = 0; copy < 2; ++copy, forged.sequence += 1000) attack.liar.say(forged, stranger);
    attack.world.run_for(milliseconds(10));
  }
  attack.team.modules().front()->offer("ball", "otm/stream");
  attack.world.run_for(milliseconds(5));
  attack.expect_right("with all room taken");
}

}  // namespace
}  // namespace geminga::sim
