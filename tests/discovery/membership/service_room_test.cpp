// The room for services of one neighbour, and of all together.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "discovery/announcement/limits.hpp"
#include "discovery/membership/table_rig.hpp"

namespace geminga::membership {
namespace {

/// The services 1 to `count`, in as many parts of at most 200 as needed.
void hear_many(TableRig& rig, std::uint32_t id, std::uint64_t revision, std::uint32_t count) {
  const auto parts = (count + 199) / 200;
  for (std::uint32_t part = 0; part < parts; ++part) {
    std::vector<std::uint32_t> numbers;
    for (auto number = part * 200 + 1; number <= std::min(count, (part + 1) * 200); ++number) numbers.push_back(number);
    auto announcement = speaker(id, revision, numbers);
    announcement.part = part;
    announcement.part_count = parts;
    (void)rig.hear(announcement);
  }
}

TEST(NeighbourServices, AreTakenUpToTheNamedNumberOfOneParticipant) {
  for (const auto count : {announcement::max_services_per_participant - 1, announcement::max_services_per_participant,
                           announcement::max_services_per_participant + 1}) {
    TableRig rig;
    hear_many(rig, 1, 1, static_cast<std::uint32_t>(count));
    EXPECT_EQ(rig.table.neighbours().find(ParticipantId{1})->publications,
              std::min(count, announcement::max_services_per_participant));
    EXPECT_EQ(rig.table.refused_services(), count > announcement::max_services_per_participant ? 1U : 0U);
    // The list may be incomplete, so it withdraws nothing.
    EXPECT_EQ(rig.table.neighbours().find(ParticipantId{1})->is_complete,
              count <= announcement::max_services_per_participant);
  }
}

TEST(NeighbourServices, AreTakenUpToTheNamedNumberOfAllBeyondTheReserveOfEach) {
  TableRig rig;
  constexpr auto beyond = announcement::max_services_per_participant - announcement::reserved_services;
  const auto full = static_cast<std::uint32_t>(announcement::max_remote_services / beyond);
  for (std::uint32_t id = 1; id <= full; ++id) hear_many(rig, id, 1, announcement::max_services_per_participant);
  const auto left = announcement::max_remote_services - full * beyond;
  EXPECT_EQ(rig.table.refused_services(), 0U);
  hear_many(rig, full + 1, 1, static_cast<std::uint32_t>(announcement::reserved_services + left));
  EXPECT_EQ(rig.table.refused_services(), 0U);
  hear_many(rig, full + 2, 1, announcement::reserved_services);
  EXPECT_EQ(rig.table.refused_services(), 0U);
  EXPECT_EQ(rig.table.neighbours().find(ParticipantId{full + 2})->publications, announcement::reserved_services);
  // The stranger is given nothing beyond its reserve.
  rig.source = "10.0.0.66";
  (void)rig.hear(speaker(full + 3, 1, {1}));
  auto greedy = speaker(full + 3, 2, {});
  for (std::uint32_t number = 1; number <= announcement::reserved_services + 1; ++number) {
    greedy.peers[0].publications.push_back({number, announcement::simple_publication()});
  }
  greedy.participant = ParticipantId{full + 4};
  greedy.boot = announcement::BootNonce{full + 4};
  (void)rig.hear(greedy);
  EXPECT_EQ(rig.table.refused_services(), 1U);
  EXPECT_EQ(rig.table.neighbours().find(ParticipantId{full + 4})->publications, announcement::reserved_services);
  // Room that is given back is used again.
  rig.source.clear();
  (void)rig.hear(speaker(1, 2, {1}));
  rig.source = "10.0.0.66";
  (void)rig.hear(greedy);
  EXPECT_EQ(rig.table.neighbours().find(ParticipantId{full + 4})->publications, announcement::reserved_services + 1);
}

TEST(NeighbourServices, OfSomebodyWhoLeftGiveOnlyTheRoomThatTheyTook) {
  for (const auto left : {1U, 32U, 33U, 34U}) {
    TableRig rig;
    hear_many(rig, 100, 1, left);
    for (std::uint32_t id = 1; id <= 9; ++id) hear_many(rig, id, 1, announcement::max_services_per_participant);
    auto goodbye = speaker(100, 1, {});
    goodbye.kind = announcement::Kind::goodbye;
    ASSERT_EQ(rig.hear(goodbye), Hearing::goodbye);
    const auto beyond_reserve = [&] {
      std::size_t count = 0;
      rig.table.neighbours().for_each([&](const Neighbour& each) {
        count += each.publications - std::min(each.publications, announcement::reserved_services);
      });
      return count;
    };
    for (std::uint32_t id = 101; id <= 120; ++id) {
      rig.source = "10.0.1." + std::to_string(id);
      for (int copy = 0; copy < 2; ++copy) hear_many(rig, id, 1, 300);
      EXPECT_LE(beyond_reserve(), announcement::max_remote_services) << left;
    }
  }
}

TEST(NeighbourServices, UseAtMostTheNamedNumberOfWays) {
  TableRig rig;
  for (std::uint32_t link = 1; link <= announcement::max_paths + 1; ++link) {
    auto announcement = speaker(1, 1);
    announcement.link = link;
    (void)rig.hear(announcement, rig_start, env::InterfaceIndex{link});
    EXPECT_EQ(rig.table.neighbours().find(ParticipantId{1})->paths.size(),
              std::min<std::size_t>(link, announcement::max_paths));
  }
}

}  // namespace
}  // namespace geminga::membership
