// Words of others, wrapped and unwrapped without a daemon, as a bridge does it.
#include "discovery/relaying/voucher.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "discovery/announcement/codec.hpp"
#include "discovery/announcement/limits.hpp"
#include "discovery/relaying/speakers.hpp"
#include "discovery/sealing/rig.hpp"

namespace geminga::relaying {
namespace {

using announcement::Announcement;
using sealing::Member;
using sealing::Mode;
using std::chrono::seconds;

constexpr ParticipantId speaker{0xa};
constexpr ParticipantId first{0xb};
constexpr ParticipantId second{0xc};
constexpr ParticipantId receiver{0xd};

Announcement claim() {
  Announcement said;
  said.kind = announcement::Kind::claim;
  said.participant = speaker;
  said.group = "default";
  return said;
}

/// A member of a team that says claims, relays them, or hears them from relays.
struct Station {
  explicit Station(int seed, const sealing::Policy& how = sealing::policy(Mode::encrypted, {1}))
      : member(seed, how), voucher(member.seal) {}
  std::vector<std::byte> say(const Announcement& said) {
    const auto text = announcement::encode(said).front();
    const auto datagram = member.seal.seal(text, sealing::wlan, member.now);
    return {datagram.begin(), datagram.end()};
  }
  Member member;
  Voucher voucher;
};

TEST(Voucher, GivesBackTheWordOfASessionThatHasProvedNothing) {
  Station a(1);
  Station b(2);
  Station c(3);
  const auto word = a.say(claim());
  const auto relayed = b.voucher.wrap({.datagram = word, .source = "fe80::1%eth0"}, first);
  ASSERT_TRUE(relayed);
  EXPECT_EQ(relayed->relayed.source, "fe80::1");
  const auto unwrapped = c.voucher.unwrap(*relayed, receiver, c.member.now);
  ASSERT_TRUE(unwrapped) << to_string(unwrapped.error());
  EXPECT_EQ((*unwrapped)->participant, speaker);
  EXPECT_EQ(c.member.hear(word), "unproved") << "what a relay vouches for counts from relays alone";
}

TEST(Voucher, HearsAWordOnceWhicheverRelayBringsIt) {
  Station a(1);
  Station b(2);
  Station c(3);
  const auto word = a.say(claim());
  const auto by_first = b.voucher.wrap({.datagram = word}, first);
  const auto by_second = b.voucher.wrap({.datagram = word}, second);
  EXPECT_TRUE(c.voucher.unwrap(*by_first, receiver, c.member.now));
  EXPECT_EQ(c.voucher.unwrap(*by_second, receiver, c.member.now).error(), Refusal::repeated);
  EXPECT_EQ(c.voucher.refused(Refusal::repeated), 1U);
}

TEST(Voucher, PassesNothingRoundAndNothingTooFar) {
  Station a(1);
  Station b(2);
  const auto word = a.say(claim());
  std::vector<ParticipantId> through;
  for (std::uint32_t hop = 1; hop <= announcement::max_hops; ++hop) {
    const auto relayed = b.voucher.wrap({.datagram = word, .through = through}, ParticipantId{100 + hop});
    ASSERT_TRUE(relayed) << hop;
    through = relayed->relayed.through;
    EXPECT_EQ(b.voucher.unwrap(*relayed, ParticipantId{101}, b.member.now).error(), Refusal::looped) << hop;
  }
  EXPECT_EQ(b.voucher.wrap({.datagram = word, .through = through}, second).error(), Refusal::too_far);
}

TEST(Voucher, RefusesForgeriesOtherKindsAndWhatIsTooLarge) {
  Station a(1);
  Station stranger(2, sealing::policy(Mode::encrypted, {2}));
  Station c(3);
  const auto forged = c.voucher.wrap({.datagram = stranger.say(claim())}, first);
  EXPECT_EQ(c.voucher.unwrap(*forged, receiver, c.member.now).error(), Refusal::unreadable);
  Station unsealed(4, {});
  const auto plain = c.voucher.wrap({.datagram = unsealed.say(claim())}, first);
  EXPECT_EQ(c.voucher.unwrap(*plain, receiver, c.member.now).error(), Refusal::unreadable)
      << "a relay seals nothing up";
  EXPECT_TRUE(unsealed.voucher.unwrap(*plain, receiver, c.member.now));
  auto presence = claim();
  presence.kind = announcement::Kind::presence;
  const auto other = c.voucher.wrap({.datagram = a.say(presence)}, first);
  EXPECT_EQ(c.voucher.unwrap(*other, receiver, c.member.now).error(), Refusal::other_kind);
  for (const std::size_t octets : {announcement::max_word_bytes - 1, announcement::max_word_bytes})
    EXPECT_TRUE(c.voucher.wrap({.datagram = std::vector<std::byte>(octets)}, first)) << octets;
  EXPECT_EQ(c.voucher.wrap({.datagram = std::vector<std::byte>(announcement::max_word_bytes + 1)}, first).error(),
            Refusal::too_large);
}

TEST(Speakers, StandBackForTheNearerOneUntilItIsSilent) {
  Speakers speakers;
  const Speakers::Place place{env::InterfaceIndex{2}, speaker};
  base::Instant now{std::chrono::hours(1)};
  speakers.hear(place, {1, first}, seconds(2), now);
  EXPECT_TRUE(speakers.has_better(place, {1, second}, now));
  EXPECT_FALSE(speakers.has_better(place, {1, ParticipantId{1}}, now)) << "of equals the lower identifier speaks";
  EXPECT_EQ(speakers.due(), now + std::chrono::milliseconds(3200));
  EXPECT_FALSE(speakers.take_silent(speakers.due() - base::Duration(1)));
  now = speakers.due();
  EXPECT_TRUE(speakers.take_silent(now));
  EXPECT_FALSE(speakers.has_better(place, {1, second}, now));
  speakers.hear(place, {1, first}, seconds(2), now);
  speakers.doubt(place);
  EXPECT_FALSE(speakers.has_better(place, {1, second}, now)) << "whoever can answers a doubt";
}

}  // namespace
}  // namespace geminga::relaying
