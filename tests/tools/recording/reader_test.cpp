// Recordings read: what is written comes back, and whatever else a file has costs its own line only.
#include "recording/reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "discovery/gcnp/statement.hpp"
#include "recording/moment.hpp"
#include "recording/record_json.hpp"
#include "tools/recording/rows.hpp"

namespace geminga::recording {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using namespace std::chrono_literals;

std::string snapshot(At at = 0ms, std::size_t records = 0) {
  return line_of(entry(at, Snapshot{"1a2b3c4d", "robot1", "-", records}));
}

TEST(Entry, ComesBackAsItWasWritten) {
  const Record record = service("1a2b3c4d/2/7", "soccer:BallInfo", {{"rate", "30"}, {"where", "left eye"}});
  const std::vector<Entry> entries{
      entry(0ms, Snapshot{"1a2b3c4d", "robot1", "0123456789abcdef", 0}),
      present(5ms, record, Present::Change::modify),
      entry(6ms, Gone{"services", "1a2b3c4d/2/7", "withdrawn"}),
      entry(7ms, Heard{{Record{"participants", {{"id", "1a2b3c4d"}, {"heard", "0.250"}, {"loss", "0.125"}}, {}}}}),
      entry(8ms, Answered{"why", "1a2b3c4d/1/1", {{}, Record{"end", {{"code", "nobody"}}, {}}}}),
      entry(9ms, Skipped{3}),
      entry(10ms, Lost{"the daemon is gone"}),
      entry(11ms, End{"stopped"})};
  const std::string text = text_of(entries);
  const ReadText read = read_text(text);
  EXPECT_THAT(read.findings, IsEmpty());
  EXPECT_EQ(text_of(read.entries), text);
  const auto& back = std::get<Present>(read.entries.at(1).event).record;
  EXPECT_EQ(gcnp::to_line(statement_of(1, back)), gcnp::to_line(statement_of(1, record)));
  EXPECT_THAT(gcnp::to_line(statement_of(1, back)), HasSubstr("attr.where=\"left eye\"")) << "no key is hidden";
}

TEST(Reader, ReadsTheRecordingOfTheSpecificationAndOfARealTeam) {
  std::ifstream document(GEMINGA_SOURCE_DIR "/tools/recording/RECORDING.md");
  std::string example;
  for (std::string line; std::getline(document, line);) {
    if (line.starts_with("{\"event\"")) example += line + '\n';
  }
  EXPECT_THAT(read_text(example).findings, IsEmpty());
  EXPECT_THAT(read_text(example).entries, SizeIs(6));
  std::ifstream real(GEMINGA_SOURCE_DIR "/tests/fuzz/seeds/recording/field_test.jsonl");
  const std::string text{std::istreambuf_iterator<char>(real), {}};
  EXPECT_THAT(read_text(text).findings, IsEmpty());
  EXPECT_EQ(text_of(read_text(text).entries), text);
}

TEST(Reader, SaysWhereARecordingWasCutAndReadsAllBefore) {
  const std::string whole = snapshot() + line_of(present(1s, service("1a2b3c4d/2/7", "a:B")));
  const std::size_t begin = snapshot().size();
  for (std::size_t size = begin + 1; size + 1 < whole.size(); ++size) {
    const ReadText read = read_text(whole.substr(0, size));
    EXPECT_THAT(read.entries, SizeIs(1)) << size;
    EXPECT_THAT(read.findings,
                ElementsAre(HasSubstr("line 2, octet " + std::to_string(begin) + ": the recording was cut")))
        << size;
  }
  EXPECT_THAT(read_text(whole.substr(0, whole.size() - 1)).entries, SizeIs(2)) << "only its end is missing";
}

TEST(Reader, LeavesOutALineThatItCannotUseAndSaysWhich) {
  const std::string good = line_of(entry(1s, End{"stopped"}));
  for (const std::string& bad : {
           std::string("garbage"),
           std::string("[1,2]"),
           std::string("{}"),
           std::string("\xff\xfe\0\0", 4),
           std::string(200, '\0'),
           std::string(5000, '['),
           std::string(R"({"event":"end","time":"2026-11-27T03:10:02.809Z","at":-1,"reason":""})"),
           std::string(R"({"event":"end","time":"2026-11-27T03:10:02.809Z","at":1e300,"reason":""})"),
           std::string(R"({"event":"end","time":"yesterday","at":1,"reason":""})"),
           std::string(R"({"event":"end","time":"2026-02-30T03:10:02.809Z","at":1,"reason":""})"),
           std::string(R"({"event":"end","time":"2026-11-27T03:10:02.809Z","at":1})"),
           std::string(R"({"event":"add","time":"2026-11-27T03:10:02Z","at":1,"kind":"services","record":{}})"),
           std::string(R"({"event":"add","time":"2026-11-27T03:10:02Z","at":1,"kind":"moon","record":{"id":"1"}})"),
           std::string(R"({"event":"add","time":"2026-11-27T03:10:02Z","at":1,"kind":"services","record":[]})"),
           std::string(R"({"event":"add","time":"2026-11-27T03:10:02Z","at":1,"kind":"services",)"
                       R"("record":{"service":"1/2/3","a b":"key"}})"),
           std::string(R"({"event":"add","time":"2026-11-27T03:10:02Z","at":1,"kind":"services",)"
                       R"("record":{"service":{"x":1}}})"),
           std::string(R"({"event":"del","time":"2026-11-27T03:10:02Z","at":1,"kind":"moon","key":"","reason":""})"),
           std::string(R"({"event":"answer","time":"2026-11-27T03:10:02Z","at":1,"kind":"a b","records":[],"end":{}})"),
           std::string(R"({"event":"answer","time":"2026-11-27T03:10:02Z","at":1,"kind":"a","records":[1],"end":{}})"),
       }) {
    const ReadText read = read_text(snapshot() + bad + '\n' + good);
    EXPECT_THAT(read.entries, SizeIs(2)) << bad;
    EXPECT_THAT(read.findings,
                ElementsAre(testing::AllOf(testing::StartsWith("line 2, octet " + std::to_string(snapshot().size())),
                                           testing::EndsWith(": left out"))))
        << bad;
  }
}

TEST(Reader, IgnoresEventsThatAreNewerThanItself) {
  const ReadText read =
      read_text(snapshot() + R"({"event":"battery","time":"2026-11-27T03:10:02Z","at":1,"volts":11.1})" + "\n");
  EXPECT_THAT(read.entries, SizeIs(1));
  EXPECT_THAT(read.findings, IsEmpty());
}

TEST(Reader, BoundsALine) {
  const std::string head = R"({"event":"end","time":"2026-11-27T03:10:02Z","at":1,"reason":")";
  const std::string tail = "\"}";
  for (const std::size_t size : {max_line_bytes - 1, max_line_bytes, max_line_bytes + 1, 3 * max_line_bytes}) {
    const std::string line = head + std::string(size - head.size() - tail.size(), 'x') + tail;
    const ReadText read = read_text(snapshot() + line + '\n' + line_of(entry(2s, End{"stopped"})));
    EXPECT_THAT(read.entries, SizeIs(size <= max_line_bytes ? 3 : 2)) << size;
    EXPECT_THAT(read.findings, SizeIs(size <= max_line_bytes ? 0 : 1)) << size;
  }
}

TEST(Reader, BoundsARecordToALineOfGcnp) {
  const auto line = [](std::size_t size) {
    return R"({"event":"add","time":"2026-11-27T03:10:02Z","at":1,"kind":"services","record":{"service":"1/2/3","name":")" +
           std::string(size, 'x') + "\"}}\n";
  };
  EXPECT_THAT(read_text(snapshot() + line(30'000)).findings, IsEmpty());
  EXPECT_THAT(read_text(snapshot() + line(33'000)).findings, ElementsAre(HasSubstr("longer than a line of GCNP")));
}

TEST(Reader, GoesOnFromTheLineBeforeWhereTimeRunsBackwards) {
  const ReadText read = read_text(snapshot() + line_of(entry(5s, Skipped{1})) + snapshot(1s) +
                                  line_of(entry(3s, Skipped{1})) + line_of(entry(4s, End{""})));
  std::vector<At> times;
  for (const Entry& one : read.entries) times.push_back(one.at);
  EXPECT_THAT(times, ElementsAre(0s, 5s, 5s, 7s, 8s));
  EXPECT_THAT(read.findings, ElementsAre(HasSubstr("line 3, octet")));
  EXPECT_THAT(read.findings.at(0), HasSubstr("time runs backwards by 4000 ms"));
}

TEST(Reader, BeginsWithTheFirstSnapshot) {
  const ReadText read = read_text("octets of a former line\n" + line_of(entry(3s, Skipped{1})) + snapshot(4s));
  EXPECT_THAT(read.entries, SizeIs(1));
  EXPECT_THAT(read.findings, ElementsAre(HasSubstr("line 1"), HasSubstr("line 2, octet 24: the beginning is missing")));
}

TEST(Reader, RefusesAnotherVersionAndWhatIsNoRecording) {
  std::string other = snapshot();
  other.replace(other.find("\"version\":1"), 11, "\"version\":2");
  EXPECT_THAT(read_text(other).findings,
              ElementsAre(HasSubstr("ends: line 1, octet 0: the recording has another version 2")));
  EXPECT_THAT(read_text(snapshot() + other).entries, SizeIs(1));
  EXPECT_THAT(read_text("").findings, ElementsAre(HasSubstr("is no recording")));
  EXPECT_THAT(read_text("\n\n").findings, SizeIs(3));
  EXPECT_THAT(read_text(line_of(entry(3s, Skipped{1}))).findings, SizeIs(2));
}

TEST(Moment, IsReadInThreeForms) {
  EXPECT_EQ(std::get<At>(*parse_moment("90.5")), 90'500ms);
  EXPECT_EQ(std::get<TimeOfDay>(*parse_moment("14:03")).since_midnight, 14h + 3min);
  EXPECT_EQ(std::get<TimeOfDay>(*parse_moment("14:03:09.25")).since_midnight, 14h + 3min + 9250ms);
  EXPECT_EQ(std::get<Time>(*parse_moment("1970-01-02T00:00:01.5Z")), Time(24h + 1500ms));
  for (const char* bad : {"", "-1", "nan", "1e3", "24:00", "14:60", "14:3", "14:03:", "14:03:09.",
                          "2026-13-01T00:00:00Z", "2026-11-22T04:36:13+01:00", "1969-01-01T00:00:00Z", "31622401"}) {
    EXPECT_FALSE(parse_moment(bad)) << bad;
  }
}

}  // namespace
}  // namespace geminga::recording
