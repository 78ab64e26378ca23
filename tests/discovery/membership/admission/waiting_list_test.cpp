// Strangers that wait for a place.
#include "discovery/membership/admission/waiting_list.hpp"

#include <gtest/gtest.h>

namespace geminga::membership {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr base::Instant start{seconds(1000)};

announcement::Announcement stranger(std::uint32_t id, std::uint64_t sequence) {
  announcement::Announcement announcement;
  announcement.participant = ParticipantId{id};
  announcement.boot = announcement::BootNonce{id};
  announcement.sequence = sequence;
  return announcement;
}

TEST(WaitingList, GivesAStandingFromTheSecondDatagramOnAndNoneForACopy) {
  WaitingList waiting;
  EXPECT_FALSE(waiting.hear(stranger(1, 1), start));
  EXPECT_FALSE(waiting.hear(stranger(1, 1), start + milliseconds(5)));
  const auto standing = waiting.hear(stranger(1, 2), start + seconds(1));
  ASSERT_TRUE(standing);
  EXPECT_TRUE(standing->is_confirmed);
  EXPECT_EQ(standing->span(), seconds(1));
}

TEST(WaitingList, BeginsAnewAfterTheLongestSilenceAndNotBefore) {
  WaitingList waiting;
  (void)waiting.hear(stranger(1, 1), start);
  EXPECT_TRUE(waiting.hear(stranger(1, 2), start + longest_silence - milliseconds(1)));
  EXPECT_FALSE(waiting.hear(stranger(1, 3), start + 2 * longest_silence - milliseconds(1)));
}

TEST(WaitingList, KeepsTheStandingOfAMemberThatGaveItsPlaceAway) {
  WaitingList waiting;
  waiting.put(ParticipantId{1}, announcement::BootNonce{1}, 7, {start - seconds(60), start, true});
  const auto standing = waiting.hear(stranger(1, 8), start + seconds(2));
  ASSERT_TRUE(standing);
  EXPECT_EQ(standing->span(), seconds(62));
}

TEST(WaitingList, DoesNotRememberAMemberThatWasHeardOnce) {
  WaitingList waiting;
  waiting.put(ParticipantId{1}, announcement::BootNonce{1}, 7, {start, start, false});
  EXPECT_FALSE(waiting.hear(stranger(1, 8), start + seconds(1)));
}

}  // namespace
}  // namespace geminga::membership
