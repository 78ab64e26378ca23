// The first claim of an identifier.
#include "discovery/membership/claim/first_claims.hpp"

#include <gtest/gtest.h>

namespace geminga::membership {
namespace {

using std::chrono::seconds;

constexpr base::Instant start{seconds(1000)};

announcement::Announcement said_by(std::uint32_t id, std::uint64_t boot) {
  announcement::Announcement announcement;
  announcement.participant = ParticipantId{id};
  announcement.boot = announcement::BootNonce{boot};
  return announcement;
}

TEST(FirstClaims, GiveTheIdentifierToTheFirstClaimantOnly) {
  FirstClaims claims;
  claims.hear(said_by(1, 11), "10.0.0.1", start, 2);
  claims.hear(said_by(1, 12), "10.0.0.2", start, 4);
  EXPECT_EQ(claims.find(said_by(1, 11), "10.0.0.1", start), Turn{2});
  EXPECT_FALSE(claims.find(said_by(1, 12), "10.0.0.2", start));
}

TEST(FirstClaims, CountForTheAddressThatTheyCameFrom) {
  FirstClaims claims;
  claims.hear(said_by(1, 11), "10.0.0.1", start, 2);
  EXPECT_FALSE(claims.find(said_by(1, 11), "10.0.0.2", start));
}

TEST(FirstClaims, AreForgottenAfterTheirTimeAndNotBefore) {
  FirstClaims claims;
  claims.hear(said_by(1, 11), "10.0.0.1", start, 2);
  const auto end = start + claim_memory;
  EXPECT_TRUE(claims.find(said_by(1, 11), "10.0.0.1", end - base::Duration(1)));
  EXPECT_FALSE(claims.find(said_by(1, 11), "10.0.0.1", end));
  claims.hear(said_by(1, 12), "10.0.0.2", end, 4);
  EXPECT_EQ(claims.find(said_by(1, 12), "10.0.0.2", end), Turn{4});
}

}  // namespace
}  // namespace geminga::membership
