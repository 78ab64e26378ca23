// Keys, rings of them, and the text of key files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "discovery/sealing/key_file.hpp"
#include "discovery/sealing/rig.hpp"

namespace geminga::sealing {
namespace {

using testing::HasSubstr;

std::string line_of(const Key::Secret& secret) {
  const std::string text = write_key(secret);
  return text.substr(text.find("\nkey ") + 1);
}

struct Wrong {
  std::string text;
  std::size_t line;
  std::string why;
};

TEST(KeyFile, IsReadAsItWasWritten) {
  Key::Secret secret{};
  for (std::size_t i = 0; i < secret.size(); ++i) secret[i] = static_cast<unsigned char>(i * 37);
  const auto key = read_key(write_key(secret));
  ASSERT_TRUE(key) << key.error().text;
  EXPECT_TRUE(*key == Key(secret));
  EXPECT_EQ(key->id(), Key(secret).id());
}

TEST(KeyFile, MayHaveCommentsEmptyLinesAndLineEndsOfAnySystem) {
  const std::string line = line_of({});
  EXPECT_TRUE(read_key("# ours\r\n\r\n" + line.substr(0, line.size() - 1) + "\r\n\n# end"));
  EXPECT_TRUE(read_key(line.substr(0, line.size() - 1)));
}

TEST(KeyFile, ThatIsWrongSaysWhereAndWhyAndNothingOfTheKey) {
  const std::string line = line_of({});
  const std::string id = to_string(Key({}).id());
  const std::vector<Wrong> cases{
      {"", 1, "no key in it"},
      {"# only this\n", 1, "no key in it"},
      {"\n\nhello\n", 3, "key ID SECRET"},
      {"key\n", 1, "key ID SECRET"},
      {"key abcd\n", 1, "key ID SECRET"},
      {line + line, 2, "second key"},
      {"# x\nkey " + id + " AAAA\n", 2, "32 octets"},
      {"key " + id + " !!!!\n", 1, "32 octets"},
      {line.substr(0, line.size() - 2) + "\n", 1, "32 octets"},
      {line.substr(0, line.size() - 1) + "x\n", 1, "32 octets"},
      {"key 0000 " + line.substr(9), 1, "was changed"},
      {std::string("key \0\0\0\0 \0", 11), 1, "32 octets"},
      {std::string(max_key_file_bytes + 1, '#'), 1, "longer than 4096 octets"},
  };
  for (const Wrong& wrong : cases) {
    const auto key = read_key(wrong.text);
    ASSERT_FALSE(key) << wrong.text;
    EXPECT_EQ(key.error().line, wrong.line) << wrong.text;
    EXPECT_THAT(key.error().text, HasSubstr(wrong.why));
    EXPECT_THAT(key.error().text, HasSubstr("gemingad --generate-key"));
    EXPECT_THAT(key.error().text, testing::Not(HasSubstr("AAAA")));
  }
}

TEST(KeyFile, MayHaveTheMostOctetsAndNoMore) {
  const std::string line = line_of({});
  for (const std::size_t size : {max_key_file_bytes - 1, max_key_file_bytes, max_key_file_bytes + 1}) {
    EXPECT_EQ(read_key(line + std::string(size - line.size(), '#')).has_value(), size <= max_key_file_bytes);
  }
}

TEST(Keyring, HoldsEightKeysTheFirstOfWhichSeals) {
  Keyring ring;
  for (int number = 1; number <= 8; ++number) EXPECT_EQ(ring.add(key_of(number)), Keyring::Added::yes);
  EXPECT_EQ(ring.add(key_of(9)), Keyring::Added::full);
  EXPECT_EQ(ring.keys().size(), max_keys);
  EXPECT_EQ(ring.first().id(), key_of(1).id());
  for (int number = 1; number <= 8; ++number) {
    ASSERT_NE(ring.find(key_of(number).id()), nullptr);
    EXPECT_TRUE(*ring.find(key_of(number).id()) == key_of(number));
  }
  EXPECT_EQ(ring.find(key_of(9).id()), nullptr);
}

TEST(Keyring, TakesNoKeyTwice) {
  Keyring ring;
  EXPECT_EQ(ring.add(key_of(1)), Keyring::Added::yes);
  EXPECT_EQ(ring.add(key_of(1)), Keyring::Added::id_taken);
}

}  // namespace
}  // namespace geminga::sealing
