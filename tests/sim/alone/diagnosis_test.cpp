// Inquiries and diagnoses between whole participants: who is answered, and what is told.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "discovery/sealing/rig.hpp"
#include "sim/robots.hpp"

namespace geminga::sim {
namespace {

using sealing::Mode;
using sealing::policy;
using std::chrono::milliseconds;
using std::chrono::seconds;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

constexpr Bounds patient_asking = {.missing = seconds(60), .surplus = seconds(60)};

struct Asking : Robots {
  Asking(std::uint64_t seed, double loss, bool is_sealed, bool is_allowed)
      : Robots(World::seed_or(seed), 3, {.loss = loss, .longest_delay = milliseconds(5)}, patient_asking) {
    for (const auto& host : world.hosts()) {
      if (is_sealed) host->settings.sealing = policy(Mode::encrypted, {1});
      host->settings.diagnoses = is_allowed;
    }
    start();
    world.run_for(seconds(20));
  }
  /// Asks as the doctor does, each tenth of a second.
  std::vector<std::string> ask_for(const std::string& who) {
    std::vector<std::string> lines;
    for (int turn = 0; turn < 60; ++turn) {
      lines = world.ask(host(0), "diagnosis participant=" + who);
      if (lines.empty() || !lines.back().contains("state=asked")) break;
      world.run_for(milliseconds(100));
    }
    return lines;
  }
};

TEST(Diagnosis, IsToldInASealedTeamWhereItsOwnerAllowsItAlsoUnderLoss) {
  for (const double loss : {0.0, 0.3, 0.5}) {
    Asking team(71, loss, true, true);
    const auto lines = team.ask_for("robot2");
    EXPECT_THAT(lines, Contains(HasSubstr("msg diagnosis part=status version="))) << "loss " << loss;
    EXPECT_THAT(lines, Contains(HasSubstr(" sealing=encrypted")));
    const auto ours = team.world.ask(team.host(0), "status");
    const std::size_t at = ours.at(0).find("participant=");
    const std::string id = ours.at(0).substr(at + 12, 8);
    EXPECT_THAT(lines, Contains(HasSubstr("part=participants id=" + id)));
    EXPECT_THAT(lines, Contains(HasSubstr("part=interfaces name=eth0")));
    EXPECT_THAT(lines, Not(Contains(HasSubstr("users="))));
    EXPECT_THAT(lines, Not(Contains(HasSubstr("robot1"))));
  }
}

TEST(Diagnosis, IsNotToldWhereItsOwnerDoesNotAllowIt) {
  Asking team(72, 0, true, false);
  const std::uint64_t before = team.host(1).datagrams_sent();
  EXPECT_THAT(team.ask_for("robot2").back(), HasSubstr("state=asked"));
  EXPECT_LE(team.host(1).datagrams_sent() - before, 6U) << "its presences";
}

TEST(Diagnosis, IsNotToldWithoutAKeyToWhoeverAsksByMulticast) {
  Asking team(73, 0, false, true);
  EXPECT_THAT(team.ask_for("robot2").back(), HasSubstr("state=asked"));
}

TEST(Diagnosis, IsToldWithoutAKeyOnceASecondToAHostThatIsNamedHoweverOftenItAsks) {
  Asking team(74, 0, false, true);
  team.host(1).names_others = true;
  team.host(1).hears_datagrams_alone = true;
  std::string inquiry;
  std::size_t longest = 0;
  std::size_t answers = 0;
  team.world.on_transmit = [&](const Host& sender, std::string_view datagram) {
    if (&sender == &team.host(0) && datagram.size() > 1100) inquiry = datagram;
    if (&sender == &team.host(1) && datagram.contains("status version=")) {
      ++answers;
      longest = std::max(longest, datagram.size());
    }
  };
  EXPECT_THAT(team.ask_for("robot2").back(), HasSubstr("state=asked"));
  ASSERT_FALSE(inquiry.empty());
  ASSERT_EQ(answers, 0U) << "it came by multicast";
  const auto bytes = std::as_bytes(std::span(inquiry));
  for (int i = 0; i < 100; ++i) {
    team.host(0).send_alone(team.host(0).ports().front().index, team.host(1).ports().front().address, bytes);
    team.world.run_for(milliseconds(100));
  }
  EXPECT_GE(answers, 10U);
  EXPECT_LE(answers, 15U);
  EXPECT_LE(longest, inquiry.size());
}

TEST(Diagnosis, OfNobodyWhoIsKnownIsAnError) {
  Asking team(75, 0, true, true);
  EXPECT_THAT(team.world.ask(team.host(0), "diagnosis participant=robot9"), Contains(HasSubstr(" 404 ")));
  EXPECT_THAT(team.world.ask(team.host(0), "diagnosis"), Contains(HasSubstr(" 400 ")));
}

}  // namespace
}  // namespace geminga::sim
