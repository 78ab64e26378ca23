// A consumer's half of the handshake, in given time.
#include "client/protocol/handshake.hpp"

#include <gtest/gtest.h>

#include <chrono>

namespace geminga::client {
namespace {

using namespace std::chrono_literals;

constexpr base::Instant start{1000s};
constexpr Life publisher{7};
constexpr Life own{8};
constexpr std::uint64_t challenge = 9;

/// A floor or full with its payload.
struct Answer {
  Answer(FrameKind kind, std::uint64_t sequence, Greeting greeting)
      : payload(greeting_payload(greeting)), frame{kind, publisher, sequence, payload} {}
  std::array<std::byte, greeting_bytes> payload;
  Frame frame;
};
Answer floor(std::uint64_t sequence, std::uint64_t cookie) {
  return {FrameKind::floor, sequence, {own, challenge, cookie}};
}

TEST(Handshake, SaysHelloAgainLessAndLessOften) {
  Handshake handshake(publisher, own, challenge);
  EXPECT_EQ(handshake.greeting(), (Greeting{publisher, challenge, 0}));
  for (const auto wait : {20ms, 40ms, 80ms, 160ms, 320ms, 640ms, 1000ms, 1000ms}) {
    EXPECT_EQ(handshake.said(start), start + wait);
  }
  EXPECT_EQ(handshake.on_floor(floor(1, 0).frame, false), Handshake::Next::go_on);
  EXPECT_EQ(handshake.said(start), start + 1s);
}

TEST(Handshake, GivesTheCookieBackAtOnceAndOnlyOnce) {
  Handshake handshake(publisher, own, challenge);
  EXPECT_EQ(handshake.on_floor(floor(5, 77).frame, true), Handshake::Next::say_hello);
  EXPECT_EQ(handshake.greeting().cookie, 77U);
  EXPECT_EQ(handshake.on_floor(floor(5, 77).frame, true), Handshake::Next::nothing) << "no flood of hellos";
  EXPECT_FALSE(handshake.is_accepted());
  EXPECT_EQ(handshake.on_floor(floor(6, 0).frame, true), Handshake::Next::go_on);
  EXPECT_TRUE(handshake.is_accepted());
  EXPECT_EQ(handshake.floor(), 5U) << "that of the first floor";
  EXPECT_EQ(handshake.on_floor(floor(9, 78).frame, true), Handshake::Next::say_hello) << "it was forgotten";
  EXPECT_FALSE(handshake.is_accepted());
}

TEST(Handshake, TakesNoAnswerToAnotherChallenge) {
  Handshake handshake(publisher, own, challenge);
  for (const Greeting& other : {Greeting{own, challenge + 1, 0}, Greeting{Life{1}, challenge, 0}}) {
    EXPECT_EQ(handshake.on_floor(Answer(FrameKind::floor, 5, other).frame, true), Handshake::Next::nothing);
    EXPECT_FALSE(handshake.on_full(Answer(FrameKind::full, 5, other).frame));
  }
  EXPECT_EQ(handshake.on_floor({FrameKind::floor, publisher, 5, {}}, true), Handshake::Next::nothing);
  EXPECT_FALSE(handshake.floor()) << "a recording has no floor";
  EXPECT_FALSE(handshake.is_accepted());
}

TEST(Handshake, HasNoFloorWithoutAKey) {
  Handshake handshake(publisher, own, challenge);
  EXPECT_EQ(handshake.on_floor(floor(5, 0).frame, false), Handshake::Next::go_on);
  EXPECT_FALSE(handshake.floor());
  EXPECT_EQ(handshake.on_floor(floor(8, 0).frame, true), Handshake::Next::go_on);
  EXPECT_EQ(handshake.floor(), 8U);
}

TEST(Handshake, TellsOnceThatThereIsNoPlace) {
  Handshake handshake(publisher, own, challenge);
  const Answer full(FrameKind::full, 5, {own, challenge, 0});
  EXPECT_TRUE(handshake.on_full(full.frame));
  EXPECT_FALSE(handshake.on_full(full.frame));
  EXPECT_EQ(handshake.said(start), start + 20ms) << "it goes on asking";
  EXPECT_EQ(handshake.on_floor(floor(5, 0).frame, false), Handshake::Next::go_on);
  EXPECT_TRUE(handshake.on_full(full.frame)) << "it has lost its place";
  EXPECT_FALSE(handshake.is_accepted());
  EXPECT_EQ(handshake.said(start), start + 1s);
}

}  // namespace
}  // namespace geminga::client
