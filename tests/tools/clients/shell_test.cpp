// The parts that the programs share: what is printable, tables, words, JSON.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/json/array.hpp>
#include <sstream>

#include "shell/describe.hpp"
#include "shell/json.hpp"
#include "shell/report.hpp"
#include "shell/table.hpp"
#include "shell/terminal.hpp"

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

TEST(Shortened, CutsAtACharacter) {
  EXPECT_EQ(shortened("Ölstand", 7), "Ölstand");
  EXPECT_EQ(shortened("Ölstand", 6), "Ölsta…");
  EXPECT_EQ(shortened("Ölstand", 1), "…");
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

TEST(Table, FitsIntoATerminalByCuttingItsWidestColumns) {
  Table table({{"A"}, {"B", false, 4}, {"C", false, 4}});
  table.add({"fixed", "bbbbbbbbbbbb", "cccccc"});
  std::ostringstream out;
  table.print(out, {.is_terminal = true, .has_colour = false, .columns = 20});
  EXPECT_EQ(out.str(), "A      B      C\nfixed  bbbb…  cccccc\n");
  std::ostringstream narrow;
  table.print(narrow, {.is_terminal = true, .has_colour = false, .columns = 1});
  EXPECT_EQ(narrow.str(), "A      B     C\nfixed  bbb…  ccc…\n") << "never below what can be read";
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
