// The octets of relays: words within their limits, testimony about many, and the room that a full word needs.
#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <vector>

#include "discovery/announcement/announcements.hpp"
#include "discovery/announcement/codec.hpp"
#include "discovery/announcement/limits.hpp"

namespace geminga::announcement {
namespace {

using std::chrono::milliseconds;

/// A word with the largest header that a relay may write.
Announcement word_of(std::size_t octets, std::size_t hops = max_hops) {
  Announcement word;
  word.kind = Kind::relayed;
  word.group = default_group;
  word.relayed.word.assign(octets, std::byte{0x47});
  word.relayed.age = max_relayed_age;
  for (std::size_t i = 1; i <= hops; ++i)
    word.relayed.through.push_back(ParticipantId{0xfffffff0U + static_cast<std::uint32_t>(i)});
  word.participant = hops > 0 ? word.relayed.through.back() : ParticipantId{1};
  word.relayed.source = "fd00::1";
  return word;
}

Announcement relay_of(std::size_t behind) {
  Announcement presence;
  presence.kind = Kind::presence;
  presence.group = default_group;
  presence.participant = ParticipantId{1};
  presence.lacks = {ParticipantId{7}};
  presence.sequence = 5;
  for (std::uint32_t i = 1; i <= behind; ++i)
    presence.behind.push_back({.participant = ParticipantId{100 + i},
                               .revision = i,
                               .age = milliseconds(i),
                               .hops = static_cast<std::uint8_t>(1 + i % max_hops),
                               .lost = static_cast<std::uint8_t>(i % 16)});
  return presence;
}

TEST(RelayCodec, FitsTheLargestWordIntoTheSmallestFrameOfIpv6) {
  for (const auto& [octets, error] : {std::tuple(max_word_bytes - 1, false), std::tuple(max_word_bytes, false),
                                      std::tuple(max_word_bytes + 1, true), std::tuple(std::size_t{0}, true)}) {
    const auto word = word_of(octets);
    const auto datagrams = encode(word);
    ASSERT_EQ(datagrams.size(), 1U);
    const auto decoded = decode(datagrams[0]);
    ASSERT_EQ(!decoded, error) << octets;
    if (error) {
      EXPECT_EQ(decoded.error(), DecodeError::bad_relayed);
    } else {
      EXPECT_EQ(*decoded, word);
      // 1280 octets with the headers of IPv6 and UDP.
      EXPECT_LE(datagrams[0].size() + env::max_envelope_bytes + 48, 1280U);
    }
  }
}

TEST(RelayCodec, SaysStatesThatEachRelayCanPassOn) {
  const auto state = [](std::size_t services) {
    auto all = worked_example();
    for (std::uint32_t i = 0; i < services; ++i) {
      auto one = all.peers[0].publications[0];
      one.number = 1000 + i;
      all.peers[0].publications.push_back(one);
    }
    return all;
  };
  for (const auto& datagram : encode(state(100))) EXPECT_LE(datagram.size() + env::max_envelope_bytes, max_word_bytes);
}

TEST(RelayCodec, LimitsTheWayOfAWord) {
  for (const auto& [hops, is_good] :
       {std::tuple(std::size_t{0}, false), std::tuple(std::size_t{1}, true), std::tuple(max_hops, true)})
    EXPECT_EQ(decode(encode(word_of(10, hops))[0]).has_value(), is_good) << hops;
  EXPECT_FALSE(decode(encode(word_of(10, max_hops + 1))[0]));
  auto twice = word_of(10);
  twice.relayed.through.front() = twice.relayed.through.back();
  EXPECT_FALSE(decode(encode(twice)[0]));
  auto of_another = word_of(10);
  of_another.participant = ParticipantId{3};
  EXPECT_FALSE(decode(encode(of_another)[0]));
}

TEST(RelayCodec, TestifiesAboutAnyNumberInPresencesThatAreWholeEach) {
  for (const std::size_t behind :
       {std::size_t{0}, std::size_t{1}, max_behind - 1, max_behind, max_behind + 1, std::size_t{1000}}) {
    const auto presence = relay_of(behind);
    std::vector<Behind> all;
    std::uint64_t sequence = presence.sequence;
    for (const auto& datagram : encode(presence)) {
      EXPECT_LE(datagram.size(), max_datagram_bytes);
      const auto decoded = decode(datagram);
      ASSERT_TRUE(decoded) << to_string(decoded.error());
      EXPECT_LE(decoded->behind.size(), max_behind);
      EXPECT_EQ(decoded->lacks.empty(), sequence != presence.sequence) << "questions stand in the first one";
      EXPECT_EQ(decoded->sequence, sequence++);
      all.insert(all.end(), decoded->behind.begin(), decoded->behind.end());
    }
    EXPECT_EQ(all, presence.behind) << behind;
  }
}

TEST(RelayCodec, SaysAnAgeRoundedUpAndNoneOverTheLimit) {
  auto word = word_of(10);
  word.relayed.age = std::chrono::microseconds(1);
  EXPECT_EQ(decode(encode(word)[0])->relayed.age, milliseconds(1));
  word.relayed.age = max_relayed_age + milliseconds(1);
  EXPECT_EQ(decode(encode(word)[0])->relayed.age, max_relayed_age);
}

}  // namespace
}  // namespace geminga::announcement
