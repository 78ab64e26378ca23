// The keys of a subscriber's providers: told early, kept when a provider goes, and forgotten beyond the limit.
#include "client/protocol/provider_keys.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <set>

#include "client/protocol/limits.hpp"

namespace geminga::client {
namespace {

/// Keys that differ by their id.
ChannelKeys keys_with(KeyId id) { return {SealingMode::encrypted, {{id, {}, {}}}}; }

class ProviderKeysTest : public testing::Test {
 protected:
  [[nodiscard]] bool knows(std::uint64_t life) const { return keys_.of(Life{life}).has_value(); }
  void put(std::uint64_t life) { keys_.put(Life{life}, keys_with(1)); }

  std::set<Life> providers_;
  ProviderKeys keys_{[this](Life life) { return providers_.contains(life); }};
};

TEST_F(ProviderKeysTest, AreUnknownUntilTheDaemonTellsThem) {
  EXPECT_FALSE(knows(1));
  EXPECT_EQ(keys_.of(no_life), ChannelKeys()) << "frames without a life are plain";
  put(1);
  EXPECT_EQ(keys_.of(Life{1}), keys_with(1));
  keys_.put(Life{1}, keys_with(2));
  EXPECT_EQ(keys_.of(Life{1}), keys_with(2));
}

TEST_F(ProviderKeysTest, ArePlainWhereTheDaemonHasNone) {
  put(1);
  keys_.on_daemon(false);
  EXPECT_EQ(keys_.of(Life{1}), ChannelKeys());
  EXPECT_EQ(keys_.of(Life{2}), ChannelKeys());
  keys_.on_daemon(true);
  EXPECT_FALSE(knows(1)) << "the daemon will tell them again";
}

TEST_F(ProviderKeysTest, OfLivesWithoutAProviderAreForgottenFromTheLimitOn) {
  for (std::uint64_t life = 1; life <= max_waiting_keys; ++life) put(life);
  EXPECT_TRUE(knows(1));
  put(max_waiting_keys + 1);
  EXPECT_FALSE(knows(1));
  EXPECT_TRUE(knows(2));
  EXPECT_TRUE(knows(max_waiting_keys + 1));
}

TEST_F(ProviderKeysTest, OfAProviderAreKeptWhileItIsThereAndAmongTheLastOnesWhenItHasGone) {
  providers_.insert(Life{1});
  for (std::uint64_t life = 1; life <= max_waiting_keys + 2; ++life) put(life);
  EXPECT_TRUE(knows(1)) << "it does not count";
  EXPECT_FALSE(knows(2));
  keys_.leave(Life{1});
  providers_.erase(Life{1});
  EXPECT_TRUE(knows(1));
  EXPECT_FALSE(knows(3)) << "the eldest made room for it";
  for (std::uint64_t life = 2; life < max_waiting_keys + 1; ++life) put(life * 10'000);
  EXPECT_TRUE(knows(1));
  put(1'000'000'007);
  EXPECT_FALSE(knows(1));
}

TEST_F(ProviderKeysTest, OfAProviderThatCameWhileTheyWaitedAreNotForgotten) {
  put(1);
  providers_.insert(Life{1});
  for (std::uint64_t life = 2; life <= max_waiting_keys + 2; ++life) put(life);
  EXPECT_TRUE(knows(1));
}

}  // namespace
}  // namespace geminga::client
