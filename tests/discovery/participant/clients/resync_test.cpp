#include "discovery/participant/clients/resync.hpp"

#include <gtest/gtest.h>

namespace geminga::participant {
namespace {

constexpr ServiceKey key(std::uint32_t number) { return {ParticipantId{1}, PeerId{1}, number}; }

TEST(Resync, TellsTheCurrentOnesInTheirOrderAndThenTheFormerOnes) {
  Resync resync;
  EXPECT_FALSE(resync.has_begun());
  resync.begin({key(5), key(2)}, {key(9)});
  EXPECT_TRUE(resync.has_begun());
  EXPECT_EQ(resync.next(), key(5));
  EXPECT_EQ(resync.next(), key(2));
  EXPECT_EQ(resync.next(), key(9));
  EXPECT_EQ(resync.next(), std::nullopt);
}

TEST(Resync, StandsForTheEventsOfAKeyUntilThatIsTold) {
  Resync resync;
  EXPECT_TRUE(resync.will_tell(key(7))) << "before it begins, it stands for all";
  resync.begin({key(5), key(2)}, {});
  EXPECT_FALSE(resync.will_tell(key(7))) << "that came later";
  EXPECT_TRUE(resync.will_tell(key(5)));
  EXPECT_TRUE(resync.will_tell(key(2)));
  static_cast<void>(resync.next());
  EXPECT_FALSE(resync.will_tell(key(5)));
  EXPECT_TRUE(resync.will_tell(key(2)));
}

}  // namespace
}  // namespace geminga::participant
