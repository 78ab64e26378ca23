// The filter language of WHERE.md.
#include "matching/where.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace geminga::matching {
namespace {

registry::PublicationEntry camera() {
  registry::PublicationEntry entry;
  entry.key = {ParticipantId{0x1a2b3c4d}, PeerId{3}, 42};
  entry.peer_name = "vision";
  entry.participant_name = "robot2";
  entry.publication.mode = ChannelMode::one_to_many_stream;
  entry.publication.identity = TextIdentity{"ball"};
  entry.publication.port = 5000;
  entry.publication.priority = 2;
  entry.publication.attributes = {{"rate", "30"},
                                  {"camera", "front"},
                                  {"empty", ""},
                                  {"big", "9007199254740993"},
                                  {"port", "shadowed by the field"},
                                  {"quote", "it's"},
                                  {"name-with.dots_1", "x"}};
  return entry;
}

bool accepts(const std::string& expression) {
  const auto where = Where::parse(expression);
  EXPECT_TRUE(where) << expression << ": " << where.error().text;
  return where && where->accepts(camera());
}

TEST(Where, HoldsWhereItsMeaningSaysSo) {
  for (const char* expression : {"",
                                 "rate = 30",
                                 "rate==30",
                                 "rate=30.0",
                                 "rate = 3e1",
                                 "rate = +30",
                                 "rate != 31",
                                 "rate < 31",
                                 "rate <= 30",
                                 "rate > -1",
                                 "rate >= 30",
                                 "camera = front",
                                 "camera='front'",
                                 "camera = \"front\"",
                                 "camera != rear",
                                 "camera < g",
                                 "camera >= front",
                                 "camera != 7",
                                 "has rate",
                                 "has empty",
                                 "empty = ''",
                                 "not has nothing",
                                 "not nothing = 1",
                                 "!(nothing = 1)",
                                 "! has nothing",
                                 "rate = 1 or camera = front",
                                 "rate = 1 || camera = front",
                                 "rate = 30 && camera = front",
                                 "NOT has nothing AND Has rate",
                                 "port = 5000",
                                 "priority >= 2",
                                 "protocol = udp",
                                 "mode = otm/stream",
                                 "text = ball",
                                 "participant = 1a2b3c4d",
                                 "participant_name = robot2",
                                 "peer = 3",
                                 "name = vision",
                                 "quote = 'it\\'s'",
                                 "quote = \"it's\"",
                                 "name-with.dots_1 = x",
                                 "((((rate=30))))",
                                 "\trate\r\n=  30 "}) {
    EXPECT_TRUE(accepts(expression)) << expression;
  }
}

TEST(Where, DoesNotHoldWhereItsMeaningSaysSo) {
  for (const char* expression : {"rate = 31",
                                 "rate != 30",
                                 "rate != 30.0",
                                 "rate < 30",
                                 "rate > 30",
                                 "rate = '30.0'",
                                 "camera = Front",
                                 "camera = 7",
                                 "camera < 7",
                                 "camera > 7",
                                 "has nothing",
                                 "nothing = 1",
                                 "nothing != 1",
                                 "nothing < 1",
                                 "nothing >= 1",
                                 "not has rate",
                                 "rate = 30 and camera = rear",
                                 "has id",
                                 "has concept",
                                 "id = 5",
                                 "has representation",
                                 "has address",
                                 "address != x",
                                 "empty = 0",
                                 "big = 9007199254740992"}) {
    EXPECT_FALSE(accepts(expression)) << expression;
  }
}

TEST(Where, NotBindsTighterThanAndAndThatThanOr) {
  EXPECT_TRUE(accepts("has rate or has nothing and has nothing"));
  EXPECT_FALSE(accepts("(has rate or has nothing) and has nothing"));
  EXPECT_FALSE(accepts("not has rate and has nothing"));
  EXPECT_TRUE(accepts("not (has rate and has nothing)"));
  EXPECT_TRUE(accepts("not has rate or has rate"));
}

TEST(Where, ReadsTheFieldsOfEachKindOfIdentity) {
  auto entry = camera();
  const auto holds = [&entry](const char* expression) { return Where::parse(expression)->accepts(entry); };
  entry.publication.identity = NumericIdentity{5};
  EXPECT_TRUE(holds("id = 5 and not has text and not has concept"));
  entry.publication.identity = SemanticIdentity{"http://example.org/a", ""};
  EXPECT_TRUE(holds("concept = http://example.org/a and not has representation and not has id"));
  entry.publication.identity = SemanticIdentity{"http://example.org/a#b", "http://example.org/r"};
  EXPECT_TRUE(holds("concept = 'http://example.org/a#b' and representation = http://example.org/r"));
  entry.publication.address = "192.0.2.7";
  EXPECT_TRUE(holds("address = 192.0.2.7"));
}

TEST(Where, SaysWhatIsWrongAtWhichOctet) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {" ", "expected a key, 'has', 'not' or '(' at octet 2"},
      {"rate", "expected =, !=, <, <=, > or >= at octet 5"},
      {"rate = ", "expected a number, a word or a quoted text at octet 8"},
      {"rate = and", "expected a number, a word or a quoted text at octet 8"},
      {"and = 1", "expected a key, 'has', 'not' or '(' at octet 1"},
      {"has", "expected a key after 'has' at octet 4"},
      {"has or", "expected a key after 'has' at octet 5"},
      {"rate = 1 camera = 2", "expected 'and', 'or' or the end at octet 10"},
      {"(rate = 1", "expected ')' at octet 10"},
      {"rate = 1)", "expected 'and', 'or' or the end at octet 9"},
      {"a/b = 1", "a key has only letters, digits, '_', '.' and '-' at octet 2"},
      {"rate = 'x", "this text has no closing quote at octet 8"},
      {"rate = 'x\\", "this text has no closing quote at octet 8"},
      {"rate = 'x\\n'", "only \\\\, \\\" and \\' are escapes at octet 11"},
      {"rate = '\xff'", "this text is no UTF-8 at octet 8"},
      {"rate ~ 1", "expected =, !=, <, <=, > or >= at octet 6"},
      {"rate = 1 or", "expected a key, 'has', 'not' or '(' at octet 12"},
      {"not", "expected a key, 'has', 'not' or '(' at octet 4"},
      {"!= 3", "expected a key, 'has', 'not' or '(' at octet 1"},
      {std::string("rate = \0", 8), "expected a number, a word or a quoted text at octet 8"},
  };
  for (const auto& [expression, text] : cases) {
    const auto error = check_where(expression);
    ASSERT_TRUE(error) << expression;
    EXPECT_EQ(error->code, ErrorCode::impossible) << expression;
    EXPECT_EQ(error->text, "where: " + text) << expression;
  }
  EXPECT_FALSE(check_where("rate = 1"));
  EXPECT_FALSE(check_where(""));
}

std::string nested(std::size_t levels, const std::string& open, const std::string& close) {
  std::string expression;
  for (std::size_t level = 0; level < levels; ++level) expression += open;
  expression += "has rate";
  for (std::size_t level = 0; level < levels; ++level) expression += close;
  return expression;
}

TEST(Where, IsReadUpToItsDepthAndNotDeeper) {
  for (const auto& [open, close] : {std::pair("(", ")"), std::pair("not ", ""), std::pair("!", "")}) {
    EXPECT_FALSE(check_where(nested(max_where_depth - 1, open, close))) << open;
    EXPECT_FALSE(check_where(nested(max_where_depth, open, close))) << open;
    const auto error = check_where(nested(max_where_depth + 1, open, close));
    ASSERT_TRUE(error) << open;
    EXPECT_EQ(error->code, ErrorCode::impossible);
  }
  EXPECT_TRUE(accepts(nested(max_where_depth, "not ", "")));
  EXPECT_FALSE(accepts(nested(max_where_depth - 1, "not ", "")));
}

TEST(Where, IsReadUpToItsLengthAndNotLonger) {
  const auto padded = [](std::size_t octets) { return "has rate" + std::string(octets - 8, ' '); };
  EXPECT_FALSE(check_where(padded(max_where_octets - 1)));
  EXPECT_FALSE(check_where(padded(max_where_octets)));
  const auto error = check_where(padded(max_where_octets + 1));
  ASSERT_TRUE(error);
  EXPECT_EQ(error->code, ErrorCode::too_large);
}

TEST(Where, NumbersAreDecimalAndFinite) {
  for (const char* number : {"0", "-1", "+1", "1.5", "1e3", "1E-3", "-0.0"}) {
    EXPECT_TRUE(Where::parse("rate < " + std::string(number))) << number;
  }
  // None of these is a number: they are words, and the rate of 30 is compared as a text.
  EXPECT_TRUE(accepts("rate < inf"));
  EXPECT_TRUE(accepts("rate < nan"));
  EXPECT_TRUE(accepts("rate > 0x10"));
  EXPECT_TRUE(accepts("rate > 1e999"));
  EXPECT_TRUE(accepts("rate > 1.2.3"));
}

TEST(Where, ASharedPageOfExamplesHolds) {
  std::ifstream page(GEMINGA_SOURCE_DIR "/src/matching/WHERE.md");
  std::string line;
  int examples = 0;
  bool in_examples = false;
  while (std::getline(page, line)) {
    in_examples = in_examples || line == "## Examples";
    if (!in_examples || !line.starts_with("| `")) continue;
    const auto end = line.find("` | ");
    const std::string expression = line.substr(3, end - 3);
    EXPECT_EQ(accepts(expression), line.substr(end + 4).starts_with("holds")) << line;
    ++examples;
  }
  EXPECT_EQ(examples, 8);
}

}  // namespace
}  // namespace geminga::matching
