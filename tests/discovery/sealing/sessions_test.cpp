// The sessions that are remembered, at their limit.
#include "discovery/sealing/sessions.hpp"

#include <gtest/gtest.h>

namespace geminga::sealing {
namespace {

constexpr base::Instant start{std::chrono::hours(1)};

KnownSession heard_at(base::Instant instant) {
  return {ReplayWindow(env::InterfaceIndex{1}, 1, instant, false), instant, Protection::encrypted, KeyId(1), {}};
}

TEST(Sessions, ForgetTheSilentHalfForOneMoreThanTheyHold) {
  ProvedSessions sessions;
  for (std::size_t i = 1; i <= max_sessions; ++i) {
    EXPECT_FALSE(sessions.add(Session(i), heard_at(start + std::chrono::seconds(i)))) << i;
    EXPECT_EQ(sessions.size(), i);
  }
  EXPECT_TRUE(sessions.add(Session(max_sessions + 1), heard_at(start)));
  EXPECT_EQ(sessions.size(), max_sessions / 2 + 1);
  EXPECT_EQ(sessions.find(Session(1)), nullptr);
  EXPECT_EQ(sessions.find(Session(max_sessions / 2)), nullptr);
  EXPECT_NE(sessions.find(Session(max_sessions / 2 + 1)), nullptr);
  EXPECT_NE(sessions.find(Session(max_sessions + 1)), nullptr);
}

}  // namespace
}  // namespace geminga::sealing
