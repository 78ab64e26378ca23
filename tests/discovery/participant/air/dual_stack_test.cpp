#include "discovery/participant/air/dual_stack.hpp"

#include <gtest/gtest.h>

namespace geminga::participant {
namespace {

using std::chrono::seconds;

constexpr base::Instant start{seconds(1000)};

class DualStackTest : public testing::Test {
 protected:
  DualStackTest() {
    one.index = env::InterfaceIndex{1};
    one.addresses = {"10.0.0.1"};
    twin.index = env::InterfaceIndex{2};
    twin.addresses = {"fe80::1"};
    twin.twin_of = one.index;
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
  env::Interface twin;
  sealing::Seal seal{[] { return std::uint64_t{7}; }};
  DualStack dual_stack;
};

TEST_F(DualStackTest, SpeaksOnATwinOnlyWhileSomebodyThereSpeaksIpv6Alone) {
  EXPECT_TRUE(speaks_on(one, start));
  EXPECT_FALSE(speaks_on(twin, start));
  dual_stack.hear(said_by(1), one, start + seconds(9));
  EXPECT_FALSE(speaks_on(twin, start)) << "that one is heard on IPv4";
  dual_stack.hear(said_by(1), twin, start + seconds(9));
  EXPECT_TRUE(speaks_on(twin, start + seconds(8)));
  EXPECT_FALSE(speaks_on(twin, start + seconds(9)));
}

TEST_F(DualStackTest, EndsWithTheLastGoodbye) {
  dual_stack.hear(said_by(1), twin, start + seconds(9));
  dual_stack.hear(said_by(2), twin, start + seconds(9));
  auto goodbye = said_by(1);
  goodbye.kind = announcement::Kind::goodbye;
  dual_stack.hear(goodbye, twin, start + seconds(9));
  EXPECT_TRUE(speaks_on(twin, start));
  goodbye.participant = ParticipantId{2};
  dual_stack.hear(goodbye, twin, start + seconds(9));
  EXPECT_FALSE(speaks_on(twin, start));
}

TEST_F(DualStackTest, ForgetsTheOneThatIsOverFirstWhereTooManyAreThere) {
  for (std::uint32_t at = 0; at <= DualStack::most_remembered; ++at) {
    dual_stack.hear(said_by(1 + at), twin, start + seconds(9 + at));
  }
  auto goodbye = said_by(1);
  goodbye.kind = announcement::Kind::goodbye;
  for (std::uint32_t at = 1; at <= DualStack::most_remembered; ++at) {
    EXPECT_TRUE(speaks_on(twin, start));
    goodbye.participant = ParticipantId{1 + at};
    dual_stack.hear(goodbye, twin, start);
  }
  EXPECT_FALSE(speaks_on(twin, start)) << "the first was forgotten";
}

TEST_F(DualStackTest, KnowsADatagramThatIsSaidOnIpv4AsWell) {
  auto said = said_by(1);
  EXPECT_FALSE(DualStack::is_said_twice(said, twin));
  said.link = announcement::twin_link;
  EXPECT_TRUE(DualStack::is_said_twice(said, twin));
  env::Interface alone;
  alone.addresses = {"fe80::1"};
  EXPECT_FALSE(DualStack::is_said_twice(said, alone)) << "nobody hears IPv4 here";
}

}  // namespace
}  // namespace geminga::participant
