#include "discovery/gcnp/line_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "base/random.hpp"

namespace geminga::gcnp {
namespace {

using testing::ElementsAre;

/// Feeds the pieces and returns every line; a too long one with `!` before its beginning.
std::vector<std::string> lines(LineReader& reader, const std::vector<std::string>& pieces) {
  std::vector<std::string> found;
  for (const auto& piece : pieces) {
    reader.feed(piece);
    while (const auto line = reader.next()) found.push_back((line->is_too_long ? "!" : "") + std::string(line->text));
  }
  return found;
}

TEST(LineReader, EndsALineAtCrLfAndAtABareLf) {
  LineReader reader;
  EXPECT_THAT(lines(reader, {"a\r\nb\n\n\r\nc"}), ElementsAre("a", "b", "", ""));
  EXPECT_THAT(lines(reader, {"\n"}), ElementsAre("c"));
}

TEST(LineReader, KeepsACarriageReturnInsideALine) {
  LineReader reader;
  EXPECT_THAT(lines(reader, {"a\rb\r\r\n"}), ElementsAre("a\rb\r"));
}

TEST(LineReader, JoinsPiecesHoweverTheyAreCut) {
  LineReader reader;
  EXPECT_THAT(lines(reader, {"a", "b\r", "\nc", "", "d\n"}), ElementsAre("ab", "cd"));
}

TEST(LineReader, TakesALineOfTheLimitAndNotOneMore) {
  LineReader reader(100);
  EXPECT_THAT(lines(reader, {std::string(99, 'x') + "\n"}), ElementsAre(std::string(99, 'x')));
  EXPECT_THAT(lines(reader, {std::string(100, 'x') + "\r\n"}), ElementsAre(std::string(100, 'x')));
  EXPECT_THAT(lines(reader, {std::string(100, 'x'), "\r", "\n"}), ElementsAre(std::string(100, 'x')));
  EXPECT_THAT(lines(reader, {std::string(101, 'x') + "\nnext\n"}),
              ElementsAre('!' + std::string(LineReader::beginning_bytes, 'x'), "next"));
  EXPECT_THAT(lines(reader, {std::string(100, 'x'), "\r", "y\nnext\n"}),
              ElementsAre('!' + std::string(LineReader::beginning_bytes, 'x'), "next"));
}

TEST(LineReader, TellsATooLongLineOnceBeforeItEndsAndSkipsTheRest) {
  LineReader reader(100);
  EXPECT_THAT(lines(reader, {"7 pub create " + std::string(100, 'x')}),
              ElementsAre("!7 pub create " + std::string(LineReader::beginning_bytes - 13, 'x')));
  for (int i = 0; i < 1000; ++i) EXPECT_TRUE(lines(reader, {std::string(1000, 'y')}).empty());
  EXPECT_THAT(lines(reader, {"z\r\n8 sys ping\r\n"}), ElementsAre("8 sys ping"));
}

TEST(LineReader, GivesTheSameLinesHoweverTheStreamIsCutWhateverItsSeed) {
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    base::Random random(seed);
    std::string stream;
    for (int i = 0; i < 200; ++i) stream += "ab\r\n\n x"[random.below(8)];
    stream += '\n';
    LineReader whole(8);
    const auto expected = lines(whole, {stream});
    std::vector<std::string> pieces;
    for (std::size_t at = 0; at < stream.size();) {
      const std::size_t size = 1 + random.below(9);
      pieces.push_back(stream.substr(at, size));
      at += size;
    }
    LineReader cut(8);
    // A line over the limit is told with as many octets as have come: the test compares only that it is told.
    auto found = lines(cut, pieces);
    ASSERT_EQ(found.size(), expected.size()) << "seed " << seed;
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (expected[i].starts_with('!')) {
        ASSERT_TRUE(expected[i].starts_with(found[i])) << "seed " << seed;
      } else {
        ASSERT_EQ(found[i], expected[i]) << "seed " << seed;
      }
    }
  }
}

}  // namespace
}  // namespace geminga::gcnp
