#include "base/hash.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace geminga::base {
namespace {

TEST(Hash, IsThatOfTheSpecification) {
  // The reference implementation's own values for no octets.
  EXPECT_EQ(hash32(""), 0x02cc5d05U);
  EXPECT_EQ(hash64(""), 0x2d06800538d394c2U);
  EXPECT_EQ(hash128(""), std::pair(0x99aa06d3014798d8UL, 0x6001c324468d497fUL));
}

TEST(Hash, IsTheSameInPieces) {
  const std::string text(1000, 'x');
  HashOfPieces pieces;
  for (std::size_t at = 0; at < text.size(); at += 7) pieces.add(std::string_view(text).substr(at, 7));
  EXPECT_EQ(pieces.finish(), hash64(text));
  EXPECT_EQ(hash64(text), hash64(text, 0));
  EXPECT_NE(hash64(text), hash64(text, 1));
}

TEST(Hash, TakesNumbersAsTheirOctets) {
  const std::array<std::uint16_t, 2> numbers{0x6261, 0x6463};
  EXPECT_EQ(octets_of(std::span(numbers)).size(), 4U);
}

}  // namespace
}  // namespace geminga::base
