// The language of conditions, as in WHERE.md.
#include "discovery/matching/conditions/where.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "discovery/matching/conditions/similar_unit.hpp"

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

TEST(Where, ASetHoldsOneOfItsValues) {
  EXPECT_TRUE(accepts("camera in (rear, front)"));
  EXPECT_TRUE(accepts("camera IN('front')"));
  EXPECT_TRUE(accepts("rate in (10, 30.0)"));
  EXPECT_TRUE(accepts("camera in (re*, fr*)"));
  EXPECT_FALSE(accepts("camera in (rear, left)"));
  EXPECT_FALSE(accepts("nothing in (rear, left)"));
  EXPECT_TRUE(accepts("camera not in (rear, left)"));
  EXPECT_FALSE(accepts("camera not in (rear, front)"));
  EXPECT_FALSE(accepts("camera not in (fr*)"));
  EXPECT_FALSE(accepts("nothing not in (rear)")) << "as !=: what is absent is not compared";
  EXPECT_TRUE(accepts("not camera in (rear, left) and rate in (30) or has nothing"));
}

TEST(Where, APatternStandsForAnyOctetsInThePlaceOfEachStar) {
  for (const char* pattern : {"*", "f*", "*t", "f*t", "fr*nt", "front*", "*front", "*r*n*", "f**t", "f*o*t"}) {
    EXPECT_TRUE(accepts("camera = " + std::string(pattern))) << pattern;
    EXPECT_FALSE(accepts("camera != " + std::string(pattern))) << pattern;
    EXPECT_TRUE(accepts("camera like '" + std::string(pattern) + "'")) << pattern;
  }
  for (const char* pattern : {"r*", "*x", "fro*ont", "f*x*t", "*n*r*", "front*t", "F*"}) {
    EXPECT_FALSE(accepts("camera = " + std::string(pattern))) << pattern;
    EXPECT_TRUE(accepts("camera != " + std::string(pattern))) << pattern;
  }
  EXPECT_TRUE(accepts("empty = *"));
  EXPECT_FALSE(accepts("nothing = *"));
  EXPECT_FALSE(accepts("camera = 'fr*'")) << "a quoted star is a star";
  EXPECT_TRUE(accepts("camera like front"));
  EXPECT_TRUE(accepts("name-with.dots_1 not in (f*, g*)"));
}

TEST(Where, ComparesQuantitiesInWhateverUnitTheyAreStated) {
  auto entry = camera();
  const auto holds = [&entry](const std::string& stated, const std::string& expression) {
    entry.publication.attributes["range"] = stated;
    const auto where = Where::parse(expression);
    EXPECT_TRUE(where) << expression << ": " << where.error().text;
    return where && where->accepts(entry);
  };
  EXPECT_TRUE(holds("350 cm", "range >= 3 m"));
  EXPECT_TRUE(holds("350cm", "range >= 3.5 m and range <= 3.5 m and range = 3.5 m"));
  EXPECT_TRUE(holds("7 cm", "range = 0.07 m")) << "7 * 0.01 is no 0.07 for a computer";
  EXPECT_FALSE(holds("250 cm", "range >= 3 m"));
  EXPECT_TRUE(holds("350 unit:CentiM", "range >= 3 unit:M and range < 4 http://qudt.org/vocab/unit/M"));
  EXPECT_TRUE(holds("3 m/s", "range = 10.8 unit:KiloM-PER-HR"));
  EXPECT_TRUE(holds("10 km/h", "range < 3 m/s"));
  EXPECT_TRUE(holds("25 \u00b0C", "range > 77 degF or range = 77 \u00b0F"));
  EXPECT_TRUE(holds("1 m", "range in (2 m, 100 cm)"));
  for (const char* odd : {"3", "350", "3 kg", "far", "", "3 foo", "m", "3 m extra"}) {
    EXPECT_FALSE(holds(odd, "range >= 0 m or range <= 0 m or range = 0 m")) << odd;
    EXPECT_TRUE(holds(odd, "range != 3 m")) << odd;
  }
  EXPECT_FALSE(holds("3 m", "range >= 1")) << "a number without a unit is no length";
  entry.publication.attributes["range"] = "3";
  EXPECT_EQ(Where::parse("range >= 1 m")->misses(entry), "range is 3, which is no number with a unit");
  entry.publication.attributes["range"] = "3 kg";
  EXPECT_EQ(Where::parse("range >= 1 m")->misses(entry),
            "range is '3 kg', which is in a unit of another kind than 1 m");
  EXPECT_EQ(Where::parse("range >= 1")->misses(entry),
            "range is '3 kg', which has a unit: compare it with a number with a unit of its kind");
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
  const std::string known = ": " + std::string(known_units);
  const std::vector<std::pair<std::string, std::string>> cases{
      {" ", "expected a key, 'has', 'not' or '(' at octet 2"},
      {"rate", "expected =, !=, <, <=, >, >=, in, not in or like at octet 5"},
      {"rate = ", "expected a number, a word or a quoted text at octet 8"},
      {"rate = and", "expected a number, a word or a quoted text at octet 8"},
      {"and = 1", "expected a key, 'has', 'not' or '(' at octet 1"},
      {"has", "expected a key after 'has' at octet 4"},
      {"has or", "expected a key after 'has' at octet 5"},
      {"rate = 1 camera = 2", "expected 'and', 'or', the end or a unit that is known at octet 10" + known},
      {"range < 3 parsecs", "expected 'and', 'or', the end or a unit that is known at octet 11" + known},
      {"(rate = 1", "expected ')' at octet 10"},
      {"rate = 1)", "expected 'and', 'or' or the end at octet 9"},
      {"a/b = 1", "a key has only letters, digits, '_', '.' and '-' at octet 2"},
      {"rate = 'x", "this text has no closing quote at octet 8"},
      {"rate = 'x\\", "this text has no closing quote at octet 8"},
      {"rate = 'x\\n'", "only \\\\, \\\" and \\' are escapes at octet 11"},
      {"rate = '\xff'", "this text is no UTF-8 at octet 8"},
      {"rate ~ 1", "expected =, !=, <, <=, >, >=, in, not in or like at octet 6"},
      {"rate = 1 or", "expected a key, 'has', 'not' or '(' at octet 12"},
      {"not", "expected a key, 'has', 'not' or '(' at octet 4"},
      {"!= 3", "expected a key, 'has', 'not' or '(' at octet 1"},
      {"rate in 1", "expected '(' after 'in' at octet 9"},
      {"rate in (1", "expected ',' or ')' at octet 11"},
      {"rate in ()", "expected a number, a word or a quoted text at octet 10"},
      {"rate in (1,)", "expected a number, a word or a quoted text at octet 12"},
      {"rate not 1", "expected 'in' after 'not' at octet 10"},
      {"rate like", "expected a number, a word or a quoted text at octet 10"},
      {"rate < r*", "a pattern is neither less nor greater: quote it to compare it as a text at octet 8"},
      {"rate < 3m", "write a blank between number and unit, or quote it to compare it as a text at octet 8"},
      {"rate < 3 metres", "expected 'and', 'or', the end or a unit that is known at octet 10: did you mean m?"},
      {"rate < 3 Kilograms", "expected 'and', 'or', the end or a unit that is known at octet 10: did you mean kg?"},
      {"rate < 3 KM", "expected 'and', 'or', the end or a unit that is known at octet 10: did you mean km?"},
      {"rate < 1e308 km", "this number is out of range at octet 8"},
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
  EXPECT_TRUE(accepts("not not has rate and not (not has rate) and not not not has nothing"));
  EXPECT_FALSE(accepts("not not has nothing or not not not has rate"));
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
  EXPECT_TRUE(accepts("rate > 1.2.3"));
}

TEST(Where, ANumberThatIsOutOfRangeIsNoTextBehindTheUsersBack) {
  for (const char* number : {"1e999", "-1e999", "1e400"}) {
    const auto error = check_where("rate > " + std::string(number));
    ASSERT_TRUE(error) << number;
    EXPECT_EQ(error->text, "where: this number is out of range: quote it to compare it as a text at octet 8");
  }
  EXPECT_TRUE(accepts("rate > '1e999'"));
}

TEST(Where, AnOddAttributeIsNoNumber) {
  for (const char* odd :
       {"NaN", "inf", "1e999", "0x10", "", " 5", "5 ", "5.", ".5", "1e", "--5", "+-5", "5,0", "\xc2\xb5"}) {
    auto entry = camera();
    entry.publication.attributes["rate"] = odd;
    for (const char* expression : {"rate = 5", "rate < 5", "rate <= 5", "rate > 5", "rate >= 5"}) {
      EXPECT_FALSE(Where::parse(expression)->accepts(entry)) << odd << ' ' << expression;
    }
    EXPECT_TRUE(Where::parse("rate != 5")->accepts(entry)) << odd;
  }
  auto entry = camera();
  entry.publication.attributes["rate"] = "007";
  EXPECT_TRUE(Where::parse("rate = 7")->accepts(entry)) << "leading zeros are digits";
}

TEST(Where, NamesAnAttributeThatAFieldWouldHideByItsPrefix) {
  EXPECT_TRUE(accepts("port = 5000 and attr.port = 'shadowed by the field'"));
  EXPECT_TRUE(accepts("attr.rate >= 30 and has attr.camera"));
  EXPECT_FALSE(accepts("has attr.priority"));
  EXPECT_FALSE(accepts("has attr."));
}

TEST(Where, SaysWhichKeyOrValueMayHaveBeenMeant) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"rat > 3", "rat is absent (did you mean rate?)"},
      {"Rate > 3", "Rate is absent (did you mean rate?)"},
      {"attr.rat > 3", "attr.rat is absent (did you mean rate?)"},
      {"has camra", "camra is absent (did you mean camera?)"},
      {"prority = 2", "prority is absent (did you mean priority?)"},
      {"attr.prority = 2", "attr.prority is absent"},
      {"speed > 3", "speed is absent"},
      {"camera = Front", "camera is front (did you mean it?)"},
      {"camera = fron", "camera is front (did you mean it?)"},
      {"camera = rear", "camera is front"},
      {"camera in (Front, rear)", "camera is front (did you mean it?)"},
      {"camera != front", "camera is front"},
  };
  for (const auto& [expression, words] : cases)
    EXPECT_EQ(Where::parse(expression)->misses(camera()), words) << expression;
  auto robot = camera();
  robot.participant_name = "robot1";
  EXPECT_EQ(Where::parse("participant_name = robot2")->misses(robot), "participant_name is robot1")
      << "numbers are no slips";
  EXPECT_EQ(Where::parse("participant_name = Robot1")->misses(robot), "participant_name is robot1 (did you mean it?)");
}

TEST(Where, SaysWhatKeepsItFromHolding) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"rate > 50", "rate is 30"},
      {"speed > 50", "speed is absent"},
      {"rate > 50 and camera = front", "rate is 30"},
      {"rate > 50 or speed > 1 or camera = rear", "rate is 30, speed is absent, camera is front"},
      {"not has rate", "rate is 30"},
      {"not (rate = 30 or speed = 2)", "rate is 30"},
      {"not (rate = 30 and camera = front)", "rate is 30, camera is front"},
      {"rate > 50 or rate < 10", "rate is 30"},
      {"camera > 7", "camera is front, which is no number"},
      {"quote = x", "quote is 'it's'"},
      {"has id", "id is absent"},
      {"empty = x", "empty is ''"},
      {"attr.port = 1", "attr.port is 'shadowed by the field', which is no number"},
      {"a=1 or b=1 or c=1 or d=1 or e=1 or f=1 or g=1 or h=1 or i=1",
       "a is absent, b is absent, c is absent, d is absent, e is absent, f is absent, g is absent, h is absent, ..."},
      {"rate = 30", ""},
      {"", ""},
  };
  for (const auto& [expression, words] : cases)
    EXPECT_EQ(Where::parse(expression)->misses(camera()), words) << expression;
}

TEST(Where, ASharedPageOfExamplesHolds) {
  std::ifstream page(GEMINGA_SOURCE_DIR "/src/discovery/matching/conditions/WHERE.md");
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
  EXPECT_EQ(examples, 12);
}

}  // namespace
}  // namespace geminga::matching
