// The owners that a session consists of, each alone.
#include <gtest/gtest.h>

#include <chrono>

#include "discovery/participant/clients/lag.hpp"
#include "discovery/participant/clients/recent_work.hpp"
#include "discovery/participant/clients/stated_services.hpp"
#include "discovery/participant/clients/told_keys.hpp"

namespace geminga::participant {
namespace {

constexpr base::Duration patience = std::chrono::seconds(10);

base::Instant second(int number) { return base::Instant(std::chrono::seconds(number)); }

TEST(Lag, BeginsOnceAndIsPatientAnewOnlyWhenThePeerHasReadSomething) {
  Lag lag;
  EXPECT_EQ(lag.deadline(patience), base::never);
  EXPECT_TRUE(lag.begin(100, second(1)));
  EXPECT_FALSE(lag.begin(200, second(2))) << "it lags already";
  lag.note(100, second(3));
  EXPECT_EQ(lag.deadline(patience), second(1) + patience) << "it has read nothing";
  lag.note(99, second(4));
  EXPECT_EQ(lag.deadline(patience), second(4) + patience);
  lag.end();
  EXPECT_FALSE(lag.is_any());
  lag.note(1, second(5));
  EXPECT_EQ(lag.deadline(patience), base::never);
}

TEST(RecentWork, CountsForHalfAfterEachHalfLife) {
  RecentWork work;
  const base::Instant begin = base::Instant() + 100 * half_life;
  work.add(1000, begin);
  EXPECT_EQ(work.at(begin + half_life - base::Duration(1)), 1000U);
  EXPECT_EQ(work.at(begin + half_life), 500U);
  work.add(100, begin + half_life + half_life / 2);
  EXPECT_EQ(work.at(begin + 2 * half_life), 300U) << "what is left of a half-life is not lost";
  EXPECT_EQ(work.at(begin + 100 * half_life), 0U);
}

TEST(ToldKeys, AreForgottenTogetherAtOneMoreThanTheLimitAndByRequest) {
  ToldKeys keys;
  EXPECT_TRUE(keys.ask(true));
  EXPECT_FALSE(keys.ask(true)) << "it has asked before";
  for (std::uint32_t request = 1; request <= max_told_channels; ++request) keys.add(request, Life{7});
  EXPECT_TRUE(keys.has(1, Life{7}));
  keys.forget(1);
  EXPECT_FALSE(keys.has(1, Life{7}));
  keys.add(1, Life{8});
  EXPECT_TRUE(keys.has(2, Life{7})) << "just as many as the limit";
  keys.add(1, Life{9});
  EXPECT_FALSE(keys.has(2, Life{7}));
  EXPECT_TRUE(keys.has(1, Life{9}));
  EXPECT_TRUE(keys.has_any());
}

TEST(StatedServices, CountsWhatIsSharedWithoutQuietSubscriptions) {
  StatedServices services;
  services.publications[1];
  services.subscriptions[2].is_quiet = true;
  services.subscriptions[3];
  services.quiet = 1;
  EXPECT_EQ(services.count(), 3U);
  EXPECT_EQ(services.shared_count(), 2U);
  services.erase(2);
  EXPECT_EQ(services.quiet, 0U);
  EXPECT_EQ(services.shared_count(), 2U);
  EXPECT_FALSE(services.contains(2));
  services.erase(2);
  EXPECT_TRUE(services.contains(1));
  services.clear();
  EXPECT_EQ(services.count(), 0U);
}

}  // namespace
}  // namespace geminga::participant
