// Changes: announcements of what differs from an earlier revision.
#include <gmock/gmock.h>

#include "discovery/membership/table_rig.hpp"

namespace geminga::membership {
namespace {

using ::testing::ElementsAre;

constexpr ParticipantId robot{1};

/// A change from revision `since` to `revision`, with new or modified services and removed ones.
announcement::Announcement change_of(std::uint64_t since, std::uint64_t revision,
                                     const std::vector<std::uint32_t>& numbers,
                                     const std::vector<std::uint32_t>& removed = {}) {
  auto change = speaker(1, revision, numbers);
  change.kind = announcement::Kind::change;
  change.since = since;
  change.name.clear();
  change.addresses.clear();
  change.peers[0].removed = removed;
  return change;
}

announcement::Announcement presence_at(std::uint64_t revision) {
  auto presence = speaker(1, revision, {});
  presence.kind = announcement::Kind::presence;
  presence.peers.clear();
  return presence;
}

struct ChangeHeard : ::testing::Test {
  ChangeHeard() {
    (void)rig.hear(speaker(1, 4, {5, 6}), rig_start);
    (void)rig.lines();
  }
  /// Hears it a little later than the last one.
  Hearing hear(const announcement::Announcement& announcement) {
    return rig.hear(announcement, now += milliseconds(300));
  }
  [[nodiscard]] bool is_lacked() { return !rig.table.report(now).lacks.empty(); }

  TableRig rig;
  base::Instant now = rig_start;
};

TEST_F(ChangeHeard, AddsAndRemovesWhatItSaysAndNothingElse) {
  EXPECT_EQ(hear(change_of(4, 5, {7}, {6})), Hearing::known);
  EXPECT_THAT(rig.lines(), ElementsAre("remove pub 00000001/1/6 withdrawn", "put pub 00000001/1/7 at 10.0.0.1"));
  EXPECT_EQ(rig.table.neighbours().affirmed(robot), now);
  EXPECT_FALSE(is_lacked());
  EXPECT_TRUE(rig.table.neighbours().find(robot)->is_complete);
}

TEST_F(ChangeHeard, MayLeaveAStateOfFewerParts) {
  for (const std::uint32_t part : {0U, 1U}) {
    auto state = speaker(1, 5, {10 + part});
    state.part = part;
    state.part_count = 2;
    (void)hear(state);
  }
  (void)hear(change_of(5, 6, {}, {11}));
  EXPECT_EQ(hear(speaker(1, 6, {10})), Hearing::known) << "what is gone needs no part any more";
  EXPECT_EQ(rig.table.neighbours().find(robot)->publications, 1U);
  auto lie = speaker(1, 6, {10});
  lie.part_count = 2;
  EXPECT_EQ(hear(lie), Hearing::contradiction) << "it was said in one part";
}

TEST_F(ChangeHeard, KeepsAllThatItDoesNotSayForAsLongAsItIsAffirmed) {
  (void)hear(change_of(4, 5, {7}));
  for (int i = 0; i < 20; ++i) (void)rig.hear(presence_at(5), now += seconds(2));
  rig.table.expire(now);
  EXPECT_EQ(rig.table.neighbours().find(robot)->publications, 3U);
}

TEST_F(ChangeHeard, LeadsFromAnyRevisionBetweenItsTwo) {
  EXPECT_EQ(hear(change_of(2, 9, {7})), Hearing::known);
  EXPECT_FALSE(is_lacked());
}

TEST_F(ChangeHeard, FromALaterRevisionThanIsKnownTellsThatTheStateIsLacked) {
  EXPECT_EQ(hear(change_of(5, 6, {7}, {6})), Hearing::known);
  EXPECT_THAT(rig.lines(), ElementsAre("remove pub 00000001/1/6 withdrawn", "put pub 00000001/1/7 at 10.0.0.1"))
      << "what it says is true all the same";
  EXPECT_TRUE(is_lacked());
  (void)hear(speaker(1, 6, {5, 7}));
  EXPECT_FALSE(is_lacked());
}

TEST_F(ChangeHeard, SaidAgainDoesNothing) {
  (void)hear(change_of(4, 5, {7}, {6}));
  (void)rig.lines();
  EXPECT_EQ(hear(change_of(4, 5, {7}, {6})), Hearing::known);
  EXPECT_FALSE(is_lacked());
  EXPECT_EQ(rig.table.neighbours().find(robot)->publications, 2U);
}

TEST_F(ChangeHeard, OfSomebodyUnknownMakesNobodyKnown) {
  auto change = change_of(4, 5, {7});
  change.participant = ParticipantId{2};
  change.boot = announcement::BootNonce{2};
  EXPECT_EQ(hear(change), Hearing::stranger);
  EXPECT_FALSE(rig.table.neighbours().is_known(ParticipantId{2}));
  EXPECT_THAT(rig.table.report(now).lacks, ElementsAre(ParticipantId{2}));
}

TEST_F(ChangeHeard, ThatDeniesItsOwnRevisionIsAContradiction) {
  (void)hear(change_of(4, 5, {7}));
  EXPECT_EQ(hear(change_of(4, 5, {}, {6})), Hearing::contradiction) << "removes what the revision has";
}

TEST_F(ChangeHeard, ThatAddsToItsOwnRevisionIsAContradiction) {
  (void)hear(change_of(4, 5, {7}));
  EXPECT_EQ(hear(change_of(4, 5, {8})), Hearing::contradiction);
}

TEST_F(ChangeHeard, OfALiarIsUndoneByTheNextTrueWord) {
  auto lie = change_of(4, 5, {9}, {5, 6});
  lie.sequence = 2;
  EXPECT_EQ(hear(lie), Hearing::known);
  EXPECT_EQ(rig.table.neighbours().find(robot)->publications, 1U);
  auto truth = speaker(1, 4, {5, 6});
  truth.sequence = 2;
  EXPECT_EQ(hear(truth), Hearing::contradiction);
  EXPECT_EQ(rig.table.neighbours().find(robot)->publications, 3U) << "what was removed is back; what was added lapses";
  for (int i = 0; i < 3; ++i) {
    truth.sequence += 1;
    (void)rig.hear(truth, now += seconds(2));
    rig.table.expire(now);
  }
  EXPECT_EQ(rig.table.neighbours().find(robot)->publications, 2U);
}

TEST_F(ChangeHeard, CannotMakeAParticipantHaveMoreThanItMay) {
  std::uint64_t revision = 4;
  for (std::uint32_t first = 100; first < 100 + 2 * announcement::max_services_per_participant; first += 50) {
    std::vector<std::uint32_t> numbers;
    for (std::uint32_t number = first; number < first + 50; ++number) numbers.push_back(number);
    (void)hear(change_of(revision, revision + 1, numbers));
    ++revision;
  }
  EXPECT_EQ(rig.table.neighbours().find(robot)->publications, announcement::max_services_per_participant);
  EXPECT_TRUE(is_lacked());
}

TEST_F(ChangeHeard, OnAWayOfWhichNoStateWasHeardLeavesItsAddressesLacked) {
  auto on_wlan = change_of(4, 5, {7});
  on_wlan.link = 8;
  EXPECT_EQ(rig.hear(on_wlan, now, wlan), Hearing::known);
  EXPECT_TRUE(is_lacked());
}

TEST_F(ChangeHeard, WhilePartsAreMissingDoesNotMakeTheStateComplete) {
  const auto all = speaker(1, 6, {5, 6, 7, 8});
  (void)hear(part_of(all, 0, 2, {5, 6}));
  (void)hear(change_of(6, 7, {9}));
  EXPECT_FALSE(rig.table.neighbours().find(robot)->is_complete);
  EXPECT_TRUE(is_lacked());
}

}  // namespace
}  // namespace geminga::membership
