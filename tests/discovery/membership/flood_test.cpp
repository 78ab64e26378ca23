// Places and room for services, when more is heard than can be remembered.
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "discovery/announcement/limits.hpp"
#include "discovery/membership/table_rig.hpp"
#include "support/rounds.hpp"

namespace geminga::membership {
namespace {

constexpr auto interval = seconds(2);
constexpr ParticipantId robot{7};

/// A table in a flood of ten thousand datagrams a second, and a true robot that announces itself: at once, by four
/// quick copies, then in each interval.
struct Flood {
  /// Each identity is sent `copies` times from one of `sources` addresses, `gap` apart.
  struct Shape {
    std::size_t sources = 1;
    std::size_t copies = 1;
    base::Duration gap = std::chrono::microseconds(100);
    bool is_of_robots_address = false;
  };

  Hearing hear(announcement::Announcement announcement, const std::string& source) {
    rig.source = source;
    const auto hearing = rig.hear(std::move(announcement), now);
    (void)rig.table.take_changes();
    return hearing;
  }
  Hearing say() {
    auto state = speaker(std::to_underlying(robot), 1);
    state.sequence = ++sequence;
    return hear(state, robots_address);
  }
  void pass_to(base::Instant instant) {
    now = instant;
    if (rig.table.next_deadline() <= now) rig.table.expire(now);
    (void)rig.table.take_changes();
  }
  /// The datagram with this number of the flood; 10^4 a second.
  void forge(const Shape& shape, std::uint64_t number) {
    // Copies of one identity are `gap` apart, and as many others come between them.
    const auto between = static_cast<std::uint64_t>(shape.gap / std::chrono::microseconds(100));
    const auto round = number / (between * shape.copies);
    const auto within = number % (between * shape.copies);
    const auto identity = static_cast<std::uint32_t>(1000 + round * between + within % between);
    auto state = speaker(identity, 1);
    state.sequence = 1 + within / between;
    state.interval = announcement::max_interval;
    const auto which = identity % shape.sources;
    (void)hear(state, shape.is_of_robots_address
                          ? robots_address
                          : "10.0." + std::to_string(1 + which / 250) + "." + std::to_string(1 + which % 250));
  }
  /// Lets the flood go on; the robot arrives after `arrival`. Returns for how long it was unknown from then on, in
  /// total.
  base::Duration run(const Shape& shape, base::Duration arrival, base::Duration time) {
    const std::array<base::Duration, 5> copies = {milliseconds(0), milliseconds(20), milliseconds(60),
                                                  milliseconds(140), milliseconds(300)};
    const auto arrives = now + arrival;
    const auto end = now + time;
    std::size_t said = 0;
    auto next = arrives;
    base::Duration unknown{};
    for (std::uint64_t number = 0; now < end; ++number) {
      pass_to(now + std::chrono::microseconds(100));
      forge(shape, number);
      if (now >= next) {
        (void)say();
        ++said;
        next = said < copies.size() ? arrives + copies.at(said) : next + interval;
      }
      if (now >= arrives && !rig.table.neighbours().is_known(robot)) unknown += std::chrono::microseconds(100);
    }
    return unknown;
  }

  TableRig rig;
  std::string robots_address = "10.0.0.7";
  base::Instant now = rig_start;
  std::uint64_t sequence = 0;
};

TEST(Flood, OfAHundredThousandIdentitiesKeepsNoTrueRobotOut) {
  const std::vector<Flood::Shape> shapes = {
      {.sources = 1, .copies = 1},
      {.sources = 250, .copies = 1},
      {.sources = 250, .copies = 2},
      {.sources = 250, .copies = 5},
      {.sources = 250, .copies = 5, .gap = milliseconds(75)},
      {.sources = 250, .copies = 5, .gap = interval},
      {.sources = 2500, .copies = 1},
      {.sources = 1, .copies = 1, .is_of_robots_address = true},
      {.sources = 1, .copies = 2, .is_of_robots_address = true},
      {.sources = 1, .copies = 5, .is_of_robots_address = true},
  };
  for (const auto& shape : shapes) {
    Flood flood;
    const auto unknown = flood.run(shape, seconds(3), seconds(3) + milliseconds(test::rounds(10'000)));
    const auto what = std::to_string(shape.sources) + " sources, " + std::to_string(shape.copies) + " copies";
    EXPECT_LE(unknown, 2 * interval) << what;
    EXPECT_TRUE(flood.rig.table.neighbours().is_known(robot)) << what;
    EXPECT_LE(flood.rig.table.neighbours().size(), announcement::max_participants) << what;
  }
}

TEST(Flood, ThatIsOverKeepsNoTrueRobotOut) {
  for (const auto copies : {1U, 2U, 5U}) {
    for (const bool is_same : {false, true}) {
      Flood flood;
      for (std::uint64_t number = 0; number < 10'000; ++number) {
        flood.pass_to(flood.now + std::chrono::microseconds(100));
        flood.forge({.sources = 1, .copies = copies, .is_of_robots_address = is_same}, number);
      }
      flood.pass_to(flood.now + milliseconds(100));
      EXPECT_EQ(flood.rig.table.neighbours().size(), announcement::max_participants);
      (void)flood.say();
      flood.pass_to(flood.now + milliseconds(20));
      (void)flood.say();
      EXPECT_TRUE(flood.rig.table.neighbours().is_known(robot)) << copies << " copies, the same address: " << is_same;
    }
  }
}

TEST(Flood, PushesNobodyOutWhoIsKnownForLong) {
  for (const auto known_for :
       {announcement::seasoned_after - milliseconds(1), base::Duration(announcement::seasoned_after)}) {
    Flood flood;
    // Four robots behind one address have the most places of all; the newest would give way first.
    const auto say_all = [&] {
      for (std::uint32_t id = 1; id <= 4; ++id) (void)flood.hear(speaker(id, 1), "10.0.0.9");
    };
    say_all();
    for (base::Duration time{}; time < known_for;) {
      const auto step = std::min(known_for - time, base::Duration(interval));
      flood.pass_to(flood.now + step);
      time += step;
      say_all();
    }
    for (std::uint32_t id = 0; id < 2 * announcement::max_participants; ++id) {
      (void)flood.hear(speaker(1000 + id, 1), "10.1." + std::to_string(id / 250) + "." + std::to_string(id % 250));
    }
    std::size_t left = 0;
    for (std::uint32_t id = 1; id <= 4; ++id) left += flood.rig.table.neighbours().is_known(ParticipantId{id}) ? 1 : 0;
    if (known_for == announcement::seasoned_after) {
      EXPECT_EQ(left, 4U);
    } else {
      EXPECT_EQ(left, 1U) << "a share of one, since there are more addresses than places";
    }
  }
}

TEST(Flood, LetsOneAddressHaveOnlyTheNamedNumberForGood) {
  for (const auto count : {announcement::max_seasoned_per_source - 1, announcement::max_seasoned_per_source,
                           announcement::max_seasoned_per_source + 1}) {
    Flood flood;
    for (base::Duration time{}; time <= announcement::seasoned_after; time += interval) {
      for (std::uint32_t id = 1; id <= count; ++id) (void)flood.hear(speaker(id, 1), "10.0.0.9");
      flood.pass_to(flood.now + interval);
    }
    for (std::uint32_t id = 1; id <= count; ++id) (void)flood.hear(speaker(id, 1), "10.0.0.9");
    for (std::uint32_t id = 0; id < 1000; ++id) {
      (void)flood.hear(speaker(1000 + id, 1), "10.1." + std::to_string(id / 250) + "." + std::to_string(id % 250));
    }
    std::size_t left = 0;
    for (std::uint32_t id = 1; id <= count; ++id)
      left += flood.rig.table.neighbours().is_known(ParticipantId{id}) ? 1 : 0;
    EXPECT_EQ(left, std::min(count, announcement::max_seasoned_per_source));
  }
}

TEST(Flood, TakesPlacesUpToTheNamedNumberAndFromTheGreediestAddressAfterThat) {
  TableRig rig;
  rig.source = "10.0.0.66";
  for (std::uint32_t id = 1; id <= announcement::max_participants; ++id) {
    EXPECT_EQ(rig.table.neighbours().size(), id - 1);
    EXPECT_EQ(rig.hear(speaker(id, 1)), Hearing::newcomer) << id;
  }
  EXPECT_EQ(rig.hear(speaker(announcement::max_participants + 1, 1)), Hearing::full);
  rig.source = "10.0.0.7";
  EXPECT_EQ(rig.hear(speaker(announcement::max_participants + 2, 1)), Hearing::newcomer);
  EXPECT_EQ(rig.table.neighbours().size(), announcement::max_participants);
  EXPECT_TRUE(rig.table.neighbours().is_known(ParticipantId{announcement::max_participants + 2}));
  rig.source = "10.0.0.66";
  auto goodbye = speaker(announcement::max_participants, 1);
  goodbye.kind = announcement::Kind::goodbye;
  EXPECT_EQ(rig.hear(goodbye), Hearing::goodbye);
  EXPECT_EQ(rig.hear(speaker(announcement::max_participants + 1, 1)), Hearing::newcomer);
}

std::string address_of(std::uint32_t which) {
  return "10.1." + std::to_string(which / 250) + "." + std::to_string(which % 250);
}

TEST(Flood, FillsNotThePlaceOfASeasonedRobotInWhoseNameItSaysGoodbye) {
  for (const bool is_filler_proved : {false, true}) {
    Flood flood;
    // Each participant has one place and an address of its own, and keeps it alive.
    const auto keep = [&] {
      for (std::uint32_t id = 1; id < announcement::max_participants; ++id)
        (void)flood.hear(speaker(1000 + id, 1), address_of(id));
    };
    const auto pass = [&](base::Duration time) { flood.pass_to(flood.now + time); };
    for (base::Duration time{}; time <= announcement::seasoned_after; time += interval, pass(interval)) {
      keep();
      (void)flood.say();
    }
    ASSERT_EQ(flood.rig.table.neighbours().size(), announcement::max_participants);
    auto goodbye = speaker(std::to_underlying(robot), 0, {});
    goodbye.kind = announcement::Kind::goodbye;
    ASSERT_EQ(flood.hear(goodbye, flood.robots_address), Hearing::goodbye);
    for (int i = 0; i < (is_filler_proved ? 6 : 1); ++i, pass(milliseconds(500))) {
      (void)flood.hear(speaker(5000, 1), "10.9.9.9");
    }
    keep();
    EXPECT_EQ(flood.say(), Hearing::returned) << is_filler_proved;
    EXPECT_TRUE(flood.rig.table.neighbours().is_known(robot));
    EXPECT_EQ(flood.rig.table.neighbours().size(), announcement::max_participants);
  }
}

TEST(Flood, ThatFallsSilentGivesWayThoughOneOfItGoesOn) {
  // This holds for each address: the order of their names guards no place.
  for (const std::uint32_t goes_on : {0U, 100U, 255U}) {
    Flood flood;
    const auto pass = [&](base::Duration time) { flood.pass_to(flood.now + time); };
    for (int i = 0; i < 3; ++i, pass(interval)) {
      for (std::uint32_t id = 0; id < announcement::max_participants; ++id) {
        auto state = speaker(1000 + id, 1);
        state.interval = announcement::max_interval;
        (void)flood.hear(state, address_of(id));
      }
    }
    base::Duration unknown{};
    for (int i = 0; i < 10; ++i) {
      (void)flood.hear(speaker(1000 + goes_on, 1), address_of(goes_on));
      (void)flood.say();
      if (flood.rig.table.neighbours().is_known(robot)) break;
      pass(interval);
      unknown += interval;
    }
    EXPECT_LE(unknown, 2 * interval) << goes_on;
  }
}

TEST(Flood, OfOneDatagramWithTheHighestNumberKeepsNoWaitingStrangerOut) {
  Flood flood;
  for (std::uint32_t id = 0; id < announcement::max_participants; ++id) {
    auto state = speaker(1000 + id, 1);
    state.interval = announcement::max_interval;
    for (int i = 0; i < 2; ++i) (void)flood.hear(state, address_of(id));
  }
  flood.pass_to(flood.now + seconds(3));
  for (std::uint32_t id = 0; id < announcement::max_participants; ++id) {
    (void)flood.hear(speaker(1000 + id, 1), flood.robots_address);
  }
  auto forged = speaker(std::to_underlying(robot), 1);
  forged.sequence = ~std::uint64_t{0};
  (void)flood.hear(forged, flood.robots_address);
  base::Duration unknown{};
  for (const auto step : {milliseconds(20), milliseconds(40), milliseconds(80), milliseconds(160), milliseconds(1700),
                          milliseconds(2000)}) {
    (void)flood.say();
    if (flood.rig.table.neighbours().is_known(robot)) break;
    flood.pass_to(flood.now + step);
    unknown += step;
  }
  EXPECT_TRUE(flood.rig.table.neighbours().is_known(robot)) << "after " << unknown / milliseconds(1) << " ms";
}

/// All services from 1 to `count`, in as many parts as needed.
void offer(Flood& flood, std::uint32_t id, std::uint32_t count, const std::string& source) {
  const auto parts = (count + 99) / 100;
  for (std::uint32_t part = 0; part < parts; ++part) {
    std::vector<std::uint32_t> numbers;
    for (auto number = part * 100 + 1; number <= std::min(count, (part + 1) * 100); ++number) numbers.push_back(number);
    auto state = speaker(id, count, numbers);
    state.part = part;
    state.part_count = parts;
    (void)flood.hear(state, source);
  }
}

TEST(Flood, OfServicesLeavesRoomForThoseOfARobot) {
  for (const auto* source : {"10.0.0.66", "10.0.0.7"}) {
    Flood flood;
    offer(flood, std::to_underlying(robot), 10, "10.0.0.7");
    for (std::uint32_t id = 1001; id <= 1009; ++id)
      offer(flood, id, announcement::max_services_per_participant, source);
    EXPECT_GT(flood.rig.table.refused_services(), 0U);
    for (const std::uint32_t count : {11U, 16U, 32U, 33U, 200U}) {
      offer(flood, std::to_underlying(robot), count, "10.0.0.7");
      EXPECT_EQ(flood.rig.table.neighbours().find(robot)->publications, count) << source;
    }
  }
}

TEST(Flood, OfServicesLeavesTheReserveToEveryStranger) {
  Flood flood;
  for (std::uint32_t id = 1001; id <= 1009; ++id)
    offer(flood, id, announcement::max_services_per_participant, "10.0.0.66");
  offer(flood, std::to_underlying(robot), announcement::reserved_services, "10.0.0.66");
  EXPECT_EQ(flood.rig.table.neighbours().find(robot)->publications, announcement::reserved_services);
}

}  // namespace
}  // namespace geminga::membership
