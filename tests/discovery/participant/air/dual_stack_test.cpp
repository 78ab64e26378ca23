#include "discovery/participant/air/dual_stack.hpp"

#include <gtest/gtest.h>

namespace geminga::participant {
namespace {

using std::chrono::seconds;

constexpr base::Instant noon{seconds(1000)};

class DualStackTest : public testing::Test {
 protected:
  DualStackTest() {
    one.index = env::InterfaceIndex{1};
    one.addresses = {"10.0.0.1"};
    ipv6_side.index = env::InterfaceIndex{2};
    ipv6_side.addresses = {"fe80::1"};
    ipv6_side.ipv6_side_of = one.index;
  }

  announcement::Announcement said_by(std::uint32_t participant) {
    announcement::Announcement said;
    said.participant = ParticipantId{participant};
    said.kind = announcement::Kind::presence;
    return said;
  }
  bool speaks_on(const env::Interface& interface, base::Instant now) {
    return dual_stack.speaks_on(interface, seal, now);
  }

  env::Interface one;
  env::Interface ipv6_side;
  sealing::Seal seal{[] { return std::uint64_t{7}; }};
  DualStack dual_stack;
};

TEST_F(DualStackTest, SpeaksOnTheIpv6SideOnlyWhileSomebodyThereSpeaksIpv6Alone) {
  EXPECT_TRUE(speaks_on(one, noon));
  EXPECT_FALSE(speaks_on(ipv6_side, noon));
  dual_stack.hear(said_by(1), one, noon + seconds(9));
  EXPECT_FALSE(speaks_on(ipv6_side, noon)) << "that one is heard on IPv4";
  dual_stack.hear(said_by(1), ipv6_side, noon + seconds(9));
  EXPECT_TRUE(speaks_on(ipv6_side, noon + seconds(8)));
  EXPECT_FALSE(speaks_on(ipv6_side, noon + seconds(9)));
}

TEST_F(DualStackTest, EndsWithTheLastGoodbye) {
  dual_stack.hear(said_by(1), ipv6_side, noon + seconds(9));
  dual_stack.hear(said_by(2), ipv6_side, noon + seconds(9));
  auto goodbye = said_by(1);
  goodbye.kind = announcement::Kind::goodbye;
  dual_stack.hear(goodbye, ipv6_side, noon + seconds(9));
  EXPECT_TRUE(speaks_on(ipv6_side, noon));
  goodbye.participant = ParticipantId{2};
  dual_stack.hear(goodbye, ipv6_side, noon + seconds(9));
  EXPECT_FALSE(speaks_on(ipv6_side, noon));
}

TEST_F(DualStackTest, ForgetsTheOneThatIsOverFirstWhereTooManyAreThere) {
  for (std::uint32_t at = 0; at <= DualStack::most_remembered; ++at) {
    dual_stack.hear(said_by(1 + at), ipv6_side, noon + seconds(9 + at));
  }
  auto goodbye = said_by(1);
  goodbye.kind = announcement::Kind::goodbye;
  for (std::uint32_t at = 1; at <= DualStack::most_remembered; ++at) {
    EXPECT_TRUE(speaks_on(ipv6_side, noon));
    goodbye.participant = ParticipantId{1 + at};
    dual_stack.hear(goodbye, ipv6_side, noon);
  }
  EXPECT_FALSE(speaks_on(ipv6_side, noon)) << "the first was forgotten";
}

TEST_F(DualStackTest, KnowsADatagramThatIsSaidOnIpv4AsWell) {
  auto said = said_by(1);
  EXPECT_FALSE(DualStack::is_said_twice(said, ipv6_side));
  said.link = announcement::ipv6_side_bit;
  EXPECT_TRUE(DualStack::is_said_twice(said, ipv6_side));
  env::Interface alone;
  alone.addresses = {"fe80::1"};
  EXPECT_FALSE(DualStack::is_said_twice(said, alone)) << "nobody hears IPv4 here";
}

}  // namespace
}  // namespace geminga::participant
