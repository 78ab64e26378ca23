// Hostile datagrams and GCNP lines cost no other client and no other host anything.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <csignal>
#include <thread>

#include "base/random.hpp"
#include "support/lab.hpp"
#include "system/stranger.hpp"

namespace geminga::system {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

constexpr std::uint64_t seed = 4717;

/// The sum of all counters of refused datagrams in an answer to `query status`. Sealing counts datagrams that begin
/// like an envelope.
long refused(const std::vector<std::string>& lines) {
  const std::string status = lines.empty() ? "" : lines[0];
  long sum = 0;
  for (const std::string kind : {" rejected_", " sealing_"}) {
    for (auto at = status.find(kind); at != std::string::npos; at = status.find(kind, at + 1)) {
      sum += std::stol(status.substr(status.find('=', at) + 1));
    }
  }
  return sum;
}

bool wait_until_refused(Talk& talk, long count) {
  return talk.wait_until("status", [&](const auto& lines) { return refused(lines) >= count; });
}

TEST(HostileDatagrams, AreCountedAndHarmless) {
  constexpr int datagrams = 200;
  Lab lab(2);
  lab.start_all({"--interval", "0.1"});
  ASSERT_TRUE(lab.wait_for_participants(0, 2)) << lab.way();
  Talk consumer = lab.talk(0);
  consumer.say("1 sub create mode=otm/stream id=5");
  Talk provider = lab.talk(1);
  provider.say("1 pub create mode=otm/stream id=5 port=5000");
  ASSERT_TRUE(consumer.line_with({"1 pub add"}));

  const Stranger stranger(lab, 1);
  base::Random random(seed);
  for (int number = 0; number < datagrams; ++number) {
    std::string bytes(random.below(1473), '\0');
    for (char& byte : bytes) byte = static_cast<char>(random.below(256));
    ASSERT_TRUE(stranger.send(bytes));
    const bool keeps_up = number % 20 != 0 || wait_until_refused(consumer, number / 2);
    ASSERT_TRUE(keeps_up) << "seed " << seed;
  }
  EXPECT_TRUE(wait_until_refused(consumer, datagrams))
      << refused(consumer.query("status")) << " were counted; seed " << seed;
  ASSERT_TRUE(stranger.send(std::string(8000, 'x'))) << "longer than any frame";
  EXPECT_TRUE(wait_until_refused(consumer, datagrams + 1));
  EXPECT_THAT(consumer.lines_until_pong(), IsEmpty());
  provider.say("1 pub remove");
  EXPECT_TRUE(consumer.line_with({"1 pub del", "reason=withdrawn"}));
}

TEST(HostileClient, WithALineOfAMegabyteIsToldSoAndOthersDoNotNotice) {
  Lab lab(1);
  lab.start(0);
  Talk other = lab.talk(0);
  Talk hostile = lab.talk(0);
  ASSERT_TRUE(hostile.send("5 pub create text=\"" + std::string(1'000'000, 'x') + "\"\r\n"));
  const auto error = hostile.line();
  ASSERT_TRUE(error);
  EXPECT_THAT(*error, HasSubstr(" 413 "));
  EXPECT_THAT(hostile.lines_until_pong(), IsEmpty()) << "the connection goes on behind the line";
  EXPECT_THAT(other.lines_until_pong(), IsEmpty());
}

TEST(HostileClient, ThatAsksWithoutReadingHoldsNobodyUp) {
  Lab lab(1);
  lab.start(0);
  Talk other = lab.talk(0);
  Talk hostile = lab.talk(0);
  std::string questions;
  for (int number = 1; number <= 4000; ++number) questions += std::to_string(number) + " query status\r\n";
  EXPECT_TRUE(hostile.send(questions));
  EXPECT_THAT(other.query("participants"), testing::SizeIs(1));
  int answers = 0;
  while (answers < 4000 && hostile.line_with({" msg end"})) ++answers;
  EXPECT_EQ(answers, 4000) << "who reads late gets everything";
}

TEST(End, ComesUnderAFloodOfDatagramsAndStatements) {
  Lab lab(1);
  lab.start(0);
  const Stranger stranger(lab, 0);
  std::vector<Talk> talks;
  for (int number = 0; number < 4; ++number) talks.push_back(lab.talk(0));
  std::atomic<bool> is_over = false;
  std::vector<std::jthread> floods;  // end before the objects that they use
  floods.emplace_back([&] {
    const std::string junk(200, 'x');
    while (!is_over) (void)stranger.send(junk);
  });
  for (Talk& talk : talks) {
    floods.emplace_back([&] {
      std::string questions;
      for (int number = 1; number <= 100; ++number) questions += std::to_string(number) + " query status\r\n";
      while (!is_over && talk.send(questions)) (void)talk.lines_until_pong();
    });
  }
  EXPECT_TRUE(lab.talk(0).wait_until("status", [](const auto& lines) { return refused(lines) > 1000; }));
  lab.daemon(0).signal(SIGTERM);
  EXPECT_EQ(lab.daemon(0).wait(), 0);
  is_over = true;
}

TEST(Client, ThatEndsItsSideGetsItsAnswers) {
  Lab lab(1);
  lab.start(0);
  Talk talk = lab.talk(0);
  talk.say("1 query participants");
  talk.say("0 sys ping");
  talk.half_close();
  EXPECT_TRUE(talk.line_with({"1 msg participants "}));
  EXPECT_TRUE(talk.line_with({"0 msg pong"}));
  EXPECT_TRUE(talk.is_closed_by_daemon());
}

TEST(Client, ThatSaysByeIsClosed) {
  Lab lab(1);
  lab.start(0);
  Talk talk = lab.talk(0);
  talk.say("1 pub create mode=oto id=5 port=5000");
  talk.say("0 sys bye");
  EXPECT_TRUE(talk.is_closed_by_daemon());
  Talk other = lab.talk(0);
  EXPECT_THAT(other.query("services"), IsEmpty());
}

TEST(Clients, OverTheLimitAreToldSoAndTheOthersStay) {
  Lab lab(1);
  lab.start(0);
  std::vector<Talk> talks;
  std::optional<std::string> refusal;
  for (int number = 0; number < 200 && !refusal; ++number) {
    talks.push_back(lab.talk(0));
    const auto lines = talks.back().lines_until_pong();
    if (!lines.empty()) refusal = lines.front();
  }
  ASSERT_TRUE(refusal);
  EXPECT_THAT(*refusal, StartsWith("0 429 "));
  EXPECT_THAT(talks.front().lines_until_pong(), IsEmpty());
  talks.pop_back();  // the one that was refused
  talks.pop_back();
  Talk next = lab.talk(0);
  EXPECT_THAT(next.query("status"), testing::SizeIs(1)) << "the place of one that left is free";
}

}  // namespace
}  // namespace geminga::system
