// Counterparts, sequences, queues, back-off, addresses and conversions, in given time.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>

#include "client/protocol/backoff.hpp"
#include "client/protocol/converter.hpp"
#include "client/protocol/counterparts.hpp"
#include "client/protocol/peer_address.hpp"
#include "client/protocol/send_queue.hpp"
#include "client/protocol/sequence.hpp"
#include "client/protocol/vector_file.hpp"

namespace geminga::client {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::IsEmpty;
using Carrier = Counterparts::Carrier;
using Parting = Counterparts::Parting;

constexpr base::Instant start{1000s};
constexpr Life one_life{1};
constexpr Life other_life{2};

ServiceKey key(std::uint32_t number) { return {ParticipantId{7}, PeerId{1}, number}; }

TEST(Counterparts, KnowTheSameLifeUnderAnyKey) {
  Counterparts counterparts;
  const auto first = counterparts.add(one_life, key(1));
  EXPECT_TRUE(first.is_new);
  const auto again = counterparts.add(one_life, key(2));
  EXPECT_FALSE(again.is_new);
  EXPECT_EQ(again.number, first.number);
  EXPECT_FALSE(counterparts.find(key(1)));
  EXPECT_EQ(counterparts.find(key(2)), first.number);
}

TEST(Counterparts, WithoutALifeAreKnownByTheirKeys) {
  Counterparts counterparts;
  EXPECT_TRUE(counterparts.add(no_life, key(1)).is_new);
  EXPECT_TRUE(counterparts.add(no_life, key(2)).is_new);
  EXPECT_FALSE(counterparts.add(no_life, key(1)).is_new);
}

TEST(Counterparts, AreClosedWhereTheirMatchEnded) {
  for (const char* reason : {"outranked", "changed"}) {
    Counterparts counterparts;
    const auto number = counterparts.add(one_life, key(1)).number;
    const auto parted = counterparts.del(key(1), reason, Carrier::connection, start);
    EXPECT_EQ(parted.number, number);
    EXPECT_EQ(parted.parting, Parting::close) << reason;
  }
}

TEST(Counterparts, FinishWhereTheyWereWithdrawn) {
  Counterparts counterparts;
  const auto number = counterparts.add(one_life, key(1)).number;
  EXPECT_EQ(counterparts.del(key(1), "withdrawn", Carrier::connection, start).parting, Parting::finish);
  EXPECT_THAT(counterparts.expired(start + drain_patience - 1ns), IsEmpty());
  counterparts.go_on_finishing(number, start + 1s);
  EXPECT_THAT(counterparts.expired(start + drain_patience), IsEmpty());
  EXPECT_THAT(counterparts.expired(start + 1s + drain_patience), ElementsAre(number));
}

TEST(Counterparts, OutliveTheSightOfDaemonsOverUdpForTenSeconds) {
  Counterparts counterparts;
  const auto number = counterparts.add(one_life, key(1)).number;
  EXPECT_EQ(counterparts.del(key(1), "expired", Carrier::datagrams, start).parting, Parting::go_on);
  EXPECT_THAT(counterparts.expired(start + orphan_patience - 1ns), IsEmpty());
  EXPECT_THAT(counterparts.expired(start + orphan_patience), ElementsAre(number));
  EXPECT_FALSE(counterparts.add(one_life, key(9)).is_new) << "the same life is the same channel";
  EXPECT_EQ(counterparts.next_end(), base::never);
}

TEST(Counterparts, OutliveItOverTcpAsLongAsTheConnection) {
  Counterparts counterparts;
  counterparts.add(one_life, key(1));
  EXPECT_EQ(counterparts.del(key(1), "left", Carrier::connection, start).parting, Parting::go_on);
  EXPECT_EQ(counterparts.next_end(), base::never);
  counterparts.add(other_life, key(2));
  EXPECT_EQ(counterparts.del(key(2), "left", Carrier::no_connection, start).parting, Parting::close);
}

TEST(Counterparts, AreDoubtedWithoutADaemonAndOrphansWhenNobodyConfirmsThem) {
  Counterparts counterparts;
  const auto one = counterparts.add(one_life, key(1)).number;
  const auto other = counterparts.add(other_life, key(2)).number;
  counterparts.doubt();
  EXPECT_THAT(counterparts.expired(start + 1h), IsEmpty()) << "however long that takes";
  EXPECT_FALSE(counterparts.add(one_life, key(3)).is_new);
  EXPECT_THAT(counterparts.settle([](auto) { return Carrier::datagrams; }, start), IsEmpty());
  EXPECT_EQ(counterparts.at(one).state, Counterparts::State::matched);
  EXPECT_EQ(counterparts.at(other).state, Counterparts::State::orphaned);
  EXPECT_EQ(counterparts.at(other).reason, "disconnected");
}

TEST(Counterparts, LeaveNoRoomForOrphansBesideTheLimit) {
  Counterparts counterparts;
  const auto orphan = counterparts.add(one_life, key(1)).number;
  counterparts.del(key(1), "expired", Carrier::datagrams, start);
  EXPECT_THAT(counterparts.superfluous(1), IsEmpty());
  counterparts.add(other_life, key(2));
  EXPECT_THAT(counterparts.superfluous(2), IsEmpty());
  EXPECT_THAT(counterparts.superfluous(0), IsEmpty()) << "there is no limit";
  EXPECT_THAT(counterparts.superfluous(1), ElementsAre(orphan));
}

TEST(Sequence, DeliverWhatIsNewerAndCountWhatIsMissing) {
  Sequence sequences;
  EXPECT_EQ(sequences.take(one_life, 5), 0U) << "what came before the first was not missed";
  EXPECT_EQ(sequences.take(one_life, 6), 0U);
  EXPECT_EQ(sequences.take(one_life, 6), std::nullopt);
  EXPECT_EQ(sequences.take(one_life, 9), 2U);
  EXPECT_EQ(sequences.take(one_life, 8), std::nullopt);
  EXPECT_EQ(sequences.take(other_life, 8), 0U);
  EXPECT_EQ(sequences.missed_at_end(one_life, 12), 3U);
  EXPECT_EQ(sequences.missed_at_end(one_life, 9), 0U);
}

TEST(Sequence, KnowWithoutAKeyWhatIsNewAsEveryLanguageDoes) {
  const auto rows = vector_rows("sequence.tsv", 2);
  ASSERT_GE(rows.size(), 15U);
  for (const auto& row : rows) {
    Sequence sequences;
    std::vector<std::string> results;
    for (const std::string& word : words_of(row[0])) {
      if (word == "again") {
        sequences.interrupt(one_life);
        continue;
      }
      const auto colon = word.find(':');
      const base::Instant at = start + std::chrono::milliseconds(std::stoul(word.substr(0, colon)));
      const auto missed = sequences.take_unproved(one_life, std::stoull(word.substr(colon + 1)), at);
      results.push_back(missed ? std::to_string(*missed) : "-");
    }
    EXPECT_EQ(results, words_of(row[1])) << row[0].substr(0, 100);
  }
}

TEST(Sequence, DeliverWithAKeyWhatIsNewerHoweverFar) {
  Sequence sequences;
  EXPECT_EQ(sequences.take(one_life, 1), 0U);
  EXPECT_EQ(sequences.take(one_life, 1'000'000), 999'998U);
  EXPECT_EQ(sequences.take(one_life, 999'999), std::nullopt);
}

TEST(Sequence, DoNotMissWhatWasSentWhileTheChannelWasClosed) {
  Sequence sequences;
  EXPECT_EQ(sequences.take(one_life, 5), 0U);
  sequences.interrupt(one_life);
  EXPECT_EQ(sequences.missed_at_end(one_life, 50), 0U);
  EXPECT_EQ(sequences.take(one_life, 4), std::nullopt) << "and deliver nothing twice";
  EXPECT_EQ(sequences.take(one_life, 50), 0U);
  EXPECT_EQ(sequences.take(one_life, 52), 1U);
}

TEST(Sequence, RememberTheLivesThatWereHeardLast) {
  for (const std::size_t others : {max_remembered_lives - 1, max_remembered_lives}) {
    Sequence sequences;
    EXPECT_EQ(sequences.take(one_life, 5), 0U);
    for (std::uint64_t life = 100; life < 100 + others; ++life) EXPECT_EQ(sequences.take(Life{life}, 1), 0U);
    EXPECT_EQ(sequences.take(one_life, 5).has_value(), others == max_remembered_lives) << others;
  }
}

TEST(SendQueue, TakesOneMessageOfAnySizeAndElseFourMebibytes) {
  SendQueue queue;
  EXPECT_TRUE(queue.has_room(max_stream_payload));
  queue.put(std::make_shared<const std::vector<std::byte>>(1000));
  const std::size_t left = max_waiting_for_consumer - 1000 - frame_header_bytes;
  EXPECT_TRUE(queue.has_room(left - 1));
  EXPECT_TRUE(queue.has_room(left));
  EXPECT_FALSE(queue.has_room(left + 1));
  queue.wrote(400);
  EXPECT_TRUE(queue.has_room(left + 400));
  EXPECT_FALSE(queue.has_room(left + 401));
  queue.wrote(600);
  EXPECT_TRUE(queue.is_empty());
}

TEST(WaitingFrames, CountEachFrameOnceAsLongAsAnybodyWaitsForIt) {
  WaitingFrames waiting;
  SendQueue one;
  SendQueue other;
  auto frame = waiting.share(std::vector<std::byte>(1000));
  one.put(frame);
  other.put(std::move(frame));
  EXPECT_EQ(waiting.octets(), 1000U);
  one.wrote(1000);
  EXPECT_EQ(waiting.octets(), 1000U);
  other.wrote(999);
  EXPECT_EQ(waiting.octets(), 1000U);
  other.wrote(1);
  EXPECT_EQ(waiting.octets(), 0U);
}

TEST(SendQueue, TakesALimitedNumberOfSmallFrames) {
  SendQueue queue;
  const auto frame = std::make_shared<const std::vector<std::byte>>(frame_header_bytes);
  for (std::size_t i = 0; i + 1 < max_frames_for_consumer; ++i) queue.put(frame);
  EXPECT_TRUE(queue.has_room(0));
  queue.put(frame);
  EXPECT_FALSE(queue.has_room(0));
  queue.wrote(frame_header_bytes);
  EXPECT_TRUE(queue.has_room(0));
}

TEST(SendQueue, GoesOnBehindWhatIsWritten) {
  SendQueue queue;
  queue.put(std::make_shared<const std::vector<std::byte>>(10), 4);
  queue.put(std::make_shared<const std::vector<std::byte>>(5));
  EXPECT_EQ(queue.front().size(), 6U);
  queue.wrote(6);
  EXPECT_EQ(queue.front().size(), 5U);
}

TEST(Backoff, DoublesUpToASecondAndAddsAQuarterByChance) {
  Backoff backoff;
  for (const auto base : {100ms, 200ms, 400ms, 800ms, 1000ms, 1000ms}) EXPECT_EQ(backoff.next(0), base);
  backoff.reset();
  EXPECT_EQ(backoff.next(25'000), 125ms);
  EXPECT_LE(backoff.next(~0ULL), 250ms);
}

TEST(PeerAddress, IsTheSameInBothFamilies) {
  const auto four = *peer_address("10.0.0.1", 5000);
  EXPECT_TRUE(four.is_ipv4());
  for (const int family : {AF_INET, AF_INET6}) EXPECT_EQ(peer_address(system_address(four, family)->storage), four);
  EXPECT_EQ(to_string(four), "10.0.0.1:5000");
  const auto six = *peer_address("2001:db8::1", 5000);
  EXPECT_EQ(peer_address(system_address(six, AF_INET6)->storage), six);
  EXPECT_FALSE(system_address(six, AF_INET));
  EXPECT_EQ(to_string(six), "[2001:db8::1]:5000");
  EXPECT_TRUE(peer_address("239.1.2.3", 1)->is_multicast());
  EXPECT_TRUE(peer_address("ff02::1", 1)->is_multicast());
  EXPECT_FALSE(four.is_multicast());
  EXPECT_FALSE(peer_address("robot2", 1));
}

std::vector<std::byte> bytes(std::string_view text) {
  const auto view = std::as_bytes(std::span(text));
  return {view.begin(), view.end()};
}

Conversion append(const char* text) {
  return [text](std::span<const std::byte> payload) {
    std::vector<std::byte> after(payload.begin(), payload.end());
    const auto more = bytes(text);
    after.insert(after.end(), more.begin(), more.end());
    return after;
  };
}

TEST(Conversions, AreAppliedInTheirOrderOrAllAtOnce) {
  Conversions conversions{{"A>B", append("1")}, {"B>C", append("2")}};
  EXPECT_EQ(*convert(conversions, "A>B>C", bytes("x")), bytes("x12"));
  EXPECT_EQ(*convert(conversions, "A>B", bytes("x")), bytes("x1"));
  EXPECT_EQ(*convert(conversions, "", bytes("x")), bytes("x"));
  conversions["A>C"] = append("3");
  EXPECT_EQ(*convert(conversions, "A>B>C", bytes("x")), bytes("x3"));
}

TEST(Conversions, SayWhoWouldDoWhatIsMissing) {
  const Conversions conversions{{"A>B", append("1")}, {"C>D", append("3")}};
  const std::string_view via = "-,udp://10.0.0.7:6000/0000002a/1/1,-";
  const auto missing = convert(conversions, "A>B>C>D", bytes("x"), via);
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error(),
            "there is no function for the conversion B>C, which the service udp://10.0.0.7:6000/0000002a/1/1 does");
  EXPECT_EQ(convert(conversions, "A>B>C>D", bytes("x")).error(), "there is no function for the conversion B>C");
  EXPECT_EQ(convert(conversions, "A>C", bytes("x"), "-").error(), "there is no function for the conversion A>C");
  EXPECT_EQ(*convert(conversions, "A>B", bytes("x"), "udp://10.0.0.7:6000/0000002a/1/1"), bytes("x1"))
      << "a function is as good as the service";
}

TEST(Conversions, KnowIrisByTheirBrackets) {
  const Conversions conversions{{"<http://a.example/#A>>s:B", append("1")}, {"s:B><http://a.example/#C>", append("2")}};
  EXPECT_EQ(*convert(conversions, "<http://a.example/#A>>s:B><http://a.example/#C>", bytes("x")), bytes("x12"));
  const auto missing = convert(conversions, "<http://a.example/#A>><http://a.example/#C>", bytes("x"));
  ASSERT_FALSE(missing);
  EXPECT_THAT(missing.error(), testing::HasSubstr("<http://a.example/#A>><http://a.example/#C>"));
}

TEST(Conversions, SayWhatIsMissingOrThrew) {
  Conversions conversions{{"A>B", append("1")}};
  const auto missing = convert(conversions, "A>B>C", bytes("x"));
  ASSERT_FALSE(missing);
  EXPECT_THAT(missing.error(), testing::HasSubstr("B>C"));
  conversions["B>C"] = [](std::span<const std::byte>) -> std::vector<std::byte> {
    throw std::runtime_error("no frame");
  };
  const auto thrown = convert(conversions, "A>B>C", bytes("x"));
  ASSERT_FALSE(thrown);
  EXPECT_THAT(thrown.error(), testing::HasSubstr("no frame"));
}

}  // namespace
}  // namespace geminga::client
