// Somebody on the link, without a key, wants a dead robot to be taken for alive. ANNOUNCEMENT.md, "What cannot be held
// without keys", has the bounds. GEMINGA_SEED chooses another seed.
#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "discovery/announcement/limits.hpp"
#include "discovery/membership/schedule/deadline.hpp"
#include "sim/liar.hpp"
#include "sim/robots.hpp"

namespace geminga::sim {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr const char* stranger = "10.0.0.66";
constexpr auto interval = seconds(2);
/// The deadline where nothing is lost, and a tenth of a second until the last has told its clients.
constexpr base::Duration one_deadline = base::Duration(interval) * 9 / 4 + milliseconds(100);

/// Four robots, one of which dies, and somebody who goes on speaking of it.
struct Grave {
  explicit Grave(std::uint64_t seed)
      : robots(World::seed_or(seed), 4, {}, {.missing = seconds(30), .surplus = std::chrono::minutes(10)}),
        liar(robots.world) {
    robots.team.ledger().tampered_until(base::never);
    robots.start();
    robots.world.run_for(seconds(70));
    EXPECT_TRUE(robots.team.is_right()) << robots.team.complaints();
  }
  [[nodiscard]] Host& dead() { return robots.host(1); }
  [[nodiscard]] std::string its_address() { return Liar::address_of(dead()); }

  /// The time from its death until all are right about it, while somebody speaks twice a second.
  base::Duration told(const std::function<void(int word)>& speak) {
    dead().crash();
    const auto died = robots.world.now();
    for (int word = 1; !robots.team.is_right() && robots.world.now() - died < seconds(80); ++word) {
      speak(word);
      for (int i = 0; i < 50 && !robots.team.is_right(); ++i) robots.world.run_for(milliseconds(10));
    }
    return robots.world.now() - died;
  }

  Robots robots;
  Liar liar;
};

TEST(GraveRobber, ThatGoesOnWithAPresenceFromItsOwnAddressDelaysNothing) {
  Grave grave(81);
  auto presence = grave.liar.last_presence(grave.dead());
  EXPECT_LE(grave.told([&](int) {
    ++presence.sequence;
    grave.liar.say(presence, stranger);
  }),
            one_deadline);
}

TEST(GraveRobber, ThatGoesOnWithAStateFromItsOwnAddressHasTheDeadRobotGoneForFiveIntervals) {
  Grave grave(82);
  auto state = grave.liar.last_state(grave.dead());
  EXPECT_LE(grave.told([&](int) {
    ++state.sequence;
    grave.liar.say(state, stranger);
  }),
            one_deadline);
  // It may invent a participant, of whatever name; the place of the dead one is kept until nothing can come late.
  const auto died = grave.robots.world.now() - one_deadline;
  while (grave.robots.world.now() - died < seconds(8)) {
    ++state.sequence;
    grave.liar.say(state, stranger);
    grave.robots.world.run_for(milliseconds(500));
    EXPECT_TRUE(grave.robots.team.is_right()) << grave.robots.world.when() << grave.robots.team.complaints();
  }
}

TEST(GraveRobber, ThatMovesTheDeadRobotToItsOwnAddressHasItsServicesThereAndNotWhereTheyWere) {
  Grave grave(90);
  auto state = grave.liar.last_state(grave.dead());
  state.addresses = {stranger};
  ++state.revision;
  Client& observer = grave.robots.world.add_client("observer");
  observer.connect(grave.robots.host(0));
  observer.say("1 sub create mode=otm/stream limit=0 text=ball");
  grave.robots.team.is_excused = true;
  (void)grave.told([&](int) {
    ++state.sequence;
    grave.liar.say(state, stranger);
  });
  for (const auto& [service, line] : observer.view(1)) EXPECT_NE(line.value("address"), Liar::address_of(grave.dead()));
}

TEST(GraveRobber, ThatSpeaksBeforeTheDeathDelaysNothing) {
  Grave grave(83);
  for (int i = 0; i < 40; ++i) {
    auto presence = grave.liar.last_presence(grave.dead());
    presence.sequence += 1;
    grave.liar.say(presence, stranger);
    grave.robots.world.run_for(milliseconds(500));
  }
  auto presence = grave.liar.last_presence(grave.dead());
  EXPECT_LE(grave.told([&](int) {
    ++presence.sequence;
    grave.liar.say(presence, stranger);
  }),
            one_deadline);
}

TEST(GraveRobber, ThatOpensAnotherWayDelaysNothing) {
  Grave grave(84);
  auto presence = grave.liar.last_presence(grave.dead());
  presence.link += 7;
  for (int i = 0; i < 20; ++i) {
    ++presence.sequence;
    grave.liar.say(presence, stranger);
    grave.robots.world.run_for(milliseconds(500));
  }
  EXPECT_LE(grave.told([&](int) {
    ++presence.sequence;
    grave.liar.say(presence, stranger);
  }),
            one_deadline);
}

TEST(GraveRobber, ThatRepeatsItsLastWordFromItsAddressDelaysNothing) {
  Grave grave(85);
  const auto presence = grave.liar.last_presence(grave.dead());
  EXPECT_LE(grave.told([&](int) { grave.liar.say(presence, grave.its_address()); }), one_deadline);
}

TEST(GraveRobber, ThatCountsOnFromItsAddressCannotBeToldFromItAndIsHeardOneDeadlineAfterItsLastWord) {
  Grave grave(86);
  auto presence = grave.liar.last_presence(grave.dead());
  constexpr int words = 40;
  EXPECT_LE(grave.told([&](int word) {
    ++presence.sequence;
    if (word <= words) grave.liar.say(presence, grave.its_address());
  }),
            words * milliseconds(500) + one_deadline);
}

TEST(GraveRobber, ThatTestifiesDelaysByOneDeadlineAtMost) {
  Grave grave(87);
  auto witness = grave.liar.last_state(grave.robots.host(0));
  witness.participant = ParticipantId{0x77777777};
  witness.boot = announcement::BootNonce{77};
  witness.name = "witness";
  witness.peers.clear();
  witness.addresses = {stranger};
  witness.revision = 1;
  witness.sequence = 0;
  const auto speak = [&](int) {
    // It knows whom all others know, and has just heard of everybody.
    auto presence = grave.liar.last_presence(grave.robots.host(0));
    const auto members = presence.witness.heard.size();
    presence.participant = witness.participant;
    presence.boot = witness.boot;
    presence.revision = witness.revision;
    presence.sequence = ++witness.sequence;
    presence.witness.heard.assign(members, announcement::HeardWithin::quarter);
    grave.liar.say(presence, stranger);
  };
  for (int copy = 0; copy < 3; ++copy) {
    ++witness.sequence;
    grave.liar.say(witness, stranger);
    grave.robots.world.run_for(milliseconds(20));
  }
  for (int word = 0; word < 20; ++word) {
    speak(word);
    grave.robots.world.run_for(milliseconds(500));
  }
  const auto told = grave.told(speak);
  EXPECT_GT(told, one_deadline) << "the lie is believed by some at all";
  EXPECT_LE(told, 2 * one_deadline);
}

TEST(GraveRobber, ThatAnnouncesALongIntervalJustBeforeTheDeathDelaysNothing) {
  for (const int words : {1, 2, 5}) {
    Grave grave(88);
    auto state = grave.liar.last_state(grave.dead());
    state.interval = announcement::max_interval;
    ++state.revision;
    for (int i = 0; i < words; ++i) {
      ++state.sequence;
      grave.liar.say(state, grave.its_address());
      grave.robots.world.run_for(milliseconds(5));
    }
    EXPECT_LE(grave.told([](int) {}), one_deadline) << words;
  }
}

TEST(GraveRobber, ThatAnnouncesALongIntervalAtTheTruePaceAfterTheDeathGainsADoublingForEachInterval) {
  Grave grave(89);
  auto state = grave.liar.last_state(grave.dead());
  state.interval = announcement::max_interval;
  ++state.revision;
  constexpr int words = 9;  // one each half second: two intervals
  const auto speak = [&](int word) {
    ++state.sequence;
    if (word <= words) grave.liar.say(state, grave.its_address());
  };
  // After one interval twice the old one is believed, and after two of those as much again.
  EXPECT_LE(grave.told(speak), words * milliseconds(500) + 2 * one_deadline);
}

}  // namespace
}  // namespace geminga::sim
