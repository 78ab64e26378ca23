#include "discovery/gcnp/statement.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/random.hpp"

namespace geminga::gcnp {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

Error error_of(std::string_view line) {
  const auto statement = parse(line);
  EXPECT_FALSE(statement) << line;
  return statement ? Error{} : statement.error().error;
}

TEST(Statement, IsIdCommandSubcommandAndParameters) {
  const auto statement = parse("42 pub create mode=oto flag text=\"a b\"");
  ASSERT_TRUE(statement);
  EXPECT_EQ(*statement, (Statement{42, "pub", "create", {{"mode", "oto"}, {"flag", std::nullopt}, {"text", "a b"}}}));
  EXPECT_EQ(statement->value("mode"), "oto");
  EXPECT_EQ(statement->value("flag"), std::nullopt);
  EXPECT_TRUE(statement->has("flag"));
  EXPECT_FALSE(statement->has("port"));
}

TEST(Statement, HasQuotedValuesWithTheFiveEscapes) {
  EXPECT_EQ(parse(R"(1 a b k="\"\\\n\r\t")")->value("k"), "\"\\\n\r\t");
  EXPECT_EQ(parse(R"(1 a b k=back\slash)")->value("k"), R"(back\slash)");
  EXPECT_EQ(parse("1 a b k=\"\"")->value("k"), "");
  EXPECT_EQ(parse("1 a b k=")->value("k"), "");
  EXPECT_EQ(parse("1 a b k=a=b")->value("k"), "a=b");
}

TEST(Statement, SaysAtWhichOctetItStopsMakingSense) {
  EXPECT_THAT(error_of("").text, StartsWith("octet 1:"));
  EXPECT_THAT(error_of("x").text, StartsWith("octet 1:"));
  EXPECT_THAT(error_of("5 pub").text, StartsWith("octet 6:"));
  EXPECT_THAT(error_of("5 p!b x").text, StartsWith("octet 4:"));
  EXPECT_THAT(error_of("5 a b k=\"x").text, StartsWith("octet 9:"));
  EXPECT_THAT(error_of("5 a b k=\"x\"y").text, StartsWith("octet 12:"));
  EXPECT_THAT(error_of("5 a b k=\"\\x\"").text, StartsWith("octet 10:"));
  EXPECT_THAT(error_of("5 a b k:x").text, StartsWith("octet 8:"));
}

TEST(Statement, RefusesControlCharactersAndBadUtf8WhereverTheyStand) {
  using namespace std::string_literals;
  for (const char c : {'\0', '\x01', '\t', '\r', '\x1b', '\x1f', '\x7f'}) {
    const std::string bare = "5 a b k=x"s + c + "y";
    EXPECT_THAT(error_of(bare).text, StartsWith("octet 10: a control character")) << int(c);
    const std::string quoted = "5 a b k=\"x"s + c + "y\"";
    EXPECT_THAT(error_of(quoted).text, StartsWith("octet 11: a control character")) << int(c);
  }
  for (const char* bad : {"\xff", "\xc0\xaf", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xe2\x82"}) {
    EXPECT_THAT(error_of("5 a b k=x"s + bad).text, StartsWith("octet 10: not UTF-8"));
  }
}

TEST(Statement, TellsItsIdEvenWhereTheRestCannotBeRead) {
  EXPECT_EQ(parse("77 a b \x01").error().id, 77U);
  EXPECT_EQ(parse("77").error().id, 77U);
  EXPECT_EQ(parse("77 a b " + std::string(max_line_bytes, 'x')).error().id, 77U);
  EXPECT_EQ(parse("4294967296 a b").error().id, 0U);
  EXPECT_EQ(parse("77\x01 a b").error().id, 0U);
}

TEST(Statement, HasAtMostTheLimitOfOctets) {
  const std::string head = "5 a b k=";
  for (const std::size_t size : {max_line_bytes - 1, max_line_bytes}) {
    EXPECT_TRUE(parse(head + std::string(size - head.size(), 'x'))) << size;
  }
  const Error error = error_of(head + std::string(max_line_bytes + 1 - head.size(), 'x'));
  EXPECT_EQ(error, line_too_long());
  EXPECT_EQ(error.code, ErrorCode::too_large);
}

TEST(Statement, HasAtMostTheLimitOfParameters) {
  std::string line = "5 a b";
  for (std::size_t i = 0; i < max_parameters - 1; ++i) line += " k" + std::to_string(i) + "=1";
  EXPECT_TRUE(parse(line));
  EXPECT_TRUE(parse(line + " last=1 "));
  EXPECT_EQ(error_of(line + " last=1 over=1").code, ErrorCode::too_large);
}

TEST(Statement, IsWrittenBareWhereItCanBe) {
  EXPECT_EQ(to_line({1, "a", "b", {{"k", "x"}, {"l", ""}, {"m", "x y"}, {"n", "\"\\\n\r\t"}, {"o", std::nullopt}}}),
            "1 a b k=x l=\"\" m=\"x y\" n=\"\\\"\\\\\\n\\r\\t\" o\r\n");
}

TEST(Statement, IsWrittenAsOneReadableLineWhateverItsValuesAre) {
  const std::string line = to_line({1, "a", "b", {{"k", std::string("x\0\x1b\xff y", 6)}}});
  EXPECT_EQ(line, "1 a b k=\"x??\xef\xbf\xbd y\"\r\n");
  EXPECT_TRUE(parse(std::string_view(line).substr(0, line.size() - 2)));
}

TEST(Statement, IsTheSameAfterWritingAndReadingWhateverItsSeed) {
  static constexpr std::string_view keys = "ABCXYZabcxyz0129_.-";
  static const std::vector<std::string> pieces{"a",  "=", " ",  "\"", "\\", "\n", "\r",
                                               "\t", "ü", "球", "😀", "/",  "<",  "'"};
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    base::Random random(seed);
    const auto word = [&] {
      std::string text;
      for (std::uint64_t i = 0, n = 1 + random.below(8); i < n; ++i) text += keys[random.below(keys.size())];
      return text;
    };
    Statement statement{static_cast<std::uint32_t>(random.next()), word(), word(), {}};
    for (std::uint64_t i = 0, n = random.below(6); i < n; ++i) {
      Parameter parameter{word(), std::nullopt};
      if (random.chance(0.8)) {
        parameter.value.emplace();
        for (std::uint64_t j = 0, m = random.below(12); j < m; ++j)
          *parameter.value += pieces[random.below(pieces.size())];
      }
      statement.parameters.push_back(std::move(parameter));
    }
    const std::string line = to_line(statement);
    ASSERT_TRUE(line.ends_with("\r\n")) << "seed " << seed;
    const auto again = parse(std::string_view(line).substr(0, line.size() - 2));
    ASSERT_TRUE(again) << "seed " << seed << ": " << line << again.error().error.text;
    ASSERT_EQ(*again, statement) << "seed " << seed << ": " << line;
  }
}

TEST(Statement, IsNeverReadFromNoiseInTwoWays) {
  // A statement read from any octets is written to a line that reads the same.
  static constexpr std::string_view alphabet = "019 ab=\"\\nt\t\xc3\xbc.-/:\x01";
  for (std::uint64_t seed = 1; seed <= 20000; ++seed) {
    base::Random random(seed);
    std::string line = random.chance(0.7) ? "7 a b " : "";
    for (std::uint64_t i = 0, n = random.below(24); i < n; ++i) line += alphabet[random.below(alphabet.size())];
    const auto statement = parse(line);
    if (!statement) continue;
    const std::string written = to_line(*statement);
    const auto again = parse(std::string_view(written).substr(0, written.size() - 2));
    ASSERT_TRUE(again) << "seed " << seed << ": " << line;
    ASSERT_EQ(*again, *statement) << "seed " << seed << ": " << line;
  }
}

TEST(ErrorLine, IsIdCodeAndTextInOneLine) {
  EXPECT_EQ(to_line(7, {ErrorCode::impossible, "no\r\nway"}), "7 422 no??way\r\n");
  const std::string line = to_line(7, {ErrorCode::malformed, std::string(max_error_text_bytes + 1, 'x')});
  EXPECT_THAT(line, HasSubstr("...\r\n"));
  EXPECT_LE(line.size(), max_error_text_bytes + 20);
}

}  // namespace
}  // namespace geminga::gcnp
