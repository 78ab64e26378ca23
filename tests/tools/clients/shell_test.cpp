// The parts that the programs share: printable texts, tables, words, JSON.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/json/array.hpp>
#include <sstream>

#include "shell/changes.hpp"
#include "shell/describe.hpp"
#include "shell/json.hpp"
#include "shell/report.hpp"
#include "shell/table.hpp"
#include "shell/terminal.hpp"
#include "shell/timestamp.hpp"

namespace geminga::shell {
namespace {

TEST(Printable, LeavesHarmlessTextsAsTheyAre) {
  for (const char* text : {"", "soccer:BallInfo", "Ölstand 球 😀", "a\u00a0b"}) EXPECT_EQ(printable(text), text);
}

TEST(Printable, ReplacesWhatATerminalCouldObey) {
  EXPECT_EQ(printable("a\x1b[31mb\r\nc\x7f"), "a\ufffd[31mb\ufffd\ufffdc\ufffd");
  EXPECT_EQ(printable(std::string("\0", 1)), "\ufffd");
  EXPECT_EQ(printable("\u009b31m \u202e \u2028 \u200f"), "\ufffd31m \ufffd \ufffd \ufffd");
  EXPECT_EQ(printable("x\xff\xc3"), "x\ufffd\ufffd");
}

TEST(Wrapped, BreaksWhereAReaderWould) {
  const std::vector<std::pair<std::string, std::vector<std::string>>> cases{
      {"", {""}},
      {"0123456789", {"0123456789"}},
      {"0123456789a", {"0123456789", "a"}},
      {"0123456 89abc", {"0123456", "89abc"}},
      {"0123456789 abc", {"0123456789", "abc"}},
      {"10.0.0.2,10.0.0.3", {"10.0.0.2,", "10.0.0.3"}},
      {"a b0123456789", {"a", "b012345678", "9"}},
      {"a b/c=d@e#fgh", {"a", "b/c=d@e#", "fgh"}},
      {"a b/cdefghijk", {"a", "b/cdefghij", "k"}},
      {"a b/c=d@ef#ghij", {"a", "b/c=d@ef#", "ghij"}},
      {"ab, cd;ef|ghi", {"ab, cd;ef|", "ghi"}},
      {"a,b otm/stream", {"a,b", "otm/stream"}},
      {"ÖÖÖÖÖÖÖÖÖÖÖ", {"ÖÖÖÖÖÖÖÖÖÖ", "Ö"}},
  };
  for (const auto& [text, lines] : cases) EXPECT_EQ(wrapped(text, 10), lines) << text;
  EXPECT_EQ(wrapped("ab", 1), (std::vector<std::string>{"a", "b"}));
}

TEST(Table, AlignsItsColumns) {
  Table table({{"NAME"}, {"COUNT", true}, {"EMPTY"}, {"LAST"}});
  table.add({"ü", "7", "", "x"});
  table.add({"longer", "1000000", "", ""});
  std::ostringstream out;
  table.print(out, {});
  EXPECT_EQ(out.str(),
            "NAME      COUNT  LAST\n"
            "ü             7  x\n"
            "longer  1000000  -\n");
}

TEST(Table, HasNoSpaceAtTheEndOfALine) {
  Table table({{"A"}, {""}});
  table.add({"a", " "});
  table.add({"b", "(this host)"});
  std::ostringstream out;
  table.print(out, {});
  EXPECT_EQ(out.str(), "A\na\nb  (this host)\n");
}

TEST(Table, PrintsItsHeadingOnlyAboveRows) {
  Table table({{"A"}});
  std::ostringstream out;
  table.print(out, {}, "heading\n");
  EXPECT_EQ(out.str(), "");
  table.add({"a"});
  table.print(out, {}, "heading\n");
  EXPECT_EQ(out.str(), "heading\nA\na\n");
}

std::string shown(const Table& table, std::size_t columns) {
  std::ostringstream out;
  table.print(out, {.is_terminal = true, .has_colour = false, .columns = columns});
  return out.str();
}

TEST(Table, WrapsLongCellsAndCutsNothing) {
  Table table({{"A"}, {"B", false, 4}, {"C", false, 4}});
  table.add({"fixed", "bbbbbbbbbbbb", "cccccc"});
  EXPECT_EQ(shown(table, 27), "A      B             C\nfixed  bbbbbbbbbbbb  cccccc\n");
  EXPECT_EQ(shown(table, 26), "A  fixed\nB  bbbbbbbbbbbb\nC  cccccc\n");
  Table words({{"A"}, {"B", false, 4}, {"C", false, 4}});
  words.add({"fixed", "bbbb bbbb bbb", "cccc cc"});
  EXPECT_EQ(shown(words, 1), "A\nf\ni\nx\ne\nd\nB\nb\nb\nb\nb\nb\nb\nb\nb\nb\nb\nb\nC\nc\nc\nc\nc\nc\nc\n")
      << "even there";
  EXPECT_EQ(shown(words, 17), "A      B     C\nfixed  bbbb  cccc\n       bbbb  cc\n       bbb\n");
}

TEST(Table, LeavesOutTheLeastImportantColumnFirstAndSaysSo) {
  Table table({{"NAME", false, 4}, {"MODE", false, 0, 1}, {"AGE", true, 0, 2}});
  table.add({"some body", "otm/stream", "0.4 s"});
  EXPECT_EQ(shown(table, 28), "NAME       MODE          AGE\nsome body  otm/stream  0.4 s\n");
  EXPECT_EQ(shown(table, 23), "NAME  MODE          AGE\nsome  otm/stream  0.4 s\nbody\n") << "all are still there";
  EXPECT_EQ(shown(table, 22),
            "NAME       MODE\nsome body  otm/stream\nNot shown here: AGE (a\nwider terminal or\n--json shows all)\n");
  EXPECT_EQ(shown(table, 15),
            "NAME\nsome body\nNot shown here:\nAGE, MODE (a\nwider terminal\nor --json shows\nall)\n");
}

TEST(Table, BreaksAWordOnlyWhereNoOtherColumnCanGoOrItIsVeryLong) {
  Table table({{"NAME", false, 4}, {"MODE", false, 0, 1}});
  table.add({"unbroken", "otm/stream"});
  EXPECT_THAT(shown(table, 19), testing::StartsWith("NAME\nunbroken\nNot shown here"));
  EXPECT_THAT(shown(table, 7), testing::StartsWith("NAME\nunbroke\nn\n"));
  table.add({std::string(60, 'x'), ""});
  EXPECT_THAT(shown(table, 44), testing::StartsWith("NAME" + std::string(30, ' ') + "MODE\nunbroken"));
}

TEST(Table, PutsWhatStandsBehindAWideWordToTheRightOrIntoTheNextLine) {
  Table table({{"CONSUMER", false, 4}, {"IDENTITY", false, 4}, {"REQUEST"}});
  table.add({"Base@robot1", "KickStat", "1/2/3"});
  table.add({"RefereeBoxInterface@monitor", "Box", "1/2/4"});
  table.add({"Base@robot1", "a-name-that-is-longer-than-its-column", "1/2/5"});
  EXPECT_EQ(shown(table, 60),
            "CONSUMER                  IDENTITY                   REQUEST\n"
            "Base@robot1               KickStat                   1/2/3\n"
            "RefereeBoxInterface@monitor  Box                     1/2/4\n"
            "Base@robot1\n"
            "                       a-name-that-is-longer-than-its-column\n"
            "                                                     1/2/5\n");
}

TEST(Table, IsABlockOfLinesForEachRowWhereMostOfThemDoNotStaySideBySide) {
  Table table({{"CONSUMER", false, 4}, {"IDENTITY", false, 4}, {"REQUEST"}, {""}});
  table.add({"Base@robot1", "KickStat", "1/2/3", "(this host)"});
  table.add({"RefereeBoxInterface@monitor", "Box", "1/2/4", " "});
  table.add({"Base@robot1", "a name that is longer than its column", "", "-"});
  EXPECT_EQ(shown(table, 32),
            "CONSUMER  Base@robot1\n"
            "IDENTITY  KickStat\n"
            "REQUEST   1/2/3\n"
            "          (this host)\n"
            "\n"
            "CONSUMER  RefereeBoxInterface@\n"
            "          monitor\n"
            "IDENTITY  Box\n"
            "REQUEST   1/2/4\n"
            "\n"
            "CONSUMER  Base@robot1\n"
            "IDENTITY  a name that is longer\n"
            "          than its column\n");
  EXPECT_THAT(shown(table, 16), testing::StartsWith("CONSUMER\nBase@robot1\nIDENTITY\nKickStat\n"))
      << "titles have lines of their own where they would take more than half of a line";
}

TEST(Table, PutsSentencesOverBlocksToo) {
  Table table({{"NAME"}, {"WHY", false, 20, 0, true}, {"REQUEST"}});
  for (const char* name : {"one", "two"}) {
    table.add({std::string(name) + " with a long name", "nobody offers the ball", "aaaaaaaaaaaa/1/1"});
  }
  table.add({"three with a name", "the modes differ", "aaaaaaaaaaaa/1/2"});
  EXPECT_EQ(shown(table, 30),
            "nobody offers the ball\n"
            "  NAME     one with a long\n"
            "           name\n"
            "  REQUEST  aaaaaaaaaaaa/1/1\n"
            "\n"
            "  NAME     two with a long\n"
            "           name\n"
            "  REQUEST  aaaaaaaaaaaa/1/1\n"
            "\n"
            "the modes differ\n"
            "  NAME     three with a name\n"
            "  REQUEST  aaaaaaaaaaaa/1/2\n");
}

TEST(Table, PutsSentencesOverTheRowsThatHaveTheSameWhereTheyHaveNoRoom) {
  Table table({{"NAME"}, {"WHY", false, 20, 0, true}, {"REQUEST"}});
  table.add({"one", "nobody offers the ball, nor anything that is known to be below it", "a/1/1"});
  table.add({"two", "the modes differ: ask with mode=otm/stream, or offer it with mode=oto", "b/1/1"});
  table.add({"three", "nobody offers the ball, nor anything that is known to be below it", "c/1/1"});
  table.add({"served", "", "d/1/1"});
  EXPECT_EQ(shown(table, 40),
            "  NAME    REQUEST\n"
            "  served  d/1/1\n"
            "nobody offers the ball, nor anything\n"
            "that is known to be below it\n"
            "  one     a/1/1\n"
            "  three   c/1/1\n"
            "the modes differ: ask with\n"
            "mode=otm/stream, or offer it with\n"
            "mode=oto\n"
            "  two     b/1/1\n");
  EXPECT_THAT(shown(table, 200), testing::StartsWith("NAME    WHY")) << "a column where there is room";
  EXPECT_EQ(shown(table, 0), shown(table, 200)) << "one line a row where there is no terminal";
}

TEST(Table, IsAsWideAsItTakesWhereThereIsNoTerminal) {
  Table table({{"A", false, 4}, {"B", false, 0, 1}});
  table.add({std::string(500, 'a'), "b"});
  std::ostringstream out;
  table.print(out, {});
  EXPECT_THAT(out.str(), testing::EndsWith(std::string(500, 'a') + "  b\n"));
}

TEST(Encoded, LeavesNothingThatATerminalWithoutUtf8WouldGarble) {
  EXPECT_EQ(encoded({}, "Ölstand…"), "Ölstand…");
  Terminal terminal;
  terminal.has_utf8 = false;
  EXPECT_EQ(encoded(terminal, "Ölstand…"), "?lstand~");
}

TEST(Timestamp, IsUtcWithMilliseconds) {
  using namespace std::chrono;
  const system_clock::time_point epoch{};
  EXPECT_EQ(timestamp(epoch), "1970-01-01T00:00:00.000Z");
  EXPECT_EQ(timestamp(epoch + microseconds(1'999)), "1970-01-01T00:00:00.001Z") << "cut, not rounded";
  EXPECT_EQ(timestamp(epoch - milliseconds(1)), "1969-12-31T23:59:59.999Z");
  EXPECT_EQ(timestamp(sys_days(2028y / February / 29) + hours(23) + minutes(5) + seconds(9)),
            "2028-02-29T23:05:09.000Z");
}

TEST(Former, HasWhatWasOtherwiseAndNothingElse) {
  const boost::json::object before{
      {"same", 1}, {"port", 5000}, {"gone", "x"}, {"attributes", {{"rate", "15"}, {"a", "b"}}}};
  const boost::json::object now{
      {"same", 1}, {"port", 5001}, {"new", true}, {"attributes", {{"rate", "30"}, {"a", "b"}}}};
  const auto changed = former(before, now);
  EXPECT_EQ(changed,
            (boost::json::object{{"port", 5000}, {"gone", "x"}, {"attributes", {{"rate", "15"}}}, {"new", nullptr}}));
  EXPECT_EQ(words_of(changed), "port was 5000, gone was x, rate was 15, new was absent");
  EXPECT_TRUE(former(now, now).empty());
}

TEST(Words, AreShortAndExact) {
  EXPECT_EQ(who("1a2b3c4d/3", "vision", "robot2"), "vision@robot2");
  EXPECT_EQ(who("1a2b3c4d/3", "", ""), "3@1a2b3c4d");
  EXPECT_EQ(place("10.0.0.2", "5000"), "10.0.0.2:5000");
  EXPECT_EQ(place("fe80::1", "5000"), "[fe80::1]:5000");
  EXPECT_EQ(place("10.0.0.2", ""), "10.0.0.2");
  EXPECT_EQ(attribute_words({{"a", "b"}, {"c", ""}, {"d", "e f"}}), "a=b c d=\"e f\"");
  EXPECT_EQ(identity_words(NumericIdentity{7}), "7");
  EXPECT_EQ(identity_words(TextIdentity{"a b"}), "\"a b\"");
  EXPECT_EQ(identity_words(ConceptNames{"s:Ball", "s:Field"}), "s:Ball in s:Field");
  for (const auto& [seconds, words] : std::vector<std::pair<std::string, std::string>>{{"0.000", "0.0 s"},
                                                                                       {"9.94", "9.9 s"},
                                                                                       {"45.2", "45 s"},
                                                                                       {"600", "10 min"},
                                                                                       {"7200", "2.0 h"},
                                                                                       {"864000", "10 d"},
                                                                                       {"soon", "soon"},
                                                                                       {"", ""}}) {
    EXPECT_EQ(duration_words(seconds), words) << seconds;
  }
}

TEST(Json, HasNumbersFlagsListsAndAttributes) {
  Record record{"services",
                {{"service", "1a2b3c4d/1/2"}, {"port", "5000"}, {"age", "0.250"}, {"used", "1"}, {"text", "1"}},
                {{"rate", "30"}}};
  std::ostringstream out;
  print(out, to_json(record));
  EXPECT_EQ(out.str(),
            "{\"service\":\"1a2b3c4d/1/2\",\"port\":5000,\"age\":0.25,\"used\":true,\"text\":\"1\","
            "\"attributes\":{\"rate\":\"30\"}}\n");
}

TEST(Json, KeepsTheIdOfAParticipantAWord) {
  std::ostringstream out;
  print(out, to_json(Record{"participants", {{"id", "12345678"}, {"addresses", "10.0.0.2,::1"}, {"loss", "x"}}, {}}));
  EXPECT_EQ(out.str(), "{\"id\":\"12345678\",\"addresses\":[\"10.0.0.2\",\"::1\"],\"loss\":\"x\"}\n");
}

TEST(Json, EscapesWhatATerminalCouldObeyAndLosesNothing) {
  std::ostringstream out;
  print(out, boost::json::array{"\x1b \x7f \u009b \u202e \" ü", boost::json::array{}, boost::json::object{}});
  EXPECT_EQ(out.str(), "[\"\\u001b \\u007f \\u009b \\u202e \\\" ü\",[],{}]\n");
}

TEST(Report, GivesEachKindOfErrorItsExitStatus) {
  using Kind = ClientError::Kind;
  const std::vector<std::pair<ClientError, ExitStatus>> cases{
      {{Kind::wrong_use, "x", {}}, ExitStatus::wrong_use},
      {{Kind::unreachable, "x", {}}, ExitStatus::no_daemon},
      {{Kind::closed, "x", {}}, ExitStatus::no_daemon},
      {{Kind::timed_out, "x", {}}, ExitStatus::timed_out},
      {{Kind::refused, "x", ErrorCode::malformed}, ExitStatus::wrong_use},
      {{Kind::refused, "x", ErrorCode::unknown_request}, ExitStatus::nothing},
      {{Kind::refused, "x", ErrorCode::too_large}, ExitStatus::wrong_use},
      {{Kind::refused, "x", ErrorCode::impossible}, ExitStatus::wrong_use},
      {{Kind::refused, "x", ErrorCode::too_many}, ExitStatus::no_daemon},
      {{Kind::refused, "x", ErrorCode::not_ready}, ExitStatus::no_daemon},
  };
  for (const auto& [error, status] : cases) EXPECT_EQ(report("program", error), status);
}

}  // namespace
}  // namespace geminga::shell
