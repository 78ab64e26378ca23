// The lines that a recording gets, and the limit of its size.
#include "recording/recorder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "tools/recording/rows.hpp"

namespace geminga::recording {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;
using namespace std::chrono_literals;

constexpr std::uint64_t mib = 1024 * 1024;

Observation team(const std::string& heard = "0.100") {
  return {{participant("00000001", "0.000", true), participant("00000002", heard)},
          {service("00000002/1/1", "soccer:BallInfo")},
          {request("00000001/1/1", "camera")}};
}

/// The words of the events, and for records their keys: `add services 2/1/1`.
std::vector<std::string> told(const std::string& lines) {
  std::vector<std::string> words;
  // A snapshot before them lets the reader begin anywhere.
  const ReadText read = read_text(line_of(entry(0ms, Snapshot{})) + lines);
  EXPECT_THAT(read.findings, IsEmpty());
  for (const Entry& one : std::vector<Entry>(read.entries.begin() + 1, read.entries.end())) {
    const std::string line = line_of(one);
    std::string word = line.substr(10, line.find('"', 10) - 10);
    if (const auto* there = std::get_if<Present>(&one.event)) {
      word += ' ' + std::string(there->record[key_field(there->record.kind)]);
    }
    if (const auto* gone = std::get_if<Gone>(&one.event)) word += ' ' + gone->key + ' ' + gone->reason;
    words.push_back(word);
  }
  return words;
}

class ARecorder : public testing::Test {
 protected:
  std::vector<std::string> observe(const Observation& seen, At at) {
    const auto lines = recorder_.observe(seen, at, first_time + at);
    EXPECT_TRUE(lines);
    return told(lines.value_or(""));
  }
  Recorder recorder_{{"00000001", "robot1", "-", 0}, mib};
};

TEST_F(ARecorder, BeginsWithASnapshotAndThenTellsOfChangesOnly) {
  EXPECT_THAT(observe(team(), 0ms), ElementsAre("snapshot", "there 00000001", "there 00000002", "there 00000001/1/1",
                                                "there 00000002/1/1", "heard"));
  EXPECT_THAT(observe(team("0.350"), 250ms), IsEmpty()) << "an age is no change";
  EXPECT_THAT(observe(team("1.100"), 1s), ElementsAre("heard"));
  Observation changed = team();
  changed.services.front().attributes["rate"] = "30";
  changed.requests.push_back(request("00000001/1/2", "lamp"));
  EXPECT_THAT(observe(changed, 1250ms), ElementsAre("add 00000001/1/2", "modify 00000002/1/1"));
  EXPECT_THAT(observe(changed, snapshot_interval - 1ms), ElementsAre("heard"));
  EXPECT_THAT(observe(changed, snapshot_interval), SizeIs(7));
}

TEST_F(ARecorder, SaysWhetherARecordWasWithdrawnOrWentWithItsParticipant) {
  EXPECT_THAT(observe(team(), 0ms), SizeIs(6));
  Observation withdrawn = team();
  withdrawn.services.clear();
  EXPECT_THAT(observe(withdrawn, 1ms), ElementsAre("del 00000002/1/1 withdrawn"));
  EXPECT_THAT(observe(team(), 2ms), ElementsAre("add 00000002/1/1"));
  withdrawn.participants.pop_back();
  EXPECT_THAT(observe(withdrawn, 3ms), ElementsAre("del 00000002 gone", "del 00000002/1/1 gone"));
}

TEST_F(ARecorder, AsksWhyOfWhatMayHaveChanged) {
  EXPECT_THAT(recorder_.requests_to_ask(), IsEmpty());
  Observation seen = team();
  seen.requests.push_back(request("00000001/1/2", "lamp"));
  EXPECT_THAT(observe(seen, 0ms), SizeIs(7));
  EXPECT_THAT(recorder_.requests_to_ask(), ElementsAre("00000001/1/1", "00000001/1/2"));
  EXPECT_THAT(observe(seen, 1ms), IsEmpty());
  EXPECT_THAT(recorder_.requests_to_ask(), IsEmpty());
  seen.requests.back() = request("00000001/1/2", "light");
  EXPECT_THAT(observe(seen, 2ms), SizeIs(1));
  EXPECT_THAT(recorder_.requests_to_ask(), ElementsAre("00000001/1/2"));
  seen.services.clear();
  EXPECT_THAT(observe(seen, 3ms), SizeIs(1));
  EXPECT_THAT(recorder_.requests_to_ask(), SizeIs(2)) << "any service may matter to any request";
}

TEST_F(ARecorder, AsksOfEachRequestInItsTurn) {
  Observation seen = team();
  seen.requests.clear();
  for (int i = 100; i < 100 + 2 * static_cast<int>(max_reasons_in_round); ++i) {
    seen.requests.push_back(request("00000001/1/" + std::to_string(i), "camera"));
  }
  EXPECT_THAT(observe(seen, 0ms), Not(IsEmpty()));
  std::set<std::string> asked;
  for (int round = 1; round <= 2; ++round) {
    const auto keys = recorder_.requests_to_ask();
    EXPECT_THAT(keys, SizeIs(max_reasons_in_round));
    asked.insert(keys.begin(), keys.end());
    seen.services.front().attributes["rate"] = std::to_string(round);  // all are in doubt again
    EXPECT_THAT(observe(seen, At(round)), SizeIs(1));
  }
  EXPECT_THAT(asked, SizeIs(2 * max_reasons_in_round)) << "no request waits for others for ever";
}

TEST_F(ARecorder, WritesAnAnswerOnceUntilItDiffersAndAgainBehindASnapshot) {
  const Answered status{"status", "", {{Record{"status", {{"peers", "1"}}, {}}}, {}}};
  EXPECT_THAT(told(recorder_.answered(status, 0ms, first_time)), IsEmpty()) << "it would belong to nobody";
  EXPECT_THAT(observe(team(), 0ms), SizeIs(6));
  EXPECT_THAT(told(recorder_.answered(status, 1ms, first_time)), ElementsAre("answer"));
  EXPECT_THAT(told(recorder_.answered(status, 2ms, first_time)), IsEmpty());
  EXPECT_THAT(observe(team(), snapshot_interval), SizeIs(6));
  EXPECT_THAT(told(recorder_.answered(status, snapshot_interval, first_time)), ElementsAre("answer"));
}

TEST_F(ARecorder, BeginsAnewWhenADaemonIsThereAgain) {
  EXPECT_THAT(observe(team(), 0ms), SizeIs(6));
  EXPECT_THAT(told(recorder_.lost("the daemon is gone", 1s, first_time)), ElementsAre("lost"));
  recorder_.found_again({"00000009", "robot9", "-", 0});
  const auto lines = recorder_.observe(team(), 2s, first_time + 2s);
  ASSERT_TRUE(lines);
  EXPECT_THAT(*lines, HasSubstr("\"participant\":\"00000009\""));
}

/// A team whose state differs in each round in so many services.
Observation restless(int round, int services) {
  Observation seen = team();
  for (int i = 0; i < services; ++i) {
    seen.services.push_back(
        service("00000002/2/" + std::to_string(i), "soccer:BallInfo", {{"round", std::to_string(round)}}));
  }
  return seen;
}

TEST_F(ARecorder, NeverWritesMoreInAnyHourThanTheLimit) {
  std::vector<std::pair<At, std::size_t>> written;
  std::string all;
  for (int round = 0; round < 3 * 720; ++round) {
    const At at = round * 5s;
    const auto lines = recorder_.observe(restless(round, 20), at, first_time + at);
    ASSERT_TRUE(lines);
    if (!lines->empty()) written.emplace_back(at, lines->size());
    all += *lines;
  }
  std::uint64_t sum = 0;
  std::uint64_t most = 0;
  for (auto first = written.begin(), last = first; last != written.end(); ++last) {
    sum += last->second;
    for (; last->first - first->first >= 1h; ++first) sum -= first->second;
    most = std::max(most, sum);
  }
  EXPECT_LE(most, mib);
  EXPECT_GT(most, mib * 9 / 10) << "and it uses what it may";
  EXPECT_GT(recorder_.skipped_in_all(), 0U);
  EXPECT_THAT(all, HasSubstr("\"event\":\"skipped\""));
  EXPECT_THAT(read_text(all).findings, IsEmpty());
}

TEST_F(ARecorder, IsRightAgainBehindWhatItLeftOut) {
  std::string all;
  int last_written = -1;
  for (int round = 0; round < 800; ++round) {
    const auto lines = recorder_.observe(restless(round, 20), round * 5s, first_time + round * 5s);
    ASSERT_TRUE(lines);
    all += *lines;
    if (lines->find("\"event\":\"snapshot\"") != std::string::npos) last_written = round;
  }
  ASSERT_GT(last_written, 300) << "the limit was reached, and a snapshot came behind it";
  State state;
  for (const Entry& one : read_text(all).entries) {
    if (one.at <= last_written * 5s) state.apply(one);
  }
  ASSERT_THAT(state.of("services"), SizeIs(21));
  EXPECT_EQ(state.of("services").find("00000002/2/0")->second.attributes.at("round"), std::to_string(last_written));
}

TEST(Recorder, RefusesALimitThatIsLessThanTwoSnapshots) {
  const Observation seen = team();
  const auto size = Recorder({}, mib).observe(seen, 0ms, first_time)->size();
  EXPECT_TRUE(Recorder({}, 2 * size).observe(seen, 0ms, first_time));
  // The signs of life are written with the first snapshot, and are not part of it.
  const auto refused = Recorder({}, size).observe(seen, 0ms, first_time);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error(), HasSubstr("give a greater --limit"));
}

TEST(Allowance, GivesHalfAtOnceAndTheOtherHalfInAnHour) {
  Allowance allowance(7200);
  EXPECT_FALSE(allowance.take(3601, 0ms));
  EXPECT_TRUE(allowance.take(3600, 0ms));
  EXPECT_FALSE(allowance.take(1, 999ms));
  EXPECT_TRUE(allowance.take(1, 1s));
  EXPECT_FALSE(allowance.take(3600, 1h)) << "one octet was taken";
  EXPECT_TRUE(allowance.take(3600, 24h));
}

}  // namespace
}  // namespace geminga::recording
