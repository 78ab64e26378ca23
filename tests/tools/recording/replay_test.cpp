// A recording as a daemon: the team at each moment, and what a client is answered.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "recording/control.hpp"
#include "recording/player.hpp"
#include "recording/talk.hpp"
#include "tools/recording/rows.hpp"

namespace geminga::recording {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;
using namespace std::chrono_literals;

/// Robot 1 records; robot 2 offers a ball from second 1 to 5, and leaves in second 9; the daemon is lost in second 12.
const std::vector<Entry>& story() {
  static const std::vector<Entry> entries{
      entry(0s, Snapshot{"00000001", "robot1", "-", 3}),
      present(0s, participant("00000001", "0.000", true), Present::Change::there),
      present(0s, participant("00000002", "0.500"), Present::Change::there),
      present(0s, request("00000001/1/1", "camera"), Present::Change::there),
      entry(0s, Answered{"status", "", {{Record{"status", {{"state", "ready"}}, {}}}, {}}}),
      entry(0s, Answered{"why", "00000001/1/1", {{}, Record{"end", {{"code", "nobody"}, {"mend", "start it"}}, {}}}}),
      present(1s, service("00000002/1/1", "soccer:BallInfo", {{"rate", "30"}})),
      entry(2s, Heard{{Record{"participants", {{"id", "00000002"}, {"heard", "0.100"}, {"loss", "0.500"}}, {}}}}),
      entry(5s, Gone{"services", "00000002/1/1", "withdrawn"}),
      entry(9s, Gone{"participants", "00000002", "gone"}),
      entry(12s, Lost{"the daemon is gone"}),
      entry(14s, Snapshot{"00000001", "robot1", "-", 1}),
      present(14s, participant("00000001", "0.000", true), Present::Change::there),
      entry(15s, End{"stopped"})};
  return entries;
}

State state_at(At moment) {
  State state;
  for (const Entry& one : story()) {
    if (one.at <= moment) state.apply(one);
  }
  state.stand_at(moment);
  return state;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line.substr(0, line.find('\r')));
  return lines;
}

/// All answers to these octets of a client.
std::vector<std::string> answers(At moment, const std::string& said) {
  Talk talk(7);
  const State state = state_at(moment);
  talk.hear(said);
  std::string text;
  for (std::string one; !(one = talk.next_answer(state)).empty();) text += one;
  return lines_of(text);
}

TEST(Replay, AnswersAsTheDaemonDidAtThisMoment) {
  EXPECT_THAT(answers(0s, "1 query services\r\n"), ElementsAre("1 msg end count=0"));
  EXPECT_THAT(
      answers(3s, "1 query services\n"),
      ElementsAre("1 msg services service=00000002/1/1 provider=00000002/1 name=vision participant_name=robot00000002 "
                  "concept=soccer:BallInfo mode=oto priority=0 age=1.100 local=0 used=0 rate=30",
                  "1 msg end count=1"));
  EXPECT_THAT(answers(5s, "1 query services\n"), ElementsAre("1 msg end count=0"));
  EXPECT_THAT(answers(8s, "1 query participants\n"), SizeIs(3));
  EXPECT_THAT(answers(9s, "1 query participants\n"), SizeIs(2));
  EXPECT_THAT(answers(0s, "1 query requests\n").at(0), Not(HasSubstr("because")));
  EXPECT_THAT(answers(0s, "1 query requests unmatched=1\n").at(0), HasSubstr("because=\"nobody offers text=camera\""));
  EXPECT_THAT(answers(1s, "1 query services unused=1\n"), SizeIs(2));
  EXPECT_THAT(answers(1s, "1 query requests unused=1\n").at(0), HasSubstr("1 msg services "));
  EXPECT_THAT(answers(1s, "1 query why subscription=00000001/1/1\n"),
              ElementsAre("1 msg end count=0 code=nobody mend=\"start it\""));
  EXPECT_THAT(answers(1s, "1 query status\n").at(0), HasSubstr("state=ready recorded=2026-"));
}

TEST(Replay, TellsAgesOfTheMoment) {
  EXPECT_THAT(answers(1500ms, "1 query participants\n").at(1), HasSubstr("heard=2.000 loss=0.250"));
  EXPECT_THAT(answers(2500ms, "1 query participants\n").at(1), HasSubstr("heard=0.600 loss=0.500"));
  EXPECT_THAT(answers(2500ms, "1 query participants\n").at(0), HasSubstr("heard=0.000")) << "oneself is always heard";
  EXPECT_THAT(answers(4s, "1 query requests\n").at(0), HasSubstr("age=0.000")) << "what is local has no age";
}

TEST(Replay, FiltersByLettersAndSaysThatItHasNoOntology) {
  EXPECT_THAT(answers(1s, "1 query services concept=soccer:BallInfo\n"),
              ElementsAre(HasSubstr("00000002/1/1"), HasSubstr("gaps=\"a recording has no ontology")));
  EXPECT_THAT(answers(1s, "1 query services concept=soccer:TrackedObject\n"),
              ElementsAre(HasSubstr("1 422 a recording")));
  EXPECT_THAT(answers(1s, "1 query services mode=otm/stream\n"), SizeIs(1));
  EXPECT_THAT(answers(1s, "1 query services provider=robot00000002/vision\n"), SizeIs(2));
  EXPECT_THAT(answers(1s, "1 query services provider=00000002/2\n"), SizeIs(1));
  EXPECT_THAT(answers(1s, "1 query services filter=Ball\n"), SizeIs(2));
  EXPECT_THAT(answers(1s, "1 query services filter=lamp\n"), SizeIs(1));
  EXPECT_THAT(answers(1s, "1 query match\n").at(0),
              HasSubstr("1 msg match service=00000002/1/1 provider=00000002/1 name=vision concept=soccer:BallInfo "
                        "degree=exact distance=0"));
  EXPECT_THAT(answers(1s, "1 query match text=camera\n"), ElementsAre("1 msg end count=0"));
  EXPECT_THAT(answers(1s, "1 query concepts begin=soccer\n"),
              ElementsAre("1 msg concepts concept=soccer:BallInfo", "1 msg end count=1"));
}

TEST(Replay, RefusesWhatItCannotAnswer) {
  for (const char* statement :
       {"1 query explain sub=a:B super=a:C", "1 query why concept=a:B",
        "1 query why subscription=00000001/1/1 service=00000002/1/1", "1 query match where=\"rate > 10\"",
        "1 query match convert=yes", "1 sub create mode=oto text=x", "1 pub create mode=oto text=x port=5",
        "1 pub remove", "1 sub modify limit=1"}) {
    EXPECT_THAT(answers(1s, std::string(statement) + "\n"), ElementsAre(HasSubstr("1 422 "))) << statement;
  }
  EXPECT_THAT(answers(1s, "1 query why subscription=00000001/1/9\n"), ElementsAre(HasSubstr("1 404 ")));
  EXPECT_THAT(answers(1s, "1 query ontology\n"), ElementsAre(HasSubstr("1 503 ")));
  EXPECT_THAT(answers(13s, "1 query participants\n"), ElementsAre(HasSubstr("1 503 at this moment of the recording")));
  EXPECT_THAT(answers(14s, "1 query participants\n"), SizeIs(2));
}

TEST(Replay, SpeaksGcnpWithWhomeverComes) {
  EXPECT_THAT(
      answers(0s, "0 sys hello name=try\r\n0 sys ping\r\nwhat\r\n3 query moon\r\n0 sys ping\r\n"),
      ElementsAre("0 msg hello version=1 participant=00000001 peer=7 name=try ontology=- participant_name=robot1",
                  "0 msg pong", HasSubstr("0 400 "), HasSubstr("3 400 "), "0 msg pong"));
  EXPECT_THAT(answers(0s, "GET / HTTP/1.1\r\n\r\n"), ElementsAre(HasSubstr("0 400 ")));
  EXPECT_THAT(answers(0s, "0 sys ping\n5 query services filter=" + std::string(70'000, 'x') + "\n0 sys ping\n"),
              ElementsAre("0 msg pong", HasSubstr("5 413 "), "0 msg pong"));
  Talk talk(1);
  talk.hear("0 sys bye\n0 sys ping\n");
  EXPECT_THAT(talk.next_answer(state_at(0s)), IsEmpty());
  EXPECT_TRUE(talk.is_over());
}

TEST(Replay, KeepsWhatADamagedSnapshotDoesNotName) {
  State state = state_at(3s);
  state.apply(entry(4s, Snapshot{"00000001", "robot1", "-", 2}));
  state.apply(present(4s, participant("00000001", "0.000", true), Present::Change::there));
  state.apply(present(5s, service("00000001/1/9", "a:B")));  // a line of the snapshot is missing
  EXPECT_THAT(state.of("participants"), SizeIs(2));
  EXPECT_THAT(state.of("services"), SizeIs(2));
}

class APlayer : public testing::Test {
 protected:
  std::expected<Player, Finding> begin(double speed, const std::string& from = "") {
    in_.str(text_of(story()));
    in_.clear();
    return Player::begin(Reader(in_, [](const Finding&) {}), speed, from.empty() ? std::nullopt : parse_moment(from));
  }
  std::istringstream in_;
};

TEST_F(APlayer, MovesWithTheTimeThatPasses) {
  auto player = begin(1);
  ASSERT_TRUE(player);
  EXPECT_THAT(player->state().of("participants"), SizeIs(2)) << "a whole snapshot is there from the start";
  EXPECT_EQ(player->next_due(), 1s);
  ASSERT_TRUE(player->move_to(1s));
  EXPECT_THAT(player->state().of("services"), SizeIs(1));
  ASSERT_TRUE(player->move_to(100s));
  EXPECT_TRUE(player->is_over());
  EXPECT_EQ(player->state().time(), first_time + 15s) << "the last moment stays";
}

TEST_F(APlayer, PlaysFasterAndSlower) {
  auto fast = begin(10);
  EXPECT_EQ(fast->next_due(), 100ms);
  ASSERT_TRUE(fast->move_to(490ms));
  EXPECT_THAT(fast->state().of("services"), SizeIs(1));
  ASSERT_TRUE(fast->move_to(500ms));
  EXPECT_THAT(fast->state().of("services"), IsEmpty());
  EXPECT_EQ(begin(0.5)->next_due(), 2s);
}

TEST_F(APlayer, BeginsAtAMoment) {
  auto player = begin(1, "3.5");
  EXPECT_THAT(player->state().of("services"), SizeIs(1));
  EXPECT_EQ(player->state().time(), first_time + 3500ms);
  EXPECT_EQ(player->next_due(), 1500ms);
  EXPECT_THAT(begin(1, "5")->state().of("services"), IsEmpty());
  EXPECT_THAT(begin(1, "0")->state().of("participants"), SizeIs(2));
  EXPECT_TRUE(begin(1, "15")) << "the moment of its last line";
  const auto late = begin(1, "16");
  ASSERT_FALSE(late);
  EXPECT_THAT(late.error().text, HasSubstr("ends before that moment, after 15.0 s"));
}

TEST_F(APlayer, GoesBackAndAheadAndChangesItsSpeedWhileItPlays) {
  auto player = begin(1);
  ASSERT_TRUE(player->move_to(10s));
  EXPECT_THAT(player->state().of("participants"), SizeIs(1));
  ASSERT_TRUE(player->seek(At{3s}));
  EXPECT_THAT(player->state().of("participants"), SizeIs(2)) << "robot 2 is there again";
  EXPECT_THAT(player->state().of("services"), SizeIs(1));
  EXPECT_EQ(player->now(), At{3s});
  player->set_speed(10);
  EXPECT_EQ(player->next_due(), 200ms);
  ASSERT_TRUE(player->move_to(200ms));
  EXPECT_THAT(player->state().of("services"), IsEmpty());
  const auto beyond = player->seek(At{99s});
  ASSERT_FALSE(beyond);
  EXPECT_THAT(beyond.error().text, HasSubstr("ends before that moment"));
  EXPECT_TRUE(player->is_over());
  ASSERT_TRUE(player->seek(At{0s})) << "and back from the end";
  EXPECT_FALSE(player->is_over());
}

TEST(Control, IsReadFromALine) {
  const auto kind = [](std::string_view line) {
    const auto control = read_control(line);
    return control ? control->index() : std::variant_npos;
  };
  const std::vector<std::pair<std::string_view, std::size_t>> lines{
      {"", 0},           {" \r", 0},      {"pause", 1},         {"pa", 1},      {"play", 2}, {" pl ", 2},
      {"speed 0.01", 3}, {"sp 10000", 3}, {"seek 14:03:10", 4}, {"se 90.5", 4}, {"+10", 5},  {"-2.5", 5}};
  for (const auto& [line, index] : lines) EXPECT_EQ(kind(line), index) << line;
  EXPECT_EQ(std::get<Skip>(*read_control("-2.5")).time, -2500ms);
  for (const char* line : {"p", "s 1", "x", "pause now", "speed", "speed 0", "speed nan", "speed 1x", "seek",
                           "seek noon", "+", "-", "+14:03", "++1", "\x1b[2J"}) {
    ASSERT_FALSE(read_control(line)) << line;
    EXPECT_THAT(read_control(line).error(), Not(HasSubstr("\x1b")));
  }
}

TEST(HasCome, TakesATimeOfDayBehindTheBeginning) {
  const Entry first = entry(0s, Skipped{1});  // 2026-11-18, 10:26:40 UTC
  const auto clock = first_time - std::chrono::floor<std::chrono::days>(first_time);
  EXPECT_TRUE(has_come(entry(10s, Skipped{1}), TimeOfDay{clock + 10s}, first));
  EXPECT_FALSE(has_come(entry(11s, Skipped{1}), TimeOfDay{clock + 10s}, first));
  EXPECT_TRUE(has_come(entry(23h, Skipped{1}), TimeOfDay{clock - 1s}, first)) << "that is on the next day";
  EXPECT_FALSE(has_come(entry(24h, Skipped{1}), TimeOfDay{clock - 1s}, first));
}

}  // namespace
}  // namespace geminga::recording
