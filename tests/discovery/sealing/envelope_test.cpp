// The envelope: a sealed text opens, and nothing else does.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "discovery/sealing/rig.hpp"

namespace geminga::sealing {
namespace {

Octets sealed(const Header& header, std::string_view text) {
  Octets datagram(text.size() + env::max_envelope_bytes);
  const Octets octets = octets_of(text);
  EXPECT_EQ(seal(key_of(1), header, octets, datagram), datagram.size());
  return datagram;
}

/// The text, or the word for why it is not opened.
std::string opened(const Octets& datagram, const Key& key = key_of(1)) {
  const auto header = read_header(datagram);
  if (!header) return std::string(to_string(header.error()));
  Octets text(datagram.size());
  const auto size = open(key, *header, datagram, text);
  return size ? text_of(std::span(text).first(*size)) : std::string(to_string(size.error()));
}

Header header_of(Protection protection, std::uint32_t counter = 7) {
  return {.protection = protection, .key = key_of(1).id(), .session = Session(0x1122334455667788), .counter = counter};
}

TEST(Envelope, OpensWhatWasSealedInBothModes) {
  for (const Protection protection : {Protection::authenticated, Protection::encrypted}) {
    for (const std::size_t size : {std::size_t{0}, std::size_t{1}, std::size_t{200}, std::size_t{1200}}) {
      const std::string text(size, 'x');
      const Octets datagram = sealed(header_of(protection), text);
      EXPECT_TRUE(is_sealed(datagram));
      EXPECT_EQ(read_header(datagram), header_of(protection));
      EXPECT_EQ(opened(datagram), text) << size;
    }
  }
}

TEST(Envelope, HidesTheTextOnlyWhereItIsEncrypted) {
  EXPECT_THAT(text_of(sealed(header_of(Protection::encrypted), "a secret")),
              testing::Not(testing::HasSubstr("secret")));
  EXPECT_THAT(text_of(sealed(header_of(Protection::authenticated), "no secret")), testing::HasSubstr("no secret"));
}

TEST(Envelope, TakesThirtyTwoOctets) {
  EXPECT_EQ(sealed(header_of(Protection::encrypted), "").size(), 32U);
  EXPECT_EQ(env::max_envelope_bytes, 32U);
}

TEST(Envelope, OpensNoDatagramWithAnyBitChanged) {
  for (const Protection protection : {Protection::authenticated, Protection::encrypted}) {
    const Octets datagram = sealed(header_of(protection), "odometry");
    for (std::size_t at = 1; at < datagram.size(); ++at) {
      for (int bit = 0; bit < 8; ++bit) {
        const std::string said = opened(bent(datagram, at, static_cast<std::uint8_t>(1 << bit)));
        EXPECT_THAT(said, testing::AnyOf("forged", "other-version")) << at << '.' << bit;
      }
    }
  }
}

TEST(Envelope, OpensNothingThatIsLongerOrShorter) {
  const Octets datagram = sealed(header_of(Protection::encrypted), "odometry");
  for (std::size_t size = 1; size < datagram.size(); ++size) {
    EXPECT_EQ(opened({datagram.begin(), datagram.begin() + static_cast<std::ptrdiff_t>(size)}),
              size < 32 ? "too-short" : "forged");
  }
  Octets longer = datagram;
  longer.push_back(std::byte{0});
  EXPECT_EQ(opened(longer), "forged");
}

TEST(Envelope, OpensNothingWithAnotherKey) {
  EXPECT_EQ(opened(sealed(header_of(Protection::encrypted), "x"), key_of(2)), "forged");
  EXPECT_EQ(opened(sealed(header_of(Protection::authenticated), "x"), key_of(2)), "forged");
}

TEST(Envelope, SealsTheSameTextDifferentlyEachTime) {
  EXPECT_NE(sealed(header_of(Protection::encrypted, 1), "x"), sealed(header_of(Protection::encrypted, 2), "x"));
}

TEST(Envelope, IsToldFromAnAnnouncementByItsFirstOctet) {
  EXPECT_FALSE(is_sealed({}));
  EXPECT_FALSE(is_sealed(octets_of("\x0dGMN\x01")));
  EXPECT_TRUE(is_sealed(octets_of("G")));
}

}  // namespace
}  // namespace geminga::sealing
