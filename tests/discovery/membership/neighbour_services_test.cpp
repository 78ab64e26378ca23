// The known services of a neighbour: changes, parts, overtaken datagrams, several ways, addresses, limits.
#include <gmock/gmock.h>

#include <algorithm>
#include <map>

#include "discovery/announcement/limits.hpp"
#include "discovery/announcement/on_interface.hpp"
#include "discovery/membership/schedule/deadline.hpp"
#include "discovery/membership/table_rig.hpp"
#include "support/rounds.hpp"

namespace geminga::membership {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(NeighbourServices, FollowTheirParticipantsChanges) {
  TableRig rig;
  (void)rig.hear(speaker(1, 1, {5, 6}));
  rig.lines();
  auto changed = speaker(1, 2, {6, 7});
  changed.peers[0].publications[0].publication.port = 6000;
  EXPECT_EQ(rig.hear(changed, rig_start + milliseconds(10)), Hearing::known);
  EXPECT_THAT(rig.lines(), ElementsAre("remove pub 00000001/1/5 withdrawn", "put pub 00000001/1/6 at 10.0.0.1",
                                       "put pub 00000001/1/7 at 10.0.0.1"));
}

TEST(NeighbourServices, AreAffirmedAndNotToldAgainWhenAllPartsAreKnown) {
  TableRig rig;
  (void)rig.hear(speaker(1, 1));
  rig.lines();
  for (const auto later : {milliseconds(124), milliseconds(125), milliseconds(2000)}) {
    (void)rig.hear(speaker(1, 1), rig_start + later);
    EXPECT_THAT(rig.lines(), IsEmpty());
    EXPECT_EQ(rig.table.neighbours().affirmed(ParticipantId{1}), rig_start + later);
    EXPECT_EQ(rig.table.neighbours().find(ParticipantId{1})->deadline, rig_start + later + patience(seconds(2), {}));
  }
}

TEST(NeighbourServices, AreToldAgainButNotForEachCopyWhileAPartIsMissing) {
  TableRig rig;
  const auto part = part_of(speaker(1, 1, {5, 6}), 0, 2, {5});
  (void)rig.hear(part);
  rig.lines();
  (void)rig.hear(part, rig_start + milliseconds(124));
  EXPECT_THAT(rig.lines(), IsEmpty());
  (void)rig.hear(part, rig_start + milliseconds(125));
  const auto changes = rig.table.take_changes();
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_EQ(std::get<PutPublication>(changes[0]).heard, rig_start + milliseconds(125));
}

TEST(NeighbourServices, AreNotOverwrittenByAnOvertakenDatagram) {
  TableRig rig;
  auto newer = speaker(1, 3, {6});
  newer.name = "renamed";
  newer.addresses = {"10.0.0.200"};
  newer.sequence = 30;
  (void)rig.hear(newer);
  rig.lines();
  auto older = speaker(1, 2, {5, 6});
  older.sequence = 20;
  const auto overtaken = rig_start + announcement::overtaken_time - base::Duration(1);
  EXPECT_EQ(rig.hear(older, overtaken), Hearing::known);
  EXPECT_THAT(rig.lines(), IsEmpty());
  const auto known = rig.table.neighbours().find(ParticipantId{1});
  EXPECT_EQ(known->name, "renamed");
  EXPECT_EQ(known->address, "10.0.0.200");
  EXPECT_EQ(known->heard, overtaken) << "an overtaken datagram is a sign of life";
}

TEST(NeighbourServices, MayTurnFromPublicationIntoSubscription) {
  TableRig rig;
  (void)rig.hear(speaker(1, 1));
  rig.lines();
  auto turned = speaker(1, 2, {});
  turned.peers[0].subscriptions.push_back({5, announcement::simple_subscription()});
  (void)rig.hear(turned);
  EXPECT_THAT(rig.lines(), ElementsAre("remove pub 00000001/1/5 withdrawn", "put sub 00000001/1/5"));
  (void)rig.hear(speaker(1, 3, {}));
  EXPECT_THAT(rig.lines(), ElementsAre("remove sub 00000001/1/5 withdrawn"));
}

TEST(NeighbourServices, CarryTheNewNameOfTheirParticipantOrPeer) {
  TableRig rig;
  (void)rig.hear(speaker(1, 1, {5, 6}));
  rig.lines();
  auto renamed = speaker(1, 2, {5, 6});
  renamed.name = "goalkeeper";
  (void)rig.hear(renamed);
  const auto changes = rig.table.take_changes();
  ASSERT_EQ(changes.size(), 2U);
  EXPECT_EQ(std::get<PutPublication>(changes[0]).participant_name, "goalkeeper");
  renamed.revision = 3;
  renamed.peers[0].name = "eyes";
  (void)rig.hear(renamed);
  EXPECT_EQ(std::get<PutPublication>(rig.table.take_changes().at(1)).peer_name, "eyes");
}

TEST(NeighbourServices, AreAppliedPartByPartAndWithdrawnWhenAllPartsAreThere) {
  TableRig rig;
  (void)rig.hear(speaker(1, 1, {5, 6, 7}));
  rig.lines();
  const auto next = speaker(1, 2, {6, 8, 9});
  (void)rig.hear(part_of(next, 1, 2, {8, 9}));
  EXPECT_THAT(rig.lines(), ElementsAre("put pub 00000001/1/8 at 10.0.0.1", "put pub 00000001/1/9 at 10.0.0.1"));
  EXPECT_FALSE(rig.table.neighbours().find(ParticipantId{1})->is_complete);
  (void)rig.hear(part_of(next, 1, 2, {8, 9}));
  EXPECT_THAT(rig.lines(), IsEmpty());
  (void)rig.hear(part_of(next, 0, 2, {6}));
  EXPECT_THAT(rig.lines(), ElementsAre("remove pub 00000001/1/5 withdrawn", "remove pub 00000001/1/7 withdrawn"));
  EXPECT_TRUE(rig.table.neighbours().find(ParticipantId{1})->is_complete);
}

TEST(NeighbourServices, AreCompletedByALaterCopyOfALostPart) {
  TableRig rig;
  const auto state = speaker(1, 1, {5, 6});
  (void)rig.hear(part_of(state, 0, 2, {5}));
  (void)rig.hear(part_of(state, 0, 2, {5}), rig_start + seconds(2));
  EXPECT_FALSE(rig.table.neighbours().find(ParticipantId{1})->is_complete);
  (void)rig.hear(part_of(state, 1, 2, {6}), rig_start + seconds(4));
  EXPECT_TRUE(rig.table.neighbours().find(ParticipantId{1})->is_complete);
}

TEST(NeighbourServices, DoNotMixPartsOfDifferentRevisions) {
  TableRig rig;
  (void)rig.hear(speaker(1, 1, {5}));
  (void)rig.hear(part_of(speaker(1, 2, {6, 7}), 0, 2, {6}));
  rig.lines();
  auto newer = part_of(speaker(1, 3, {6, 8}), 1, 2, {8});
  newer.sequence = 6;
  (void)rig.hear(newer);
  EXPECT_THAT(rig.lines(), ElementsAre("put pub 00000001/1/8 at 10.0.0.1"));
  EXPECT_FALSE(rig.table.neighbours().find(ParticipantId{1})->is_complete);
  auto overtaken = part_of(speaker(1, 2, {6, 7}), 1, 2, {7});
  overtaken.sequence = 3;
  (void)rig.hear(overtaken);
  EXPECT_THAT(rig.lines(), IsEmpty());
  (void)rig.hear(part_of(speaker(1, 3, {6, 8}), 0, 2, {6}));
  EXPECT_THAT(rig.lines(), ElementsAre("remove pub 00000001/1/5 withdrawn"));
}

TEST(NeighbourServices, AreAllKeptAliveByOnePartOfACompleteRevision) {
  TableRig rig;
  const auto state = speaker(1, 1, {5, 6});
  (void)rig.hear(part_of(state, 0, 2, {5}));
  (void)rig.hear(part_of(state, 1, 2, {6}));
  rig.lines();
  for (int i = 1; i <= 20; ++i) {
    const auto now = rig_start + i * seconds(2);
    (void)rig.hear(part_of(state, 0, 2, {5}), now);
    rig.table.expire(now);
    EXPECT_THAT(rig.lines(), IsEmpty());
    EXPECT_EQ(rig.table.neighbours().find(ParticipantId{1})->publications, 2U);
    EXPECT_EQ(rig.table.neighbours().affirmed(ParticipantId{1}), now);
  }
}

TEST(NeighbourServices, ExpireOneByOneWhileNothingProvesThatTheyAreStillThere) {
  TableRig rig;
  (void)rig.hear(speaker(1, 1, {5, 6}));
  rig.lines();
  // The part with 6 of the next revision is never heard.
  const auto next = speaker(1, 2, {5, 6});
  for (int i = 1; i <= 4; ++i) (void)rig.hear(part_of(next, 0, 2, {5}), rig_start + i * seconds(2));
  rig.lines();
  const auto deadline = rig_start + service_intervals * seconds(2);
  EXPECT_EQ(rig.table.next_deadline(), deadline);
  rig.table.expire(deadline - base::Duration(1));
  EXPECT_THAT(rig.lines(), IsEmpty());
  rig.table.expire(deadline);
  EXPECT_THAT(rig.lines(), ElementsAre("remove pub 00000001/1/6 expired"));
}

TEST(NeighbourServices, AreKnownOnceThoughTheyAreHeardOnSeveralInterfaces) {
  TableRig rig;
  auto on_wlan = speaker(1, 1);
  on_wlan.link = 8;
  on_wlan.addresses = {"192.168.0.1"};
  (void)rig.hear(speaker(1, 1));
  EXPECT_EQ(rig.hear(on_wlan, rig_start, wlan), Hearing::known);
  EXPECT_THAT(rig.lines(), ElementsAre("put pub 00000001/1/5 at 10.0.0.1"));
  const auto known = rig.table.neighbours().find(ParticipantId{1});
  ASSERT_EQ(known->paths.size(), 2U);
  EXPECT_EQ(known->paths[1].interface_name, "wlan0");
  EXPECT_EQ(known->publications, 1U);
}

TEST(NeighbourServices, ChangeTheirAddressWhenTheWayInUseIsLost) {
  TableRig rig;
  auto on_wlan = speaker(1, 1);
  on_wlan.link = 8;
  on_wlan.addresses = {"192.168.0.1"};
  (void)rig.hear(speaker(1, 1));
  (void)rig.hear(on_wlan, rig_start, wlan);
  rig.lines();
  for (int i = 1; i <= 2; ++i) (void)rig.hear(on_wlan, rig_start + i * seconds(2), wlan);
  rig.lines();
  const auto lost = rig_start + patience(seconds(2), {});
  EXPECT_EQ(rig.table.next_deadline(), lost);
  rig.table.expire(lost - base::Duration(1));
  EXPECT_THAT(rig.lines(), IsEmpty());
  rig.table.expire(lost);
  EXPECT_THAT(rig.lines(), ElementsAre("put pub 00000001/1/5 at 192.168.0.1"));
  // The way in use stays in use when the other one comes back: channels are not moved without need.
  (void)rig.hear(speaker(1, 1), lost + milliseconds(1));
  EXPECT_THAT(rig.lines(), IsEmpty());
  EXPECT_EQ(rig.table.neighbours().find(ParticipantId{1})->address, "192.168.0.1");
}

TEST(NeighbourServices, ChangeTheirAddressAtOnceWhenOurInterfaceIsGone) {
  TableRig rig;
  auto on_wlan = speaker(1, 1);
  on_wlan.addresses = {"192.168.0.1"};
  (void)rig.hear(speaker(1, 1));
  (void)rig.hear(on_wlan, rig_start, wlan);
  rig.lines();
  rig.table.forget_interface(eth);
  EXPECT_THAT(rig.lines(), ElementsAre("put pub 00000001/1/5 at 192.168.0.1"));
  rig.table.forget_interface(wlan);
  EXPECT_THAT(rig.lines(), IsEmpty());
  EXPECT_TRUE(rig.table.neighbours().is_known(ParticipantId{1})) << "it may come back before its deadline";
}

TEST(NeighbourServices, GetTheBestAddressAndTheZoneOfOurInterface) {
  TableRig rig;
  auto announcement = speaker(1, 1);
  announcement.addresses = {"fe80::7"};
  (void)rig.hear(announcement);
  EXPECT_THAT(rig.lines(), ElementsAre("put pub 00000001/1/5 at fe80::7%eth0"));
  announcement.revision = 2;
  announcement.addresses = {"fe80::7", "2001:db8::7"};
  (void)rig.hear(announcement);
  EXPECT_THAT(rig.lines(), ElementsAre("put pub 00000001/1/5 at 2001:db8::7"));
  announcement.revision = 3;
  announcement.addresses = {"2001:db8::7", "10.0.0.7"};
  (void)rig.hear(announcement);
  EXPECT_THAT(rig.lines(), ElementsAre("put pub 00000001/1/5 at 10.0.0.7"));
  announcement.revision = 4;
  announcement.addresses = {"10.0.0.8", "10.0.0.7"};
  (void)rig.hear(announcement);
  EXPECT_THAT(rig.lines(), IsEmpty()) << "the one in use stays";
  announcement.revision = 5;
  announcement.addresses = {"10.0.0.9", "10.0.0.8"};
  (void)rig.hear(announcement);
  EXPECT_THAT(rig.lines(), ElementsAre("put pub 00000001/1/5 at 10.0.0.9"));
}

TEST(NeighbourServices, KeepAnExplicitAddressAndGetAZoneForALinkLocalOne) {
  TableRig rig;
  auto announcement = speaker(1, 1, {5, 6});
  announcement.peers[0].publications[0].publication.address = "239.192.1.1";
  announcement.peers[0].publications[1].publication.address = "fe80::42";
  (void)rig.hear(announcement);
  EXPECT_THAT(rig.lines(), ElementsAre("put pub 00000001/1/5 at 239.192.1.1", "put pub 00000001/1/6 at fe80::42%eth0"));
}

TEST(NeighbourServices, GetTheSendersAddressWhereItAnnouncesNone) {
  TableRig rig;
  rig.source = "10.0.0.77";
  auto announcement = speaker(1, 1);
  announcement.addresses.clear();
  (void)rig.hear(announcement);
  EXPECT_THAT(rig.lines(), ElementsAre("put pub 00000001/1/5 at 10.0.0.77"));
}

TEST(NeighbourServices, AreNotWithdrawnByALinkOnWhichTheyAreNotValid) {
  TableRig rig;
  auto state = speaker(1, 1, {5, 6});
  state.peers[0].publications[1].publication.address = "10.0.0.1";
  const std::vector<env::Interface> theirs{
      {.index = env::InterfaceIndex{1}, .name = "eth0", .addresses = {"10.0.0.1"}},
      {.index = env::InterfaceIndex{2}, .name = "wlan0", .addresses = {"192.168.0.1"}}};
  (void)rig.hear(on_interface(state, theirs[0], theirs));
  (void)rig.hear(on_interface(state, theirs[1], theirs), rig_start, wlan);
  EXPECT_THAT(rig.lines(), ElementsAre("put pub 00000001/1/5 at 10.0.0.1", "put pub 00000001/1/6 at 10.0.0.1"));
  state.revision = 2;
  state.peers[0].publications.erase(state.peers[0].publications.begin());
  (void)rig.hear(on_interface(state, theirs[1], theirs), rig_start, wlan);
  EXPECT_THAT(rig.lines(), ElementsAre("remove pub 00000001/1/5 withdrawn"));
  state.revision = 3;
  state.peers[0].publications.clear();
  (void)rig.hear(on_interface(state, theirs[1], theirs), rig_start, wlan);
  EXPECT_THAT(rig.lines(), ElementsAre("remove pub 00000001/1/6 withdrawn"));
}

/// A registry after all changes: the keys, and the port of each publication.
void do_all(const std::vector<Change>& changes, std::map<ServiceKey, std::uint16_t>& registry) {
  for (const auto& change : changes) {
    if (const auto* put = std::get_if<PutPublication>(&change)) registry[put->key] = put->publication.port;
    if (const auto* gone = std::get_if<RemovePublication>(&change)) {
      EXPECT_EQ(registry.erase(gone->key), 1U) << "removed what was never put";
    }
    if (const auto* gone = std::get_if<RemoveParticipant>(&change)) {
      std::erase_if(registry, [&](const auto& item) { return item.first.participant == gone->participant; });
    }
  }
}

TEST(NeighbourServices, EndUpRightWhateverIsLostCopiedOrOvertaken) {
  for (std::uint64_t seed = 1; seed <= test::rounds(200U); ++seed) {
    base::Random random(seed);
    TableRig rig;
    std::map<ServiceKey, std::uint16_t> registry;
    std::map<std::uint32_t, std::uint16_t> truth;
    struct Flying {
      base::Instant arrives;
      announcement::Announcement announcement;
    };
    std::vector<Flying> air;
    auto now = rig_start;
    std::uint64_t sequence = 1;
    const auto send = [&](std::uint64_t revision, double loss) {
      auto state = speaker(1, revision, {});
      // Each service has enough octets for the state to take several datagrams.
      for (const auto& [number, port] : truth) {
        auto publication = announcement::simple_publication(port);
        publication.attributes["p"] = std::string(200, 'x');
        state.peers[0].publications.push_back({number, publication});
      }
      state.sequence = sequence;
      for (const auto& datagram : encode(state)) {
        ++sequence;
        for (int copies = random.chance(0.2) ? 2 : 1; copies > 0; --copies) {
          if (random.chance(loss)) continue;
          auto decoded = announcement::decode(datagram);
          ASSERT_TRUE(decoded);
          air.push_back({now + random.between(milliseconds(0), milliseconds(150)), std::move(*decoded)});
        }
      }
    };
    const auto deliver = [&](base::Instant until) {
      std::ranges::stable_sort(air, {}, &Flying::arrives);
      const auto end = std::ranges::upper_bound(air, until, {}, &Flying::arrives);
      for (auto flying = air.begin(); flying != end; ++flying) (void)rig.hear(flying->announcement, flying->arrives);
      air.erase(air.begin(), end);
      do_all(rig.table.take_changes(), registry);
    };
    for (std::uint64_t revision = 1; revision <= 30; ++revision) {
      for (auto edits = 1 + random.below(4); edits > 0; --edits) {
        const auto number = static_cast<std::uint32_t>(1 + random.below(20));
        if (random.chance(0.4)) {
          truth.erase(number);
        } else {
          truth[number] = static_cast<std::uint16_t>(1 + random.below(60'000));
        }
      }
      send(revision, 0.3);
      now += milliseconds(50);
      deliver(now);
    }
    // Once every part was heard, and nothing old is in the air, the view is exact.
    now += milliseconds(200);
    deliver(now);
    send(30, 0);
    deliver(now + milliseconds(200));
    std::map<ServiceKey, std::uint16_t> expected;
    for (const auto& [number, port] : truth) expected[{ParticipantId{1}, PeerId{1}, number}] = port;
    EXPECT_EQ(registry, expected) << "seed " << seed;
  }
}

}  // namespace
}  // namespace geminga::membership
