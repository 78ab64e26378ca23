// The known participants and their ends: newcomers, clashes, restarts, goodbyes, deadlines, limits.
#include "discovery/membership/neighbour_table.hpp"

#include <gmock/gmock.h>

#include <limits>
#include <set>
#include <utility>

#include "discovery/announcement/limits.hpp"
#include "discovery/membership/claim/first_claims.hpp"
#include "discovery/membership/schedule/deadline.hpp"
#include "discovery/membership/table_rig.hpp"

namespace geminga::membership {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(NeighbourTable, TakesInANewcomerWithItsServices) {
  TableRig rig;
  EXPECT_EQ(rig.hear(speaker(1, 1, {5, 6})), Hearing::newcomer);
  EXPECT_THAT(rig.lines(), ElementsAre("put pub 00000001/1/5 at 10.0.0.1", "put pub 00000001/1/6 at 10.0.0.1"));
  const auto known = rig.table.neighbours().find(ParticipantId{1});
  ASSERT_TRUE(known);
  EXPECT_EQ(known->name, "robot1");
  EXPECT_EQ(known->publications, 2U);
  EXPECT_EQ(known->subscriptions, 0U);
  EXPECT_TRUE(known->is_complete);
  EXPECT_EQ(known->heard, rig_start);
  EXPECT_EQ(known->deadline, rig_start + patience(seconds(2), {}));
}

TEST(NeighbourTable, TellsProvenanceAndDeadline) {
  TableRig rig;
  (void)rig.hear(speaker(1, 1));
  const auto changes = rig.table.take_changes();
  ASSERT_EQ(changes.size(), 1U);
  const auto& put = std::get<PutPublication>(changes[0]);
  EXPECT_EQ(put.peer_name, "vision");
  EXPECT_EQ(put.participant_name, "robot1");
  EXPECT_EQ(put.heard, rig_start);
  EXPECT_EQ(rig.table.next_deadline(), rig_start + patience(seconds(2), {}));
}

TEST(NeighbourTable, CallsTheNamelessByTheirNumbers) {
  TableRig rig;
  auto nameless = speaker(1, 1);
  nameless.name.clear();
  nameless.peers[0].name.clear();
  (void)rig.hear(nameless);
  const auto put = std::get<PutPublication>(rig.table.take_changes().at(0));
  EXPECT_EQ(put.participant_name, "00000001");
  EXPECT_EQ(put.peer_name, "1");
}

TEST(NeighbourTable, IgnoresAnotherGroup) {
  TableRig rig;
  auto other = speaker(1, 1);
  other.group = "red";
  EXPECT_EQ(rig.hear(other), Hearing::other_group);
  EXPECT_EQ(rig.table.neighbours().size(), 0U);
}

TEST(NeighbourTable, KnowsItsOwnDatagramsUnderWhateverIdentifier) {
  TableRig rig;
  for (const auto id : {std::to_underlying(self_id), 1U}) {
    auto own = speaker(id, 1);
    own.boot = self_boot;
    EXPECT_EQ(rig.hear(own), Hearing::own);
  }
  EXPECT_EQ(rig.table.neighbours().size(), 0U);
}

TEST(NeighbourTable, TellsThatItsIdentifierIsClaimedOrUsedBySomebodyElse) {
  TableRig rig;
  for (const auto kind : {announcement::Kind::state, announcement::Kind::claim, announcement::Kind::goodbye}) {
    auto other = speaker(std::to_underlying(self_id), 1);
    other.boot = announcement::BootNonce{99};
    other.kind = kind;
    EXPECT_EQ(rig.hear(other), Hearing::clash);
  }
  EXPECT_EQ(rig.table.neighbours().size(), 0U);
  EXPECT_THAT(rig.lines(), IsEmpty());
}

TEST(NeighbourTable, DoesNotTakeAClaimantForAParticipant) {
  TableRig rig;
  auto claim = speaker(1, 0, {});
  claim.kind = announcement::Kind::claim;
  EXPECT_EQ(rig.hear(claim), Hearing::claim);
  EXPECT_FALSE(rig.table.neighbours().is_known(ParticipantId{1}));
}

TEST(NeighbourTable, ExpiresAParticipantAtItsInstantAndNotBefore) {
  TableRig rig;
  (void)rig.hear(speaker(1, 1));
  rig.lines();
  const auto deadline = rig_start + patience(seconds(2), {});
  EXPECT_EQ(rig.table.next_deadline(), deadline);
  rig.table.expire(deadline - base::Duration(1));
  EXPECT_THAT(rig.lines(), IsEmpty());
  EXPECT_TRUE(rig.table.neighbours().is_known(ParticipantId{1}));
  rig.table.expire(deadline);
  EXPECT_THAT(rig.lines(), ElementsAre("remove 00000001 expired"));
  EXPECT_FALSE(rig.table.neighbours().is_known(ParticipantId{1}));
  EXPECT_EQ(rig.table.next_deadline(), base::never);
}

TEST(NeighbourTable, CountsTheDeadlineFromTheLastDatagramInAnnouncedIntervals) {
  TableRig rig;
  auto quick = speaker(1, 1);
  quick.interval = milliseconds(100);
  (void)rig.hear(quick);
  (void)rig.hear(quick, rig_start + milliseconds(7));
  EXPECT_EQ(rig.table.neighbours().find(ParticipantId{1})->deadline,
            rig_start + milliseconds(7) + patience(milliseconds(100), {}));
}

announcement::Announcement presence_of(const announcement::Announcement& state) {
  announcement::Announcement presence;
  presence.kind = announcement::Kind::presence;
  presence.group = state.group;
  presence.participant = state.participant;
  presence.boot = state.boot;
  presence.link = state.link;
  presence.revision = state.revision;
  return presence;
}

TEST(NeighbourTable, KeepsAllServicesOfWhoIsThereWithTheSameRevision) {
  TableRig rig;
  (void)rig.hear(speaker(1, 1));
  rig.lines();
  for (int i = 1; i <= 20; ++i) {
    const auto now = rig_start + i * seconds(2);
    EXPECT_EQ(rig.hear(presence_of(speaker(1, 1)), now), Hearing::known);
    rig.table.expire(now);
    EXPECT_THAT(rig.lines(), IsEmpty());
    EXPECT_EQ(rig.table.neighbours().find(ParticipantId{1})->publications, 1U);
  }
  EXPECT_TRUE(rig.table.report(rig_start + seconds(40)).lacks.empty());
}

TEST(NeighbourTable, LacksTheStateOfWhoIsThereWithAnotherRevision) {
  TableRig rig;
  (void)rig.hear(speaker(1, 1));
  const auto later = rig_start + seconds(1);
  EXPECT_EQ(rig.hear(presence_of(speaker(1, 2)), later), Hearing::known);
  EXPECT_TRUE(rig.table.lacks_anybody(later));
  EXPECT_THAT(rig.table.report(later).lacks, ElementsAre(ParticipantId{1}));
  EXPECT_EQ(rig.hear(speaker(1, 2, {5, 6}), later), Hearing::known);
  EXPECT_FALSE(rig.table.lacks_anybody(later));
  EXPECT_EQ(rig.table.neighbours().find(ParticipantId{1})->publications, 2U);
}

TEST(NeighbourTable, LacksTheStateOfAStrangerForAWhile) {
  TableRig rig;
  EXPECT_EQ(rig.hear(presence_of(speaker(1, 1))), Hearing::stranger);
  EXPECT_FALSE(rig.table.neighbours().is_known(ParticipantId{1}));
  EXPECT_THAT(rig.table.report(rig_start).lacks, ElementsAre(ParticipantId{1}));
  EXPECT_TRUE(rig.table.report(rig_start + seconds(4)).lacks.empty());
  for (std::uint32_t id = 100; id < 200; ++id) (void)rig.hear(presence_of(speaker(id, 1)));
  EXPECT_GE(rig.table.report(rig_start).lacks.size(), 4U);
  EXPECT_LE(rig.table.report(rig_start).lacks.size(), announcement::max_named);
}

TEST(NeighbourTable, NamesEverybodyWhomItLacksAfterAWhileHoweverManyTheyAre) {
  TableRig rig;
  for (std::uint32_t id = 1; id <= 50; ++id) (void)rig.hear(part_of(speaker(id, 1, {5, 6}), 0, 2, {5}));
  (void)rig.hear(presence_of(speaker(99, 1)));
  std::set<ParticipantId> named;
  for (int i = 0; i < 5; ++i) {
    const auto lacks = rig.table.report(rig_start).lacks;
    EXPECT_LE(lacks.size(), announcement::max_named);
    EXPECT_THAT(lacks, ::testing::Contains(ParticipantId{99})) << "strangers have places of their own";
    named.insert(lacks.begin(), lacks.end());
  }
  EXPECT_EQ(named.size(), 51U);
}

TEST(NeighbourTable, OpensAWayByAPresenceAndLearnsItsAddressesFromTheState) {
  TableRig rig;
  (void)rig.hear(speaker(1, 1));
  auto on_wlan = speaker(1, 1);
  on_wlan.link = 8;
  on_wlan.addresses = {"192.168.0.1"};
  EXPECT_EQ(rig.hear(presence_of(on_wlan), rig_start, wlan), Hearing::known);
  EXPECT_THAT(rig.table.report(rig_start).lacks, ElementsAre(ParticipantId{1})) << "its addresses there are not known";
  EXPECT_EQ(rig.hear(on_wlan, rig_start, wlan), Hearing::known) << "the presence has said nothing of addresses";
  EXPECT_THAT(rig.table.neighbours().find(ParticipantId{1})->paths.at(1).addresses, ElementsAre("192.168.0.1"));
}

TEST(NeighbourTable, KeepsAliveWhomWitnessesHaveHeardWhereAllKnowTheSameOnes) {
  const auto witness_of = [](TableRig& rig, bool is_same) {
    // 2 has heard 1 within a quarter of an interval; the order is 1, 2, ourselves.
    auto presence = presence_of(speaker(2, 1));
    presence.witness.members = rig.table.report(rig_start).witness.members;
    if (!is_same) ++presence.witness.members;
    presence.witness.heard = {announcement::HeardWithin::quarter, {}, {}, {}};
    return presence;
  };
  for (const bool is_same : {true, false}) {
    TableRig rig;
    for (const std::uint32_t id : {1U, 2U}) (void)rig.hear(speaker(id, 1));
    const auto now = rig_start + seconds(4);
    (void)rig.hear(witness_of(rig, is_same), now);
    const auto seen = now - milliseconds(500);
    rig.table.expire(rig_start + patience(seconds(2), {}));
    ASSERT_EQ(rig.table.neighbours().is_known(ParticipantId{1}), is_same);
    EXPECT_TRUE(!is_same || rig.table.neighbours().find(ParticipantId{1})->deadline >= seen + patience(seconds(2), {}));
  }
}

TEST(NeighbourTable, TakesAnExpiredParticipantInAgainAtOnce) {
  TableRig rig;
  (void)rig.hear(speaker(1, 1));
  rig.table.expire(rig_start + seconds(30));
  rig.lines();
  EXPECT_EQ(rig.hear(speaker(1, 1), rig_start + seconds(31)), Hearing::newcomer);
  EXPECT_THAT(rig.lines(), ElementsAre("put pub 00000001/1/5 at 10.0.0.1"));
}

TEST(NeighbourTable, RemovesAParticipantAtItsGoodbyeAndLetsNoLateDatagramBringItBack) {
  TableRig rig;
  (void)rig.hear(speaker(1, 1));
  rig.lines();
  auto goodbye = speaker(1, 2, {});
  goodbye.kind = announcement::Kind::goodbye;
  goodbye.sequence = 10;
  EXPECT_EQ(rig.hear(goodbye), Hearing::goodbye);
  EXPECT_THAT(rig.lines(), ElementsAre("remove 00000001 left"));
  EXPECT_EQ(rig.hear(goodbye), Hearing::stale);
  auto late = speaker(1, 1);
  late.sequence = 9;
  EXPECT_EQ(rig.hear(late, rig_start + announcement::overtaken_time - base::Duration(1)), Hearing::stale);
  late.sequence = 1;
  EXPECT_EQ(rig.hear(late, rig_start + goodbye_memory - base::Duration(1)), Hearing::stale);
  EXPECT_THAT(rig.lines(), IsEmpty());
  EXPECT_EQ(rig.hear(late, rig_start + goodbye_memory), Hearing::newcomer);
}

TEST(NeighbourTable, TakesTheNextIncarnationInRightAfterAGoodbye) {
  TableRig rig;
  (void)rig.hear(speaker(1, 1));
  auto goodbye = speaker(1, 2, {});
  goodbye.kind = announcement::Kind::goodbye;
  (void)rig.hear(goodbye);
  rig.lines();
  auto next = speaker(1, 1);
  next.boot = announcement::BootNonce{77};
  EXPECT_EQ(rig.hear(next), Hearing::newcomer);
  EXPECT_THAT(rig.lines(), ElementsAre("put pub 00000001/1/5 at 10.0.0.1"));
}

TEST(NeighbourTable, IgnoresAGoodbyeOfSomebodyElse) {
  TableRig rig;
  (void)rig.hear(speaker(1, 1));
  auto goodbye = speaker(1, 2, {});
  goodbye.kind = announcement::Kind::goodbye;
  goodbye.boot = announcement::BootNonce{77};
  EXPECT_EQ(rig.hear(goodbye), Hearing::stale);
  EXPECT_TRUE(rig.table.neighbours().is_known(ParticipantId{1}));
}

TEST(NeighbourTable, LetsANewIncarnationReplaceTheOldOneWhenThatIsSilentForTwoIntervals) {
  TableRig rig;
  (void)rig.hear(speaker(1, 9, {5, 6}));
  rig.lines();
  auto next = speaker(1, 1, {6, 7});
  next.boot = announcement::BootNonce{77};
  EXPECT_EQ(rig.hear(next, rig_start + seconds(1)), Hearing::rival);
  EXPECT_EQ(rig.hear(next, rig_start + seconds(4) - base::Duration(1)), Hearing::rival);
  EXPECT_THAT(rig.lines(), IsEmpty());
  EXPECT_EQ(rig.hear(next, rig_start + seconds(4)), Hearing::newcomer);
  EXPECT_THAT(rig.lines(), ElementsAre("remove 00000001 expired", "put pub 00000001/1/6 at 10.0.0.1",
                                       "put pub 00000001/1/7 at 10.0.0.1"));
  // A datagram that the former incarnation sent before that does not bring it back. A later one does: it was not over.
  auto late = speaker(1, 9, {5});
  late.sequence = 1;
  EXPECT_EQ(rig.hear(late, rig_start + seconds(5)), Hearing::stale);
  EXPECT_EQ(rig.table.neighbours().find(ParticipantId{1})->boot, announcement::BootNonce{77});
  EXPECT_EQ(rig.hear(speaker(1, 9, {5, 6}), rig_start + seconds(5)), Hearing::returned);
  EXPECT_EQ(rig.table.neighbours().find(ParticipantId{1})->boot, announcement::BootNonce{1});
}

TEST(NeighbourTable, GivesAnIdentifierToTheIncarnationThatClaimedItBeforeWhoAnticipatedIt) {
  TableRig rig;
  auto owner = speaker(1, 9, {5});
  (void)rig.hear(owner);
  auto goodbye = speaker(1, 9, {});
  goodbye.kind = announcement::Kind::goodbye;
  EXPECT_EQ(rig.hear(goodbye, rig_start + seconds(1)), Hearing::goodbye);
  owner.participant = ParticipantId{2};
  auto claim = owner;
  claim.kind = announcement::Kind::claim;
  EXPECT_EQ(rig.hear(claim, rig_start + seconds(1)), Hearing::claim);
  auto forged = speaker(2, 1, {6});
  forged.boot = announcement::BootNonce{77};
  EXPECT_EQ(rig.hear(forged, rig_start + seconds(1)), Hearing::newcomer);
  rig.lines();
  EXPECT_EQ(rig.hear(owner, rig_start + seconds(1)), Hearing::newcomer);
  EXPECT_THAT(rig.lines(), ElementsAre("remove 00000002 expired", "put pub 00000002/1/5 at 10.0.0.1"));
  EXPECT_EQ(rig.hear(forged, rig_start + seconds(1)), Hearing::stale);
  EXPECT_EQ(rig.hear(forged, rig_start + seconds(2)), Hearing::rival);
}

TEST(NeighbourTable, RemembersClaimsUpToTheNamedNumberAndForTheNamedTime) {
  for (const auto& [others, after] : {std::pair{std::size_t{0}, claim_memory - base::Duration(1)},
                                      {0, claim_memory},
                                      {max_claims - 1, seconds(1)},
                                      {max_claims, seconds(1)}}) {
    TableRig rig;
    auto claim = speaker(1, 1);
    claim.kind = announcement::Kind::claim;
    (void)rig.hear(claim);
    for (std::size_t i = 0; i < others; ++i) {
      claim.participant = ParticipantId(1000 + i);
      (void)rig.hear(claim);
    }
    auto forged = speaker(1, 1);
    forged.boot = announcement::BootNonce{77};
    (void)rig.hear(forged, rig_start + after);
    const bool is_remembered = others < max_claims && after < claim_memory;
    EXPECT_EQ(rig.hear(speaker(1, 1), rig_start + after), is_remembered ? Hearing::newcomer : Hearing::rival)
        << others << " others";
  }
}

TEST(NeighbourTable, IgnoresAnotherIncarnationUnderAnIdentifierWhoseOwnerIsThere) {
  TableRig rig;
  auto other = speaker(1, 1, {});
  other.boot = announcement::BootNonce{77};
  for (int i = 0; i < 40; ++i) {
    const auto now = rig_start + i * milliseconds(500);
    if (i % 4 == 0) (void)rig.hear(speaker(1, 1), now);
    EXPECT_EQ(rig.hear(other, now), Hearing::rival);
    rig.table.expire(now);
  }
  EXPECT_EQ(rig.table.neighbours().find(ParticipantId{1})->boot, announcement::BootNonce{1});
  EXPECT_EQ(rig.table.neighbours().find(ParticipantId{1})->publications, 1U);
}

TEST(NeighbourTable, VisitsInOrderOfIdentifier) {
  TableRig rig;
  for (const auto id : {9U, 3U, 7U}) (void)rig.hear(speaker(id, 1));
  std::vector<std::uint32_t> ids;
  rig.table.neighbours().for_each([&](const Neighbour& neighbour) { ids.push_back(std::to_underlying(neighbour.id)); });
  EXPECT_THAT(ids, ElementsAre(3, 7, 9));
}

TEST(NeighbourTable, MeasuresLossFromSequenceNumbers) {
  TableRig rig;
  auto announcement = speaker(1, 1);
  for (std::uint64_t sequence = 0; sequence < 200; ++sequence) {
    if (sequence % 4 == 3) continue;
    announcement.sequence = sequence;
    (void)rig.hear(announcement, rig_start + milliseconds(sequence));
  }
  EXPECT_NEAR(rig.table.neighbours().find(ParticipantId{1})->loss, 0.25, 0.02);
}

TEST(NeighbourTable, RemembersTheLossesOfWhoIsGivenUpAndComesBack) {
  TableRig rig;
  const auto say = [&](announcement::Announcement announcement, std::uint64_t sequence, int at) {
    announcement.sequence = sequence;
    return rig.hear(announcement, rig_start + seconds(at));
  };
  for (const int life : {0, 1, 2}) {
    const auto first = static_cast<std::uint64_t>(10 * life);
    const int at = 100 * life;
    EXPECT_EQ(say(speaker(1, 1), first + 1, at), Hearing::newcomer) << life;
    EXPECT_EQ(say(speaker(1, 1), first + 5, at + 1), Hearing::known) << life;
    rig.table.expire(rig_start + seconds(at + 30));
    EXPECT_EQ(say(presence_of(speaker(1, 1)), first + 9, at + 90), Hearing::stranger) << life;
  }
  EXPECT_EQ(say(speaker(1, 1), 31, 300), Hearing::newcomer);
  const auto known = rig.table.neighbours().find(ParticipantId{1});
  EXPECT_EQ(known->loss, 0) << "of its new life";
  EXPECT_EQ(known->paths.at(0).for_long, (LossSample{.missed = 31 - 10, .numbers = 31}));
}

TEST(NeighbourTable, HasADifferentWordForEachHearing) {
  std::set<std::string_view> words;
  for (int i = 0; i <= static_cast<int>(Hearing::returned); ++i) words.insert(to_string(static_cast<Hearing>(i)));
  EXPECT_EQ(words.size(), static_cast<std::size_t>(Hearing::returned) + 1);
}

}  // namespace
}  // namespace geminga::membership
