#include "geminga/service.hpp"

#include <gtest/gtest.h>

namespace geminga {
namespace {

TEST(ServiceWords, EveryWordReadsBack) {
  for (const auto mode : {ChannelMode::one_to_one, ChannelMode::one_to_many_stream, ChannelMode::one_to_many_pubsub}) {
    EXPECT_EQ(channel_mode(to_string(mode)), mode);
  }
  for (const auto d : {Degree::exact, Degree::equivalent, Degree::narrower, Degree::broader, Degree::converted}) {
    EXPECT_EQ(degree(to_string(d)), d);
  }
  EXPECT_FALSE(channel_mode("otm"));
  EXPECT_FALSE(degree("plug-in"));
}

TEST(ServiceKey, ReadsBackAndRefusesWhatIsNoKey) {
  const ServiceKey key{ParticipantId{0x1a2b3c4d}, PeerId{3}, 42};
  EXPECT_EQ(to_string(key), "1a2b3c4d/3/42");
  EXPECT_EQ(service_key("1a2b3c4d/3/42"), key);
  for (const char* bad : {"", "1a2b3c4d", "1a2b3c4d/3", "1A2B3C4D/3/42", "1a2b3c4d/3/42/1", "1a2b3c4d//1", "x/1/1"}) {
    EXPECT_FALSE(service_key(bad)) << bad;
  }
}

}  // namespace
}  // namespace geminga
