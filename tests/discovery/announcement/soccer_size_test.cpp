// The cost of the robots of the paper's section 4 on the air: octets, which do not depend on the machine.
#include <gmock/gmock.h>

#include <numeric>
#include <string_view>

#include "discovery/announcement/announcements.hpp"
#include "discovery/announcement/limits.hpp"

namespace geminga::announcement {
namespace {

struct Service {
  std::string_view module;
  bool is_publication;
  std::string_view message;
};

// The modules of one robot as the team's specification has them (examples/robot-soccer/team.tsv).
constexpr Service whole_robot[] = {
    {"Vision", true, "WorldModelData"},
    {"Vision", true, "KickControl"},
    {"Vision", true, "CorrectedOrometryMessage"},
    {"Vision", false, "RawOdometry"},
    {"Vision", false, "CompassMessage"},
    {"Vision", false, "SpeechAct"},
    {"Vision", false, "SharedMallMessage"},
    {"VisionDirected", true, "KickControl"},
    {"VisionDirected", false, "SharedBallMessage"},
    {"VisionDirected", false, "CorrectedOdometryMessage"},
    {"Base", true, "MotionControl"},
    {"Base", true, "KickControl"},
    {"Base", true, "SimulatorControl"},
    {"Base", true, "BehaviourEngineInfo"},
    {"Base", true, "SharedWorldInfo"},
    {"Base", true, "SpeechAct"},
    {"Base", false, "WorldModelData"},
    {"Base", false, "WorldModelDataSim"},
    {"Base", false, "BehaviorEngineControl"},
    {"Base", false, "DriveToPoint"},
    {"Base", false, "JoystickControl"},
    {"Base", false, "CompassMessage"},
    {"Base", false, "RawOdometry"},
    {"Base", false, "MotionStat"},
    {"Base", false, "KickTime"},
    {"Base", false, "KickStat"},
    {"Base", false, "EnforceColors"},
    {"Base", false, "SpeechAct"},
    {"Base", false, "SharedBallMessage"},
    {"Motion", true, "RawOdometry"},
    {"Motion", true, "MotionStat"},
    {"Motion", false, "MotionControl"},
    {"Kicker", true, "KickerStat"},
    {"Kicker", true, "KickTime"},
    {"Kicker", false, "KickControl"},
    {"Compass", true, "CompassMessage"},
};

/// A robot with the first so many publications and subscriptions of the table.
Announcement robot(std::size_t publications, std::size_t subscriptions, std::string_view representation,
                   const Attributes& attributes) {
  const std::string soccer = "https://geminga.example/soccer#";
  auto state = worked_example();
  state.peers.clear();
  std::uint32_t number = 0;
  for (const auto& service : whole_robot) {
    auto& left = service.is_publication ? publications : subscriptions;
    if (left == 0) continue;
    --left;
    if (state.peers.empty() || state.peers.back().name != service.module) {
      state.peers.push_back(
          {PeerId{static_cast<std::uint32_t>(state.peers.size() + 1)}, std::string(service.module), {}, {}, {}, {}});
    }
    const SemanticIdentity identity{soccer + std::string(service.message),
                                    representation.empty() ? std::string() : soccer + std::string(representation)};
    if (service.is_publication) {
      auto publication = simple_publication(static_cast<std::uint16_t>(5000 + number));
      publication.identity = identity;
      publication.attributes = attributes;
      state.peers.back().publications.push_back({++number, publication});
    } else {
      auto subscription = simple_subscription();
      subscription.identity = identity;
      state.peers.back().subscriptions.push_back({++number, subscription});
    }
  }
  return state;
}

std::size_t octets(const Announcement& state, std::size_t parts) {
  const auto datagrams = encode(state);
  EXPECT_EQ(datagrams.size(), parts);
  return std::accumulate(datagrams.begin(), datagrams.end(), std::size_t{0},
                         [](std::size_t sum, const Datagram& datagram) { return sum + datagram.size(); });
}

TEST(SoccerRobot, AnnouncesNineServicesAndSevenRequestsInOneDatagram) {
  EXPECT_EQ(octets(robot(9, 7, "", {}), 1), 592U);
  EXPECT_EQ(octets(robot(9, 7, "CartesianFieldFrame", {}), 1), 650U);
  EXPECT_EQ(octets(robot(9, 7, "CartesianFieldFrame", {{"period", "33ms"}}), 1), 796U);
}

TEST(SoccerRobot, AnnouncesAllItsModulesInOneDatagramAndWithAttributesInTwo) {
  EXPECT_EQ(octets(robot(100, 100, "CartesianFieldFrame", {}), 1), 1086U);
  EXPECT_EQ(octets(robot(100, 100, "CartesianFieldFrame", {{"period", "33ms"}}), 2), 1600U);
}

TEST(SoccerRobot, ClaimsInASmallDatagram) {
  auto claim = robot(0, 0, "", {});
  claim.kind = Kind::claim;
  claim.addresses.clear();
  claim.revision = 0;
  EXPECT_EQ(octets(claim, 1), 55U);
}

}  // namespace
}  // namespace geminga::announcement
