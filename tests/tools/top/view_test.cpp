// The parts of geminga-query top without a terminal: rates, keys, the table and what is written of it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "query/top/keys.hpp"
#include "query/top/screen.hpp"
#include "query/top/table_view.hpp"
#include "tools/top/emulated_terminal.hpp"

namespace geminga::query::top {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;
using tools::EmulatedTerminal;
using namespace std::chrono_literals;

Record status(const std::string& uptime, const std::string& received) {
  return {"status",
          {{"name", "robot1"},
           {"participant", "00000001"},
           {"state", "ready"},
           {"uptime", uptime},
           {"participants", "3"},
           {"publications", "5"},
           {"subscriptions", "4"},
           {"datagrams_received", received},
           {"bytes_received", "2048"},
           {"datagrams_sent", "0"},
           {"bytes_sent", "0"}},
          {}};
}
Record robot(const std::string& name, const std::string& heard, const std::string& loss, const std::string& services) {
  return {"participants",
          {{"id", "0000000" + services},
           {"name", name},
           {"addresses", "10.0.0.1"},
           {"heard", heard},
           {"interval", "2.000"},
           {"loss", loss},
           {"loss_least", loss},
           {"publications", services},
           {"subscriptions", "0"}},
          {}};
}
Record request(int number) {
  return {"requests",
          {{"subscription", "00000001/1/" + std::to_string(number)},
           {"consumer", "00000001/1"},
           {"name", "base"},
           {"participant_name", "robot1"},
           {"text", "camera" + std::to_string(number)},
           {"because", "nobody offers it"}},
          {}};
}
Round team(int unmatched = 2) {
  Round round{status("10.000", "20"),
              {robot("b", "0.100", "0.500", "1"), robot("c", "9.000", "0.100", "3"), robot("a", "1.000", "0.000", "2")},
              {}};
  for (int i = 1; i <= unmatched; ++i) round.unmatched.push_back(request(i));
  return round;
}
Seen seen_of(Round round) {
  Tally tally;
  tally.take(std::move(round), 0ms);
  return tally.seen();
}
std::string text_of(const std::vector<Line>& lines) {
  std::string text;
  for (const Line& line : lines) text += line.text + '\n';
  return text;
}
/// The names of the robots in their order.
std::string names(TableView& view, const Seen& seen) {
  std::string names;
  for (const Line& line : view.lines(seen, {24, 100}, "")) {
    if (line.text.starts_with("a ") || line.text.starts_with("b ") || line.text.starts_with("c "))
      names += line.text[0];
  }
  return names;
}

TEST(Tally, CountsRatesFromRoundToRound) {
  Tally tally;
  tally.take({status("10.000", "20"), {}, {}}, 0ms);
  EXPECT_DOUBLE_EQ(tally.seen().rates.at("datagrams_received"), 2) << "since the daemon's start";
  tally.take({status("12.000", "30"), {}, {}}, 2s);
  EXPECT_DOUBLE_EQ(tally.seen().rates.at("datagrams_received"), 5);
  EXPECT_DOUBLE_EQ(tally.seen().rates.at("bytes_received"), 0);
  tally.take({status("1.000", "3"), {}, {}}, 3s);
  EXPECT_DOUBLE_EQ(tally.seen().rates.at("datagrams_received"), 3) << "another daemon counts from its own start";
  tally.take({Record(), {}, {}}, 3s);
  EXPECT_DOUBLE_EQ(tally.seen().rates.at("datagrams_received"), 0) << "no time has passed";
}

TEST(Tally, SaysForHowLongARequestHasHadNoProvider) {
  Tally tally;
  tally.take(team(1), 0ms);
  tally.take(team(2), 3s);
  EXPECT_DOUBLE_EQ(tally.seen().unmatched_for.at("00000001/1/1"), 3);
  EXPECT_DOUBLE_EQ(tally.seen().unmatched_for.at("00000001/1/2"), 0);
  tally.take(team(0), 4s);
  tally.take(team(1), 5s);
  EXPECT_DOUBLE_EQ(tally.seen().unmatched_for.at("00000001/1/1"), 0) << "it was served meanwhile";
}

TEST(Tally, RemembersForAMinuteWhoIsGone) {
  Tally tally;
  tally.take(team(), 0ms);
  Round without = team();
  without.participants.erase(without.participants.begin());  // b, which has service 1
  tally.take(without, 5s);
  ASSERT_THAT(tally.seen().gone, SizeIs(1));
  EXPECT_EQ(tally.seen().gone[0].record["name"], "b");
  EXPECT_DOUBLE_EQ(tally.seen().gone[0].seconds, 5);
  TableView view(Order::name);
  const auto lines = view.lines(tally.seen(), {24, 100}, "");
  EXPECT_THAT(text_of(lines), HasSubstr("gone for 5.0 s"));
  tally.take(without, 60s);
  EXPECT_THAT(tally.seen().gone, SizeIs(1));
  tally.take(team(), 60s);
  EXPECT_THAT(tally.seen().gone, IsEmpty()) << "it is back";
  tally.take(without, 120s);
  EXPECT_THAT(tally.seen().gone, SizeIs(1));
  tally.take(without, 121s);
  EXPECT_THAT(tally.seen().gone, IsEmpty());
}

TEST(Keys, AreReadInWhateverPiecesTheyCome) {
  const std::string octets = "q\x1b[A\x1b[B\x1bOA\x1b[5~\x1b[6~\x1b[1;5C\r\n\xc3\xbc";
  const std::vector<Key> expected{'q',        key::up,    key::down,  key::up,    key::page_up, key::page_down,
                                  key::other, key::enter, key::enter, key::other, key::other};
  EXPECT_EQ(Keys().read(octets), expected);
  for (std::size_t cut = 0; cut <= octets.size(); ++cut) {
    if (cut > 0 && octets[cut - 1] == '\x1b') continue;  // an escape at the end of a piece is the key
    Keys keys;
    auto read = keys.read(octets.substr(0, cut));
    for (const Key key : keys.read(octets.substr(cut))) read.push_back(key);
    EXPECT_EQ(read, expected) << cut;
  }
  EXPECT_THAT(Keys().read("\x1b"), ElementsAre(key::escape));
}

TEST(Keys, WaitForNoSequenceWithoutEnd) {
  Keys keys;
  EXPECT_THAT(keys.read("\x1b[" + std::string(max_sequence_bytes - 2, '1')), IsEmpty());
  EXPECT_THAT(keys.read("A"), ElementsAre(key::other));
  EXPECT_THAT(keys.read("\x1b[" + std::string(max_sequence_bytes - 1, '1')), IsEmpty());
  EXPECT_THAT(keys.read("q"), ElementsAre('q')) << "it was given up";
}

TEST(TableView, SortsByWhatItsKeysSay) {
  const Seen seen = seen_of(team());
  TableView view(Order::name);
  EXPECT_EQ(names(view, seen), "abc");
  EXPECT_EQ(view.press('h', seen), TableView::Wish::nothing);
  EXPECT_EQ(names(view, seen), "cab");
  static_cast<void>(view.press('l', seen));
  EXPECT_EQ(names(view, seen), "bca");
  static_cast<void>(view.press('s', seen));
  EXPECT_EQ(names(view, seen), "cab");
  static_cast<void>(view.press('r', seen));
  EXPECT_EQ(names(view, seen), "bac");
  static_cast<void>(view.press('n', seen));
  EXPECT_EQ(names(view, seen), "abc") << "an order begins unreversed";
  EXPECT_EQ(view.press('q', seen), TableView::Wish::quit);
  EXPECT_EQ(order_of("loss"), Order::loss);
  EXPECT_FALSE(order_of("size"));
}

TEST(TableView, MarksRobotsInTrouble) {
  TableView view(Order::name);
  for (const Line& line : view.lines(seen_of(team()), {24, 100}, "")) {
    const bool is_troubled = line.text.starts_with("b ") || line.text.starts_with("c ");  // loss, late
    EXPECT_EQ(line.style == Style::warning, is_troubled) << line.text;
  }
  EXPECT_THAT(text_of(view.lines(seen_of(team()), {24, 100}, "")), HasSubstr("late"));
  Round healthy = team();
  healthy.participants = {robot("d", "6.000", "0.300", "1"), robot("e", "5.000", "0.000", "1")};
  EXPECT_THAT(text_of(view.lines(seen_of(healthy), {24, 100}, "")), testing::Not(HasSubstr("late")))
      << "at 30 % three in a row are lost now and then";
  healthy.participants[0].fields[3].second = "12.000";
  EXPECT_THAT(text_of(view.lines(seen_of(healthy), {24, 100}, "")), HasSubstr("late"));
}

TEST(TableView, AsksWhyOfTheSelectedRequestAndShowsIt) {
  const Seen seen = seen_of(team());
  TableView view(Order::name);
  EXPECT_EQ(view.press(key::enter, seen), TableView::Wish::ask_why);
  EXPECT_EQ(view.selected(), "00000001/1/1");
  static_cast<void>(view.press(key::down, seen));
  static_cast<void>(view.press(key::down, seen));
  EXPECT_EQ(view.press('w', seen), TableView::Wish::ask_why);
  EXPECT_EQ(view.selected(), "00000001/1/2");
  Answer answer;
  answer.end.fields = {{"text", "nobody offers \x1b[2Jtext=camera2"}, {"mend", "start it"}};
  view.explain(seen, answer);
  const std::string text = text_of(view.lines(seen, {24, 100}, ""));
  EXPECT_THAT(text, HasSubstr("base@robot1 asks for \"camera2\" (00000001/1/2)"));
  EXPECT_THAT(text, HasSubstr("\nstart it\n"));
  EXPECT_THAT(text, Not(HasSubstr("\x1b"))) << "a text from the air steers no terminal";
  EXPECT_THAT(text, Not(HasSubstr("NAME")));
  static_cast<void>(view.press(key::escape, seen));
  EXPECT_THAT(text_of(view.lines(seen, {24, 100}, "")), HasSubstr("NAME"));
}

TEST(TableView, KeepsTheSelectionWhereRequestsComeAndGo) {
  TableView view(Order::name);
  static_cast<void>(view.press(key::page_down, seen_of(team(5))));
  EXPECT_EQ(view.selected(), "00000001/1/5");
  Round without_first = team(5);
  without_first.unmatched.erase(without_first.unmatched.begin());
  static_cast<void>(view.lines(seen_of(without_first), {24, 100}, ""));
  EXPECT_EQ(view.selected(), "00000001/1/5");
  static_cast<void>(view.lines(seen_of(team(3)), {24, 100}, ""));
  EXPECT_EQ(view.selected(), "00000001/1/3");
  static_cast<void>(view.lines(seen_of(team(0)), {24, 100}, ""));
  EXPECT_THAT(view.selected(), IsEmpty());
  EXPECT_EQ(view.press(key::enter, seen_of(team(0))), TableView::Wish::nothing);
}

TEST(TableView, FitsEverySizeAndAlwaysShowsTheSelectedRequest) {
  const Seen seen = seen_of(team(50));
  for (std::size_t rows = 1; rows < 60; ++rows) {
    TableView view(Order::name);
    for (int i = 0; i < 30; ++i) static_cast<void>(view.press(key::down, seen));
    const auto lines = view.lines(seen, {rows, 80}, "");
    EXPECT_THAT(lines, SizeIs(rows)) << rows;
    const std::string text = text_of(lines);
    if (rows >= 10) {
      EXPECT_THAT(text, HasSubstr("> base@robot1  \"camera31\"")) << rows;
    }
    if (rows >= 5) {
      EXPECT_THAT(text, HasSubstr("q quit")) << rows;
    }
  }
}

TEST(TableView, SaysWhatTroubleThereIsAboveTheLastTable) {
  TableView view(Order::name);
  const auto lines = view.lines(seen_of(team()), {24, 100}, "no daemon at 127.0.0.1:4717");
  EXPECT_EQ(lines[0], (Line{"no daemon at 127.0.0.1:4717", Style::warning}));
  EXPECT_THAT(text_of(lines), HasSubstr("3 participants, 5 services, 4 requests, 2 unmatched"));
  EXPECT_THAT(TableView(Order::name).lines(Seen(), {24, 100}, "trouble"), SizeIs(24));
}

TEST(Screen, WritesOnlyWhatDiffers) {
  Screen screen;
  const shell::Terminal terminal{.is_terminal = true};
  EmulatedTerminal emulated(4);
  const auto show = [&](const std::vector<Line>& lines, Size size) {
    const std::string out = screen.show(lines, size, terminal);
    emulated.take(out);
    return out;
  };
  static_cast<void>(show({{"one"}, {"two"}, {"three"}}, {4, 10}));
  EXPECT_EQ(emulated.text(), "one\ntwo\nthree\n\n");
  EXPECT_THAT(show({{"one"}, {"two"}, {"three"}}, {4, 10}), IsEmpty());
  EXPECT_EQ(show({{"one"}, {"2"}, {"three"}}, {4, 10}), "\x1b[2;1H2\x1b[K");
  static_cast<void>(show({{"one"}}, {4, 10}));
  EXPECT_EQ(emulated.text(), "one\n\n\n\n");
  EXPECT_THAT(show({{"one"}}, {4, 20}), HasSubstr("\x1b[2J")) << "another size";
  screen.forget();
  EXPECT_THAT(show({{"one"}}, {4, 20}), HasSubstr("one"));
  EXPECT_THAT(emulated.unknown(), IsEmpty());
}

TEST(Screen, CutsALineInFrontOfTheLastColumn) {
  EXPECT_EQ(cut("abcdef", 6), "abcdef");
  EXPECT_EQ(cut("abcdef", 5), "abcd…");
  EXPECT_EQ(cut("äöüß", 3), "äö…");
  EXPECT_EQ(cut("abc", 0), "");
  EmulatedTerminal emulated(1);
  emulated.take(Screen().show({{"abcdef"}, {"hidden"}}, {1, 6}, {}));
  EXPECT_EQ(emulated.text(), "abcd…\n");
}

}  // namespace
}  // namespace geminga::query::top
