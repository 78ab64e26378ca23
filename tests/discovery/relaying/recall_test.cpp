// Words that a server has kept: what counts of them, and what does not, whatever the server does.
#include "discovery/relaying/recall.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "discovery/announcement/codec.hpp"
#include "discovery/relaying/voucher.hpp"
#include "discovery/sealing/envelope.hpp"
#include "discovery/sealing/rig.hpp"

namespace geminga::relaying {
namespace {

using announcement::Announcement;
using announcement::Kind;
using sealing::Member;
using sealing::Mode;
using sealing::Octets;

constexpr ParticipantId talking{0xa};
constexpr ParticipantId base_station{0xb};

Announcement said(Kind kind, std::uint64_t revision, std::uint64_t since = 0) {
  Announcement one;
  one.kind = kind;
  one.participant = talking;
  one.group = "default";
  one.revision = revision;
  one.since = since;
  if (kind == Kind::change) {
    one.peers.emplace_back().id = PeerId{1};
    one.peers.back().removed = {7};
  }
  return one;
}

announcement::Behind testimony(std::uint64_t revision) {
  return {.participant = talking, .revision = revision, .age = std::chrono::milliseconds(40)};
}

/// A participant, a relay that keeps its words, and a newcomer.
struct Rig {
  Octets word(const Announcement& one) { return talker.say(sealing::text_of(announcement::encode(one).front())); }
  /// The envelope in which a server keeps a word, by this relay.
  Octets kept(const Octets& word, Member& by) {
    Voucher voucher(by.seal);
    const auto relayed = voucher.wrap({.datagram = word, .source = "10.0.0.7"}, base_station);
    return sealing::copy_of(by.seal.seal_kept(announcement::encode(*relayed).front(), by.now));
  }
  Octets kept(const Announcement& one) { return kept(word(one), base); }
  sealing::Session session_of(const Octets& envelope) { return sealing::read_header(envelope)->session; }

  Member talker{1, sealing::policy(Mode::encrypted, {1})};
  Member base{2, sealing::policy(Mode::encrypted, {1})};
  Member newcomer{3, sealing::policy(Mode::encrypted, {1})};
  Recall recall{newcomer.seal};
};

TEST(Recall, GivesAStateThatItsRelayTestifiesFor) {
  Rig rig;
  const Octets kept = rig.kept(said(Kind::state, 3));
  ASSERT_TRUE(rig.recall.take(kept, rig.newcomer.now));
  const auto words = rig.recall.recall(rig.session_of(kept), base_station, testimony(3));
  ASSERT_EQ(words.size(), 1U);
  EXPECT_EQ(words.front().relayed.age, testimony(3).age) << "as old as the testimony, whatever the server says";
  EXPECT_EQ(words.front().relayed.source, "10.0.0.7");
  Voucher voucher(rig.newcomer.seal);
  const auto heard = voucher.unwrap(words.front(), ParticipantId{0xd}, rig.newcomer.now);
  ASSERT_TRUE(heard);
  EXPECT_EQ((*heard)->revision, 3U);
  EXPECT_TRUE(rig.recall.recall(rig.session_of(kept), base_station, testimony(3)).empty()) << "once";
  EXPECT_EQ(rig.recall.pending(), 0U);
}

TEST(Recall, PutsChangesBehindTheirStateInWhateverOrderTheyCome) {
  Rig rig;
  const Octets state = rig.kept(said(Kind::state, 3));
  const Octets change = rig.kept(said(Kind::change, 5, 3));
  const Octets next = rig.kept(said(Kind::change, 6, 5));
  for (const Octets& one : {next, state, change}) ASSERT_TRUE(rig.recall.take(one, rig.newcomer.now));
  EXPECT_EQ(rig.recall.recall(rig.session_of(state), base_station, testimony(6)).size(), 3U);
}

/// The server has kept everything that it ever saw, and has no key.
TEST(Recall, GivesNothingThatALiarWithTheServersPowerMayHavePutThere) {
  const auto nothing = [](Rig& rig, const Octets& kept, std::uint64_t revision) {
    (void)rig.recall.take(kept, rig.newcomer.now);
    return rig.recall.recall(rig.session_of(kept), base_station, testimony(revision)).empty();
  };
  Rig old;
  EXPECT_TRUE(nothing(old, old.kept(said(Kind::state, 3)), 4)) << "an older state";
  Rig part;
  EXPECT_TRUE(nothing(part, part.kept(said(Kind::change, 5, 3)), 5)) << "a change whose state is withheld";
  Rig gap;
  (void)gap.recall.take(gap.kept(said(Kind::state, 3)), gap.newcomer.now);
  EXPECT_TRUE(nothing(gap, gap.kept(said(Kind::change, 6, 5)), 6)) << "a change whose predecessor is withheld";
  Rig other;
  Member former(9, sealing::policy(Mode::encrypted, {1}));
  const Octets by_former = other.kept(other.word(said(Kind::state, 3)), former);
  (void)other.recall.take(by_former, other.newcomer.now);
  const Octets live = other.kept(said(Kind::state, 4));
  EXPECT_TRUE(other.recall.recall(other.session_of(live), base_station, testimony(3)).empty())
      << "a former session of the relay, or another relay";
  EXPECT_TRUE(other.recall.recall(other.session_of(by_former), talking, testimony(3)).empty())
      << "another participant of that session";
  Rig bent;
  EXPECT_FALSE(bent.recall.take(sealing::bent(bent.kept(said(Kind::state, 3)), 40), bent.newcomer.now));
  Rig foreign;
  Member stranger(8, sealing::policy(Mode::encrypted, {2}));
  EXPECT_FALSE(foreign.recall.take(foreign.kept(foreign.word(said(Kind::state, 3)), stranger), foreign.newcomer.now));
  Rig live_word;
  EXPECT_FALSE(live_word.recall.take(live_word.word(said(Kind::state, 3)), live_word.newcomer.now)) << "unwrapped";
  Rig claim;
  EXPECT_FALSE(claim.recall.take(claim.kept(said(Kind::claim, 0)), claim.newcomer.now));
  Rig unknown;
  EXPECT_TRUE(nothing(unknown, unknown.kept(said(Kind::state, 1)), 0)) << "the relay does not know the state itself";
}

TEST(Recall, HasRoomForSoManyWordsAndForgetsThemWithTime) {
  Rig rig;
  for (std::size_t i = 0; i < max_pending_words; ++i) {
    ASSERT_TRUE(rig.recall.take(rig.kept(said(Kind::state, i + 1)), rig.newcomer.now)) << i;
  }
  const Octets one_more = rig.kept(said(Kind::state, max_pending_words + 1));
  EXPECT_FALSE(rig.recall.take(one_more, rig.newcomer.now));
  rig.newcomer.pass(pending_time);
  EXPECT_TRUE(rig.recall.take(one_more, rig.newcomer.now));
  EXPECT_EQ(rig.recall.pending(), 1U);
}

TEST(Recall, TakesAWordThatWasWrittenAgainForTheSame) {
  Rig rig;
  const Octets word = rig.word(said(Kind::state, 3));
  EXPECT_TRUE(rig.recall.take(rig.kept(word, rig.base), rig.newcomer.now));
  EXPECT_TRUE(rig.recall.take(rig.kept(word, rig.base), rig.newcomer.now));
  EXPECT_EQ(rig.recall.pending(), 1U);
}

}  // namespace
}  // namespace geminga::relaying
