// The worked examples of SEALING.md against sealing and opening.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "base/text.hpp"
#include "discovery/sealing/key_file.hpp"
#include "discovery/sealing/rig.hpp"

namespace geminga::sealing {
namespace {

std::string specification() {
  std::ifstream file(GEMINGA_SOURCE_DIR "/src/discovery/sealing/SEALING.md");
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

/// The octets in the first column of the table under this heading.
std::string octets_under(const std::string& heading) {
  std::istringstream file(specification());
  std::string hex;
  bool is_here = false;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("#")) is_here = line == heading;
    if (is_here && line.starts_with("| `")) hex += line.substr(3, line.find('`', 3) - 3) + ' ';
  }
  return hex;
}

std::string hex_of(std::span<const std::byte> octets) {
  std::string hex;
  for (const std::byte octet : octets) hex += base::to_hex(static_cast<std::uint8_t>(octet), 2) + ' ';
  return hex;
}

/// The key whose octets are 0, 1, 2, ... 31.
Key example_key() {
  Key::Secret secret{};
  for (std::size_t i = 0; i < secret.size(); ++i) secret[i] = static_cast<unsigned char>(i);
  return Key(secret);
}

std::string example(Protection protection, const Greeting& greeting) {
  Octets text(max_greeting_bytes);
  text.resize(greeting.is_empty() ? 0 : write_greeting(greeting, text));
  const bool has_greeting = !text.empty();
  for (const std::byte octet : octets_of("ball")) text.push_back(octet);
  Octets datagram(text.size() + env::max_envelope_bytes);
  (void)seal(example_key(),
             {.protection = protection,
              .has_greeting = has_greeting,
              .key = example_key().id(),
              .session = Session(0x1122334455667788),
              .counter = 3},
             text, datagram);
  return hex_of(datagram);
}

TEST(SealingSpecification, ItsAuthenticatedExampleIsWhatIsSealed) {
  const Greeting greeting{.keys = {example_key().id(), KeyId(0xbeef)},
                          .challenge = Challenge(0xc1c2c3c4c5c6c7c8),
                          .asked = {SessionTag(0xaabb)},
                          .echoes = {Challenge(0xe1e2e3e4e5e6e7e8)}};
  EXPECT_EQ(example(Protection::authenticated, greeting), octets_under("### Authenticated, with a greeting"));
}

TEST(SealingSpecification, ItsEncryptedExampleIsWhatIsSealed) {
  EXPECT_EQ(example(Protection::encrypted, {}), octets_under("### Encrypted"));
}

TEST(SealingSpecification, ItsKeyFileIsRead) {
  const std::string text = specification();
  const auto begin = text.find("\nkey ") + 1;
  const auto key = read_key(text.substr(begin, text.find('\n', begin) - begin));
  ASSERT_TRUE(key) << key.error().text;
  EXPECT_TRUE(*key == example_key());
}

TEST(SealingSpecification, NamesEveryReasonForRejection) {
  for (std::size_t i = 0; i < rejection_count; ++i) {
    EXPECT_THAT(specification(), testing::HasSubstr("`" + std::string(to_string(Rejection(i))) + "`"));
  }
}

TEST(SealingSpecification, NamesEveryMode) {
  for (const Mode mode : {Mode::plain, Mode::prepared, Mode::mixed, Mode::authenticated, Mode::encrypted}) {
    EXPECT_THAT(specification(), testing::HasSubstr("`" + std::string(to_string(mode)) + "`"));
  }
}

}  // namespace
}  // namespace geminga::sealing
