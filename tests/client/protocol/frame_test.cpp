// Frames against the vectors of all languages, and at their limits.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "client/protocol/frame_reader.hpp"
#include "client/protocol/life.hpp"

namespace geminga::client {
namespace {

std::vector<std::byte> from_hex(const std::string& hex) {
  std::vector<std::byte> bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2) {
    bytes.push_back(static_cast<std::byte>(std::stoi(hex.substr(i, 2), nullptr, 16)));
  }
  return bytes;
}

struct Vector {
  std::string kind;
  Life life = no_life;
  std::uint64_t sequence = 0;
  std::vector<std::byte> payload;
  std::vector<std::byte> frame;
};

std::vector<Vector> vectors() {
  std::ifstream file(std::string(GEMINGA_SOURCE_DIR) + "/tests/client/vectors/frames.tsv");
  std::vector<Vector> all;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line.starts_with('#')) continue;
    std::vector<std::string> fields;
    std::istringstream row(line);
    for (std::string field; std::getline(row, field, '\t');) fields.push_back(field);
    fields.resize(5);
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
  return word == "message" ? FrameKind::message : word == "hello" ? FrameKind::hello : FrameKind::end;
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

TEST(Frame, CarriesALifeAsPayload) {
  const auto payload = life_payload(Life{0x0123456789abcdef});
  EXPECT_EQ(payload_life(payload), Life{0x0123456789abcdef});
  EXPECT_EQ(payload_life(std::span(payload).first(7)), std::nullopt);
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
