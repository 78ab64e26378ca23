// The announcement of a change: enough for all who know an earlier state, and no more.
#include "discovery/participant/air/change_log.hpp"

#include <gmock/gmock.h>

#include <map>

#include "base/random.hpp"
#include "discovery/announcement/announcements.hpp"
#include "discovery/announcement/codec.hpp"
#include "discovery/membership/neighbour_table.hpp"
#include "support/rounds.hpp"

namespace geminga::participant {
namespace {

using announcement::PeerState;
using std::chrono::milliseconds;
using std::chrono::seconds;
using ::testing::ElementsAre;

constexpr base::Instant start{seconds(1000)};

/// A state with one peer, whose publications have these numbers and ports.
announcement::Announcement state_of(std::uint64_t revision, const std::map<std::uint32_t, std::uint16_t>& ports) {
  announcement::Announcement state;
  state.group = "default";
  state.participant = ParticipantId{1};
  state.boot = announcement::BootNonce{1};
  state.name = "robot1";
  state.revision = revision;
  PeerState peer;
  peer.id = PeerId{1};
  peer.name = "vision";
  for (const auto& [number, port] : ports) {
    peer.publications.push_back({number, announcement::simple_publication(port)});
  }
  if (!ports.empty()) state.peers.push_back(peer);
  return state;
}

std::vector<std::uint32_t> numbers_of(const announcement::Announcement& change) {
  std::vector<std::uint32_t> numbers;
  for (const auto& peer : change.peers) {
    for (const auto& entry : peer.publications) numbers.push_back(entry.number);
  }
  return numbers;
}

TEST(ChangeLog, HasNoChangeToTellOfTheFirstState) {
  ChangeLog log;
  log.update(state_of(1, {{5, 5000}}), start);
  EXPECT_FALSE(log.change());
}

TEST(ChangeLog, TellsWhatIsNewWhatIsOtherwiseAndWhatIsGone) {
  ChangeLog log;
  log.update(state_of(1, {{5, 5000}, {6, 5001}, {7, 5002}}), start);
  log.update(state_of(2, {{5, 5000}, {6, 6001}, {8, 5003}}), start + seconds(9));
  const auto change = log.change();
  ASSERT_TRUE(change);
  EXPECT_EQ(change->kind, announcement::Kind::change);
  EXPECT_EQ(change->since, 1U);
  EXPECT_EQ(change->revision, 2U);
  EXPECT_THAT(numbers_of(*change), ElementsAre(6U, 8U));
  EXPECT_THAT(change->peers[0].removed, ElementsAre(7U));
}

TEST(ChangeLog, TellsOfAPeerThatIsGone) {
  ChangeLog log;
  log.update(state_of(1, {{5, 5000}}), start);
  log.update(state_of(2, {}), start + seconds(9));
  const auto change = log.change();
  ASSERT_TRUE(change);
  ASSERT_EQ(change->peers.size(), 1U);
  EXPECT_THAT(change->peers[0].removed, ElementsAre(5U));
}

TEST(ChangeLog, TellsAgainWhatWasToldALittleWhileAgo) {
  ChangeLog log;
  log.update(state_of(1, {{5, 5000}}), start);
  log.update(state_of(4, {{5, 5000}, {6, 5001}}), start + seconds(9));
  log.update(state_of(5, {{5, 5000}, {6, 5001}, {7, 5002}}), start + seconds(9) + milliseconds(50));
  EXPECT_EQ(log.change()->since, 1U) << "not everybody may have heard of revision 4 yet";
  EXPECT_THAT(numbers_of(*log.change()), ElementsAre(6U, 7U));
  log.update(state_of(6, {{5, 5000}, {6, 5001}}), start + seconds(20));
  EXPECT_EQ(log.change()->since, 5U);
  EXPECT_THAT(log.change()->peers[0].removed, ElementsAre(7U));
}

TEST(ChangeLog, TellsTheWholeStateWhenSomethingElseThanServicesIsOtherwise) {
  ChangeLog log;
  log.update(state_of(1, {{5, 5000}}), start);
  auto renamed = state_of(2, {{5, 5000}, {6, 5001}});
  renamed.ontology_digest = 7;
  log.update(renamed, start + seconds(9));
  EXPECT_FALSE(log.change());
  log.begin_anew();
  renamed.revision = 3;
  renamed.peers.clear();
  log.update(renamed, start + seconds(20));
  EXPECT_FALSE(log.change()) << "the interfaces are others";
}

/// A sender that changes at random and a receiver that misses most of what it says: whenever the receiver believes that
/// it knows the state, it is the state.
TEST(ChangeLog, LeadsWhoeverMissesHalfOfItToTheSameState) {
  int complete = 0;
  for (std::uint64_t seed = 1; seed <= test::rounds(300U); ++seed) {
    base::Random random(seed);
    ChangeLog log;
    membership::NeighbourTable table("default");
    table.set_self(ParticipantId{9}, announcement::BootNonce{9});
    std::map<ServiceKey, std::uint16_t> heard;
    std::map<std::uint32_t, std::uint16_t> ports;
    std::uint64_t sequence = 0;
    auto now = start;
    for (std::uint64_t revision = 1; revision <= 60; ++revision) {
      for (auto changes = 1 + random.below(3); changes > 0; --changes) {
        const auto number = static_cast<std::uint32_t>(1 + random.below(12));
        if (random.chance(0.4)) {
          ports.erase(number);
        } else {
          ports[number] = static_cast<std::uint16_t>(5000 + random.below(3));
        }
      }
      now += random.between(milliseconds(3), milliseconds(random.chance(0.3) ? 4000 : 300));
      log.update(state_of(revision, ports), now);
      auto said = log.change().value_or(log.state());
      if (random.chance(0.1)) said = log.state();
      said.sequence = ++sequence;
      for (const auto& datagram : announcement::encode(said)) {
        if (random.chance(0.5)) continue;
        (void)table.hear(announcement::decode(datagram).value(), {env::InterfaceIndex{2}, "eth0", "10.0.0.1", now});
      }
      table.expire(now);
      for (const auto& change : table.take_changes()) {
        if (const auto* put = std::get_if<membership::PutPublication>(&change)) {
          heard[put->key] = put->publication.port;
        } else if (const auto* gone = std::get_if<membership::RemovePublication>(&change)) {
          heard.erase(gone->key);
        } else {
          heard.clear();
        }
      }
      const auto known = table.neighbours().find(ParticipantId{1});
      const bool has_heard_of_it = known && known->heard == now;
      if (!has_heard_of_it || !known->is_complete || !table.report(now).lacks.empty()) continue;
      ++complete;
      std::map<ServiceKey, std::uint16_t> truth;
      for (const auto& [number, port] : ports) truth[{ParticipantId{1}, PeerId{1}, number}] = port;
      ASSERT_EQ(heard, truth) << "seed " << seed << ", revision " << revision;
    }
  }
  EXPECT_GT(complete, test::rounds(3000));
}

}  // namespace
}  // namespace geminga::participant
