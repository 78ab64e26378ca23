// Frames between a daemon and a bridge that keeps words, octet by octet.
#include "discovery/keeping/frame.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "env/env.hpp"

namespace geminga::keeping {
namespace {

constexpr ParticipantId someone{0x1a2b3c4d};
static_assert(max_frame_bytes == env::max_datagram_bytes, "a frame reaches the daemon as its datagrams do");

std::vector<std::byte> octets(std::initializer_list<int> values) {
  std::vector<std::byte> made;
  for (const int value : values) made.push_back(static_cast<std::byte>(value));
  return made;
}

TEST(Frame, IsWrittenAsItsSpecificationShows) {
  const auto envelope = octets({0x47, 0x11});
  EXPECT_EQ(write(Hello{0x0102030405060708}), octets({0x4b, 0x11, 1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_EQ(write(Keep{someone, 1, 2, envelope}), octets({0x4b, 0x12, 0x1a, 0x2b, 0x3c, 0x4d, 1, 2, 0x47, 0x11}));
  EXPECT_EQ(write(Drop{someone}), octets({0x4b, 0x13, 0x1a, 0x2b, 0x3c, 0x4d}));
  EXPECT_EQ(write(Kept{envelope}), octets({0x4b, 0x14, 0x47, 0x11}));
}

TEST(Frame, IsReadAsItWasWritten) {
  EXPECT_EQ(std::get<Hello>(*read(write(Hello{7}))).life, 7U);
  EXPECT_EQ(std::get<Drop>(*read(write(Drop{someone}))).participant, someone);
  const std::vector<std::byte> largest(max_kept_bytes);
  const auto written = write(Keep{someone, max_kept_words - 1, max_kept_words, largest});
  EXPECT_EQ(written.size(), max_frame_bytes);
  const auto keep = std::get<Keep>(*read(written));
  EXPECT_EQ(keep.index, max_kept_words - 1);
  EXPECT_EQ(keep.envelope.size(), max_kept_bytes);
}

TEST(Frame, IsNothingWhereItIsNotWholeOrOverALimit) {
  for (const auto& wrong :
       {octets({}), octets({0x4b}), octets({0x47, 0x11}), octets({0x4b, 0x21, 1, 2, 3, 4, 5, 6, 7, 8}),
        octets({0x4b, 0x11, 1, 2, 3, 4, 5, 6, 7}), octets({0x4b, 0x15, 1}), octets({0x4b, 0x14}),
        octets({0x4b, 0x13, 0, 0, 0, 0}), octets({0x4b, 0x13, 1, 2, 3}), octets({0x4b, 0x12, 1, 2, 3, 4, 0, 1}),
        octets({0x4b, 0x12, 1, 2, 3, 4, 1, 1, 0x47}), octets({0x4b, 0x12, 0, 0, 0, 0, 0, 1, 0x47}),
        octets({0x4b, 0x12, 1, 2, 3, 4, 0, max_kept_words + 1, 0x47})}) {
    EXPECT_FALSE(read(wrong)) << testing::PrintToString(wrong.size());
  }
  auto kept = write(Kept{std::vector<std::byte>(max_kept_bytes)});
  EXPECT_TRUE(read(kept));
  kept.push_back({});
  EXPECT_FALSE(read(kept));
}

}  // namespace
}  // namespace geminga::keeping
