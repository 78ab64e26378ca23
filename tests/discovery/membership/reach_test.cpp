// Which participants have their address judged, what is observed of them, and what a verdict changes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "discovery/membership/table_rig.hpp"

namespace geminga::membership {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr ParticipantId relay_id{0xb};
constexpr ParticipantId far_id{1};

struct ReachRig {
  ReachRig() {
    rig.table.set_judge([this](const std::string& address, const std::string& observed) {
      judged.push_back(address + (observed.empty() ? "" : " seen as " + observed));
      return verdict;
    });
  }

  enum class How : std::uint8_t { multicast, alone, relayed };
  void hear(How how, const std::string& source, std::vector<std::string> addresses = {"10.0.0.5"},
            std::uint64_t revision = 1) {
    auto state = speaker(1, revision);
    state.addresses = std::move(addresses);
    state.sequence = ++sequence;
    const Passage passage{.through = {relay_id}, .interface = eth, .interval = seconds(1), .delay = seconds(1)};
    (void)rig.table.hear(state, {.interface = eth,
                                 .interface_name = "eth0",
                                 .source = source,
                                 .now = rig_start + milliseconds(10) * sequence,
                                 .is_sealed = true,
                                 .is_alone = how == How::alone,
                                 .passage = how == How::relayed ? &passage : nullptr});
  }
  std::string observed() { return observed_address(*rig.table.neighbours().reach(far_id)); }
  std::vector<bool> flags() {
    std::vector<bool> all;
    for (const auto& change : rig.table.take_changes()) {
      if (const auto* put = std::get_if<PutPublication>(&change)) all.push_back(put->is_reachable);
    }
    return all;
  }

  TableRig rig;
  Reachability verdict = Reachability::no_route;
  std::vector<std::string> judged;
  std::uint64_t sequence = 0;
};
using How = ReachRig::How;

TEST(Reach, IsJudgedOfParticipantsFromAfarAlone) {
  ReachRig by_multicast;
  by_multicast.hear(How::multicast, "10.0.0.5");
  EXPECT_THAT(by_multicast.judged, IsEmpty());
  EXPECT_THAT(by_multicast.flags(), ElementsAre(true));
  ReachRig by_relay;
  by_relay.hear(How::relayed, "10.0.0.5");
  EXPECT_THAT(by_relay.judged, ElementsAre("10.0.0.5"));
  EXPECT_FALSE(by_relay.flags().back());
  EXPECT_EQ(by_relay.rig.table.neighbours().reach(far_id)->reachability, Reachability::no_route);
  ReachRig alone;
  alone.hear(How::alone, "10.0.0.5");
  EXPECT_THAT(alone.judged, ElementsAre("10.0.0.5"));
  EXPECT_FALSE(alone.flags().back());
  alone.hear(How::multicast, "10.0.0.5");
  EXPECT_TRUE(alone.flags().back()) << "it is on our link after all";
}

TEST(Reach, IsToldAnewWhenTheVerdictChanges) {
  ReachRig rig;
  rig.hear(How::relayed, "10.0.0.5");
  (void)rig.flags();
  rig.rig.table.judge_reach();
  EXPECT_THAT(rig.flags(), IsEmpty()) << "the same verdict";
  rig.verdict = Reachability::reachable;
  rig.rig.table.judge_reach();
  EXPECT_THAT(rig.flags(), ElementsAre(true));
  rig.verdict = Reachability::translated;
  rig.rig.table.judge_reach();
  EXPECT_THAT(rig.flags(), ElementsAre(false));
  rig.hear(How::multicast, "10.0.0.5");
  EXPECT_THAT(rig.flags(), ElementsAre(true)) << "heard directly, it is not judged";
}

TEST(Reach, ObservesAnAddressThatIsNotAnnounced) {
  struct Case {
    std::string source;
    std::vector<std::string> addresses;
    std::string observed;
    std::string why;
  };
  const Case cases[] = {
      {"203.0.113.7", {"10.0.0.5"}, "203.0.113.7", "a translation"},
      {"10.0.0.5", {"10.0.0.5"}, "", "its own"},
      {"10.0.0.6", {"10.0.0.5", "10.0.0.6"}, "", "one of several"},
      {"2001:db8:0::1", {"10.0.0.5", "2001:db8::1"}, "", "the same in other words"},
      {"fe80::1", {"10.0.0.5"}, "", "a link-local address is announced on its link alone"},
      {"fe80::1%eth0", {"fd00::5"}, "", "a link-local address is announced on its link alone"},
      {"2001:db8::1", {"10.0.0.5"}, "", "it announces none of that kind"},
      {"10.0.0.9", {"10.0.0.5", "10.0.0.6", "10.0.0.7", "10.0.0.8"}, "", "it may have more than it announces"},
      {"10.0.0.9", {"10.0.0.5", "10.0.0.6", "10.0.0.7"}, "10.0.0.9", "all are announced"},
  };
  for (const Case& one : cases) {
    ReachRig rig;
    rig.hear(How::relayed, one.source, one.addresses);
    EXPECT_EQ(rig.observed(), one.observed) << one.why;
  }
}

TEST(Reach, JudgesByWhatIsObserved) {
  ReachRig rig;
  rig.hear(How::relayed, "203.0.113.7");
  EXPECT_THAT(rig.judged, ElementsAre("10.0.0.5 seen as 203.0.113.7"));
}

}  // namespace
}  // namespace geminga::membership
