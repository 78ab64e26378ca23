// The tokens of a budget, and when it has them again.
#include "discovery/membership/schedule/token_bucket.hpp"

#include <gtest/gtest.h>

namespace geminga::membership {
namespace {

using base::Instant;
using std::chrono::seconds;

constexpr Instant start{seconds(100)};

TEST(TokenBucket, GivesItsCapacityAtOnceAndThenOneAfterEachRefillTime) {
  TokenBucket bucket(3, seconds(10));
  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE(bucket.has(start)) << i;
    bucket.take(start);
  }
  EXPECT_FALSE(bucket.has(start));
  EXPECT_EQ(bucket.due(), start + seconds(10));
  EXPECT_FALSE(bucket.has(start + seconds(10) - std::chrono::nanoseconds(1)));
  ASSERT_TRUE(bucket.has(start + seconds(10)));
  bucket.take(start + seconds(10));
  EXPECT_EQ(bucket.due(), start + seconds(20));
}

TEST(TokenBucket, NeverHoldsMoreThanItsCapacity) {
  TokenBucket bucket(2, seconds(10));
  bucket.take(start);
  const auto late = start + std::chrono::hours(100);
  bucket.take(late);
  EXPECT_TRUE(bucket.has(late));
  bucket.take(late);
  EXPECT_FALSE(bucket.has(late));
  EXPECT_EQ(bucket.due(), late + seconds(10));
}

TEST(TokenBucket, GivesWhatIsTooLargeOnCreditAndForgivesWhatIsOverItsCapacity) {
  for (const std::int64_t cost : {6, 7, 1'000'000}) {
    TokenBucket bucket(3, seconds(10));
    bucket.take(start, cost);
    EXPECT_EQ(bucket.due(), start + seconds(40)) << cost;
  }
  TokenBucket bucket(3, seconds(10));
  bucket.take(start, 5);
  EXPECT_EQ(bucket.due(), start + seconds(30));
}

}  // namespace
}  // namespace geminga::membership
