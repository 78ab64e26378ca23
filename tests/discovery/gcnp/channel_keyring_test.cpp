// The line with the keys of a channel: what is written is read, and what is damaged is refused without showing a key.
#include "discovery/gcnp/channel_keyring.hpp"

#include <gtest/gtest.h>

#include <string>

namespace geminga::gcnp {
namespace {

ChannelKeyring keyring_of(std::size_t keys) {
  ChannelKeyring keyring{.life = Life{0x0123456789abcdef}, .mode = "encrypted", .ring = {}};
  for (std::size_t i = 0; i < keys; ++i) {
    ChannelKey key{.id = static_cast<std::uint16_t>(0xbe00 + i)};
    key.forward.fill(static_cast<unsigned char>(i));
    key.back.fill(static_cast<unsigned char>(0xf0 + i));
    keyring.ring.push_back(key);
  }
  return keyring;
}

Statement with(const std::string& life, const std::string& mode, const std::string& ring) {
  return {
      .id = 5, .command = "pub", .subcommand = "keys", .parameters = {{"life", life}, {"mode", mode}, {"ring", ring}}};
}

TEST(ChannelKeyring, IsReadAsItIsWritten) {
  for (const std::size_t keys : {std::size_t{1}, std::size_t{2}, max_channel_keys}) {
    const ChannelKeyring keyring = keyring_of(keys);
    std::string line = to_line(to_statement(5, keyring));
    line.resize(line.size() - 2);
    const auto statement = parse(line);
    ASSERT_TRUE(statement);
    EXPECT_EQ(statement->id, 5U);
    EXPECT_EQ(read_channel_keyring(*statement), keyring);
  }
}

TEST(ChannelKeyring, HasNoRingWhereTheModeIsPlain) {
  const ChannelKeyring keyring{.life = Life{7}, .mode = "plain", .ring = {}};
  const Statement statement = to_statement(5, keyring);
  EXPECT_EQ(to_line(statement), "5 pub keys life=0000000000000007 mode=plain\r\n");
  EXPECT_EQ(read_channel_keyring(statement), keyring);
}

TEST(ChannelKeyring, RefusesNineKeysAndOctetsThatAreNone) {
  const std::string zeros(64, '0');
  const std::string life = "0123456789abcdef";
  const std::string one = "6208:" + zeros + ":" + zeros;
  EXPECT_TRUE(read_channel_keyring(with(life, "encrypted", one)));
  EXPECT_FALSE(read_channel_keyring(to_statement(5, keyring_of(max_channel_keys + 1))));
  for (const std::string& ring :
       {std::string(""), "6208:" + zeros, "620:" + zeros + ":" + zeros, "6208:" + zeros + ":" + zeros + "0",
        "6208:" + zeros + ":" + zeros + ":00", "zzzz:" + zeros + ":" + zeros, one + ",," + one,
        "6208:" + std::string(64, 'g') + ":" + zeros}) {
    const auto read = read_channel_keyring(with(life, "encrypted", ring));
    ASSERT_FALSE(read) << ring;
    EXPECT_EQ(read.error().text.find(zeros), std::string::npos) << "a key is shown";
  }
  EXPECT_FALSE(read_channel_keyring(with("0000000000000000", "encrypted", one)));
  EXPECT_FALSE(read_channel_keyring(with(life, "", one)));
  EXPECT_FALSE(read_channel_keyring(with(life, "plain", one)));
}

}  // namespace
}  // namespace geminga::gcnp
