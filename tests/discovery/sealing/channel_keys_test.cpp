// The keys of a channel: what is derived from a key of the team, by the worked example of SEALING.md.
#include "discovery/sealing/channel_keys.hpp"

#include <gtest/gtest.h>

#include <string>

#include "base/text.hpp"

namespace geminga::sealing {
namespace {

constexpr std::uint64_t life = 0x0123456789abcdef;

Key example_key() {
  Key::Secret secret{};
  for (std::size_t i = 0; i < secret.size(); ++i) secret.at(i) = static_cast<unsigned char>(i);
  return Key(secret);
}

std::string hex(const Key::Secret& secret) {
  std::string text;
  for (const unsigned char octet : secret) text += base::to_hex(octet, 2);
  return text;
}

TEST(ChannelKeys, AreThoseOfTheSpecification) {
  const ChannelKeys keys = channel_keys(example_key(), life);
  EXPECT_EQ(to_string(keys.id), "6208");
  EXPECT_EQ(hex(keys.forward), "618408bc05ef2b7c262ac0676abe39df9dfe9db66ca3fe78e3e00d4cda7f5fc8");
  EXPECT_EQ(hex(keys.back), "201c6285b39c9e9b12c712d9f5045fc698f675d1d8957dbca1d05d6fbceea32b");
}

TEST(ChannelKeys, DifferByLifeByDirectionAndByTeam) {
  const ChannelKeys keys = channel_keys(example_key(), life);
  EXPECT_NE(keys.forward, keys.back);
  EXPECT_NE(channel_keys(example_key(), life + 1).forward, keys.forward);
  EXPECT_NE(channel_keys(example_key(), life + 1).back, keys.back);
  EXPECT_NE(channel_keys(Key(Key::Secret{}), life).forward, keys.forward);
}

TEST(ChannelKeys, AreNotTheKeyThatSealsAnnouncements) {
  const Key key = example_key();
  EXPECT_NE(key.channels(), key.sealing());
}

}  // namespace
}  // namespace geminga::sealing
