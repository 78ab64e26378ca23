// Frames against the vectors of all languages, and at their limits.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "client/protocol/frame_reader.hpp"
#include "client/protocol/life.hpp"
#include "client/protocol/vector_file.hpp"

namespace geminga::client {
namespace {

struct Vector {
  std::string kind;
  Life life = no_life;
  std::uint64_t sequence = 0;
  std::vector<std::byte> payload;
  std::vector<std::byte> frame;
};

std::vector<Vector> vectors() {
  std::vector<Vector> all;
  for (const auto& fields : vector_rows("frames.tsv", 5)) {
    Vector one{fields[0], no_life, 0, from_hex(fields[3]), from_hex(fields[4])};
    if (one.kind != "refused") {
      one.life = read_life(fields[1]).value_or(no_life);
      one.sequence = std::stoull(fields[2]);
    }
    all.push_back(std::move(one));
  }
  return all;
}

FrameKind kind_of(const std::string& word) {
  if (word == "message") return FrameKind::message;
  if (word == "hello") return FrameKind::hello;
  if (word == "end") return FrameKind::end;
  return word == "floor" ? FrameKind::floor : FrameKind::full;
}

/// Feeds in pieces of this size and gives the payloads' sizes.
std::vector<std::size_t> fed(FrameReader& reader, const std::vector<std::byte>& stream, std::size_t piece) {
  std::vector<std::size_t> sizes;
  for (std::size_t at = 0; at < stream.size();) {
    const auto room = reader.room();
    const std::size_t size = std::min({piece, room.size(), stream.size() - at});
    std::copy_n(stream.begin() + static_cast<std::ptrdiff_t>(at), size, room.begin());
    reader.fed(size);
    at += size;
    while (const auto frame = reader.next()) sizes.push_back(frame->payload.size());
  }
  return sizes;
}

std::vector<std::byte> message(std::size_t size) {
  const std::vector<std::byte> payload(size, std::byte{7});
  return frame_bytes({FrameKind::message, Life{1}, 1, payload});
}

TEST(Frame, IsReadAndWrittenAsEveryLanguageDoes) {
  ASSERT_GE(vectors().size(), 10U);
  for (const Vector& one : vectors()) {
    const auto frame = read_frame(one.frame);
    if (one.kind == "refused") {
      EXPECT_FALSE(frame) << one.frame.size();
      continue;
    }
    ASSERT_TRUE(frame) << one.kind;
    EXPECT_EQ(frame->kind, kind_of(one.kind));
    EXPECT_EQ(frame->life, one.life);
    EXPECT_EQ(frame->sequence, one.sequence);
    EXPECT_TRUE(std::ranges::equal(frame->payload, one.payload));
    EXPECT_EQ(frame_bytes({kind_of(one.kind), one.life, one.sequence, one.payload}), one.frame);
  }
}

TEST(Frame, OfADatagramHasALargestPayload) {
  EXPECT_TRUE(read_frame(message(max_datagram_payload - 1)));
  EXPECT_TRUE(read_frame(message(max_datagram_payload)));
  EXPECT_FALSE(read_frame(message(max_datagram_payload + 1)));
}

TEST(FrameReader, CutsAStreamHoweverItArrives) {
  std::vector<std::byte> stream;
  const std::vector<std::size_t> sizes{0, 1, 5, 70'000, 0, 24};
  for (const std::size_t size : sizes) {
    const auto one = message(size);
    stream.insert(stream.end(), one.begin(), one.end());
  }
  for (const std::size_t piece : {1UL, 7UL, 24UL, 1000UL, 1'000'000UL}) {
    FrameReader reader;
    EXPECT_EQ(fed(reader, stream, piece), sizes) << piece;
    EXPECT_FALSE(reader.is_broken());
  }
}

TEST(FrameReader, BreaksAtWhatIsTooLarge) {
  for (const std::size_t size : {99UL, 100UL, 101UL}) {
    FrameReader reader(100);
    const auto sizes = fed(reader, message(size), 1000);
    EXPECT_EQ(sizes.size(), size <= 100 ? 1U : 0U) << size;
    EXPECT_EQ(reader.is_broken(), size > 100) << size;
  }
}

TEST(FrameReader, BreaksAtTheHeaderOfWhatIsNoFrame) {
  auto stream = message(3);
  const auto next = message(3);
  stream.insert(stream.end(), next.begin(), next.end());
  stream[next.size()] = std::byte{'X'};
  FrameReader reader;
  EXPECT_EQ(fed(reader, stream, 1000).size(), 1U) << "what came before it is given";
  EXPECT_TRUE(reader.is_broken());
}

TEST(Frame, CarriesAGreetingAsPayload) {
  const Greeting greeting{Life{0x0123456789abcdef}, 7, 8};
  const auto payload = greeting_payload(greeting);
  EXPECT_EQ(read_greeting(payload), greeting);
  for (const std::size_t size : {greeting_bytes - 1, greeting_bytes + 1}) {
    EXPECT_EQ(read_greeting(std::vector<std::byte>(size)), std::nullopt) << size;
  }
}

TEST(Life, IsSixteenHexadecimalDigitsThatAreNotNull) {
  EXPECT_EQ(read_life("0123456789abcdef"), Life{0x0123456789abcdef});
  EXPECT_EQ(to_string(Life{0xab}), "00000000000000ab");
  for (const char* text : {"", "0123456789abcde", "0123456789abcdef0", "0123456789ABCDEF", "0000000000000000",
                           "0x23456789abcdef", "0123456789abcdeg"}) {
    EXPECT_EQ(read_life(text), std::nullopt) << text;
  }
  EXPECT_NE(new_life(), new_life());
}

}  // namespace
}  // namespace geminga::client
