// A forger that knows everything and may send anything from any address plays at random against the rules of
// ANNOUNCEMENT.md ("Whose an identifier is", "Who is believed"), while its victim only goes on announcing itself.
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <string>

#include "discovery/announcement/limits.hpp"
#include "discovery/membership/forged_rig.hpp"
#include "support/rounds.hpp"

namespace geminga::membership {
namespace {

constexpr const char* own = "10.0.0.1";
/// Two announcements of the victim, which are up to a tenth longer than an interval apart.
constexpr base::Duration longest_interval = base::Duration(interval) + base::Duration(interval) / 10;
constexpr base::Duration two_intervals = 2 * longest_interval;

struct Walk {
  explicit Walk(std::uint64_t seed) : random(seed) {}

  /// Checks that the victim is there with exactly the services that it says, whatever else is said in its name.
  [[nodiscard]] bool is_there() const {
    const auto known = air.rig.table.neighbours().find(victim);
    if (!known || known->boot != announcement::BootNonce{1}) return false;
    const std::string publication = "10.0.0.1:5000 of robot1/vision";
    return std::ranges::all_of(std::array{5U, 6U, 7U}, [&](std::uint32_t number) {
      const auto is = air.registry.services.find({victim, PeerId{1}, number});
      return is != air.registry.services.end() && is->second == (number == 7 ? "sub of robot1/vision" : publication);
    });
  }

  std::uint64_t any_number(std::uint64_t near) {
    return random.chance(0.7) ? near + random.below(4) : random.next() >> random.below(64);
  }
  std::string any_address() { return random.chance(0.5) ? own : "10.0.0." + std::to_string(66 + random.below(3)); }
  announcement::Kind any_kind() {
    const auto kind = random.unit();
    if (kind < 0.4) return announcement::Kind::state;
    if (kind < 0.6) return announcement::Kind::change;
    if (kind < 0.7) return announcement::Kind::presence;
    return kind < 0.88 ? announcement::Kind::goodbye : announcement::Kind::claim;
  }
  void make_change(announcement::Announcement& word) {
    word.revision += 1;
    word.since = word.revision - 1 - random.below(word.revision);
    for (auto& peer : word.peers) {
      std::erase_if(peer.publications, [&](const auto& entry) {
        if (random.chance(0.5)) return false;
        if (random.chance(0.7)) peer.removed.push_back(entry.number);
        return true;
      });
    }
  }
  announcement::Announcement any_word() {
    // The victim's announcements, others' under any identifier, or nonsense.
    base::Random words(random.next());
    auto word = random.chance(0.6) ? air.truth() : announcement::random_announcement(words);
    word.group = "default";
    word.participant = random.chance(0.8) ? victim : ParticipantId(100 + random.below(20));
    word.boot = random.chance(0.5) ? announcement::BootNonce{1} : announcement::BootNonce{66 + random.below(4)};
    word.link = random.chance(0.8) ? 0 : static_cast<std::uint32_t>(random.below(3));
    word.sequence = any_number(air.sequence);
    word.revision = any_number(air.revision);
    word.interval = random.chance(0.7) ? interval : milliseconds(50 + random.below(59'950));
    if (random.chance(0.2)) word.peers.clear();
    if (random.chance(0.2)) word.addresses = {"10.0.0.66"};
    if (random.chance(0.1)) word.part_count = static_cast<std::uint32_t>(1 + random.below(4));
    word.kind = any_kind();
    if (word.kind == announcement::Kind::presence) word.peers.clear();
    if (word.kind == announcement::Kind::change) make_change(word);
    return word;
  }
  /// Sends one announcement, and often the same again or a slightly changed one, so that whole plots arise.
  void move() {
    if (random.chance(0.4)) {
      last = any_word();
      last_source = any_address();
    } else {
      if (random.chance(0.5)) last.sequence += random.below(3);
      if (random.chance(0.3)) last.kind = random.chance(0.5) ? announcement::Kind::goodbye : announcement::Kind::state;
      if (random.chance(0.2)) last.boot = announcement::BootNonce{66 + random.below(4)};
      if (random.chance(0.2)) last.participant = victim;
    }
    const bool is_victims = last.participant == victim && last.boot == announcement::BootNonce{1} && last_source == own;
    // A forger that speaks first in its name and incarnation, from its address, cannot be told from it.
    if (is_victims && !has_spoken) return;
    (void)air.hear(last, last_source);
  }
  /// Lets time go by. The victim speaks when it is due, and the forger so often.
  void live(base::Duration time, double moves_a_second, bool is_watched) {
    constexpr base::Duration step = milliseconds(20);
    for (const auto end = air.now + time; air.now < end; air.pass(step)) {
      // A doubted participant answers: a forger of claims can pretend that its next incarnation has begun.
      if (const auto doubts = air.rig.table.report(air.now).doubts; std::ranges::find(doubts, victim) != doubts.end()) {
        (void)air.say();
      }
      if (air.now >= next) {
        (void)air.say();
        has_spoken = true;
        next = copies > 0 ? air.now + milliseconds(80)
                          : air.now + random.between(longest_interval - base::Duration(interval) / 5, longest_interval);
        copies -= copies > 0 ? 1 : 0;
      }
      for (double left = moves_a_second * 0.02; left > 0; --left) {
        if (left >= 1 || random.chance(left)) move();
        watch(is_watched);
      }
      watch(is_watched);
    }
  }
  void watch(bool is_watched) {
    if (is_there()) right = air.now;
    if (is_watched) longest = std::max(longest, air.now - right);
  }

  base::Random random;
  Air air;
  announcement::Announcement last;
  std::string last_source;
  bool has_spoken = false;
  int copies = 4;
  base::Instant next = rig_start;
  base::Instant right = rig_start;
  base::Duration longest{};
};

TEST(ForgerWalk, HidesNobodyForLongerThanTwoIntervalsAndLeavesNothingBehind) {
  // About one walk in 400 hides a participant for up to twice as long: see ANNOUNCEMENT.md, "Whose
  // an identifier is".
  std::uint64_t longer = 0;
  // About one of 500 makes the table believe a longer interval, of up to a minute: two of those take the place then.
  std::uint64_t much_longer = 0;
  std::uint64_t left_behind = 0;
  const std::uint64_t walks = test::rounds(1000U);
  for (std::uint64_t seed = 1; seed <= walks; ++seed) {
    Walk walk(seed);
    const double rate = 0.5 + 20 * walk.random.unit() * walk.random.unit();
    auto claim = walk.air.truth();
    claim.kind = announcement::Kind::claim;
    claim.peers.clear();
    (void)walk.air.say(claim);
    walk.next = walk.air.now + milliseconds(90);
    if (walk.random.chance(0.5)) walk.live(milliseconds(100), 100, false);
    walk.live(seconds(5), walk.random.chance(0.5) ? 0 : rate, false);
    walk.right = walk.air.now;
    walk.live(seconds(60), rate, true);
    walk.live(two_intervals, 0, true);
    ASSERT_LE(walk.longest, 2 * announcement::max_interval) << "seed " << seed;
    much_longer += walk.longest > 2 * two_intervals ? 1 : 0;
    longer += walk.longest > two_intervals ? 1 : 0;
    const auto is_right = [&] {
      (void)walk.air.say();
      std::erase_if(walk.air.registry.services, [](const auto& each) { return each.first.participant != victim; });
      return walk.air.is_right();
    };
    if (is_right()) continue;
    ++left_behind;
    for (const auto end = walk.air.now + 4 * announcement::max_interval; walk.air.now < end && !is_right();) {
      walk.live(longest_interval, 0, false);
    }
    ASSERT_TRUE(is_right()) << "seed " << seed << "\n" << testing::PrintToString(walk.air.registry.services);
  }
  std::cerr << longer << " of " << walks << " walks hid it for longer than two intervals, " << much_longer
            << " for longer than four\n";
  EXPECT_LE(longer, 2 + walks / 250);
  EXPECT_LE(much_longer, 1 + walks / 500);
  EXPECT_LE(left_behind, 1 + walks / 500);
}

TEST(ForgerWalk, InATableThatIsFullHidesNobodyWhoIsKnownForLong) {
  int longer = 0;
  for (std::uint64_t seed = 1; seed <= test::rounds(20U); ++seed) {
    Walk walk(seed);
    const auto fill = [&] {
      for (std::uint32_t id = 1000; id < 1000 + announcement::max_participants + 44; ++id) {
        if (!walk.random.chance(0.95)) continue;
        const auto address = "10.1." + std::to_string(id / 250) + "." + std::to_string(id % 250);
        (void)walk.air.hear(speaker(id, 1, {}), address);
      }
    };
    walk.live(announcement::seasoned_after + two_intervals, 0, false);
    for (int i = 0; i < 30; ++i) {
      fill();
      walk.live(interval, 10, true);
      ASSERT_LE(walk.air.rig.table.neighbours().size(), announcement::max_participants) << "seed " << seed;
    }
    ASSERT_LE(walk.longest, 2 * two_intervals) << "seed " << seed;
    longer += walk.longest > two_intervals ? 1 : 0;
  }
  EXPECT_LE(longer, 1);
}

TEST(ForgerWalk, WithServicesKeepsEveryLimit) {
  for (std::uint64_t seed = 1; seed <= test::rounds(5U); ++seed) {
    base::Random random(seed);
    TableRig rig;
    auto now = rig_start;
    for (int i = 0; i < 150; ++i) {
      const auto id = static_cast<std::uint32_t>(1 + random.below(20));
      rig.source = "10.0.0." + std::to_string(1 + random.below(4));
      std::vector<std::uint32_t> numbers(random.chance(0.5) ? announcement::max_services_per_participant + 1
                                                            : random.below(80));
      for (std::uint32_t number = 0; number < numbers.size(); ++number) numbers[number] = number + 1;
      auto state = speaker(id, random.below(4), numbers);
      state.boot = announcement::BootNonce{id + 100 * random.below(2)};
      state.kind = random.chance(0.7) ? announcement::Kind::state : announcement::Kind::goodbye;
      (void)rig.hear(state, now);
      now += milliseconds(random.below(300));
      rig.table.expire(now);
      std::size_t beyond_reserve = 0;
      rig.table.neighbours().for_each([&](const Neighbour& each) {
        ASSERT_LE(each.publications, announcement::max_services_per_participant);
        beyond_reserve += each.publications - std::min(each.publications, announcement::reserved_services);
      });
      ASSERT_LE(beyond_reserve, announcement::max_remote_services) << "seed " << seed;
      (void)rig.table.take_changes();
    }
  }
}

}  // namespace
}  // namespace geminga::membership
