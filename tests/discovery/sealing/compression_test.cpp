// The gain of compression, and the bound of expanding.
#include "discovery/sealing/compression.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zstd.h>

#include <fstream>
#include <iterator>

#include "discovery/sealing/rig.hpp"

namespace geminga::sealing {
namespace {

/// A state of two peers as it is announced.
std::string state() {
  std::ifstream file(GEMINGA_SOURCE_DIR "/tests/fuzz/seeds/announcement/two-peers", std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

struct Compressing : testing::Test {
  /// The compressed text, or empty if that does not pay.
  Octets smaller(const Octets& text) {
    Octets octets(text.size());
    octets.resize(compression.compress(text, octets));
    return octets;
  }
  /// The text expanded into so much room, or the word for the failure.
  std::string expanded(std::span<const std::byte> octets, std::size_t room = max_text_bytes) {
    Octets text(room);
    const auto size = compression.expand(octets, text);
    return size ? text_of(std::span(text).first(*size)) : std::string(to_string(size.error()));
  }
  Compression compression;
};

TEST_F(Compressing, GivesTheSameTextBack) {
  const std::string text = state();
  const Octets octets = smaller(octets_of(text));
  ASSERT_FALSE(octets.empty());
  EXPECT_LE(octets.size() + min_saved_bytes, text.size());
  EXPECT_EQ(expanded(octets), text);
  EXPECT_EQ(smaller(octets_of(text)), octets) << "equal texts give equal octets";
}

TEST_F(Compressing, DoesNotPayForWhatIsShortOrHasNoOrder) {
  base::Random random(1);
  Octets noise(1200);
  for (std::byte& octet : noise) octet = static_cast<std::byte>(random.next());
  EXPECT_TRUE(smaller(noise).empty());
  const std::string zeros(min_compressed_bytes, '0');
  EXPECT_TRUE(smaller(octets_of(zeros.substr(1))).empty());
  EXPECT_FALSE(smaller(octets_of(zeros)).empty());
  EXPECT_TRUE(smaller({}).empty());
}

TEST_F(Compressing, ExpandsNothingBeyondItsBound) {
  const std::string text = state();
  const Octets octets = smaller(octets_of(text));
  for (const std::size_t room : {text.size() + 1, text.size(), text.size() - 1, std::size_t{0}}) {
    EXPECT_EQ(expanded(octets, room), room >= text.size() ? text : "malformed") << room;
  }
  // Sixteen megabytes of zeros in some octets: a stolen key could send that.
  std::string zeros(std::size_t{1} << 24, '\0');
  std::string bomb(ZSTD_compressBound(zeros.size()), ' ');
  bomb.resize(ZSTD_compress(bomb.data(), bomb.size(), zeros.data(), zeros.size(), 1));
  const Octets large = octets_of(bomb.substr(4));
  EXPECT_EQ(expanded(std::span(large).first(std::min(large.size(), std::size_t{1200}))), "malformed");
}

TEST_F(Compressing, RefusesWhatIsCutOrBentOrNothing) {
  const Octets octets = smaller(octets_of(state()));
  for (std::size_t size = 0; size < octets.size(); ++size) {
    EXPECT_EQ(expanded(std::span(octets).first(size)), "malformed") << size;
  }
  for (std::size_t at = 0; at < octets.size(); ++at) (void)expanded(bent(octets, at));
}

TEST(Seal, SaysALongAnnouncementInFewerOctetsAndAShortOneAsItIs) {
  Member one(1, policy(Mode::encrypted, {1}));
  Member other(2, policy(Mode::authenticated, {1}));
  introduce(one, other);
  one.pass(std::chrono::seconds(2));
  const std::string text = state();
  const Octets datagram = one.say(text);
  EXPECT_LT(datagram.size(), text.size());
  EXPECT_TRUE(read_header(datagram)->is_compressed);
  EXPECT_EQ(other.hear(datagram), text);
  EXPECT_FALSE(read_header(one.say("presence"))->is_compressed);
}

TEST(Seal, RefusesWhatIsSaidToBeCompressedAndIsNot) {
  Member one(1, policy(Mode::encrypted, {1}));
  Member other(2, policy(Mode::encrypted, {1}));
  introduce(one, other);
  Header header = *read_header(one.say("x"));
  header.is_compressed = true;
  header.has_greeting = false;
  ++header.counter;
  Octets datagram(8 + env::max_envelope_bytes);
  (void)seal(key_of(1), header, octets_of("no frame"), datagram);
  EXPECT_EQ(other.hear(datagram), "malformed");
}

}  // namespace
}  // namespace geminga::sealing
