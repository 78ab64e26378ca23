// A finding that may be of the moment has to be seen twice.
#include "doctor/steady.hpp"

#include <gtest/gtest.h>

namespace geminga::doctor {
namespace {

Record record(std::vector<std::pair<std::string, std::string>> fields) {
  return {.kind = "", .fields = std::move(fields), .attributes = {}};
}

Answers look(double at) {
  Answers answers;
  answers.status = record({{"interval", "2.000"}});
  answers.asked_from = at;
  answers.asked_until = at;
  return answers;
}

TEST(Steady, LeavesOutRequestsThatWereStatedJustNow) {
  Answers earlier = look(0);
  Answers later = look(2.5);
  earlier.unmatched = {record({{"subscription", "1/1/1"}}), record({{"subscription", "1/1/2"}})};
  later.unmatched = {record({{"subscription", "1/1/2"}}), record({{"subscription", "1/1/3"}})};
  const Answers both = steady(earlier, later);
  ASSERT_EQ(both.unmatched.size(), 1U);
  EXPECT_EQ(both.unmatched[0]["subscription"], "1/1/2");
}

TEST(Steady, LeavesOutWhatAParticipantDidNotSayBefore) {
  Answers earlier = look(0);
  Answers later = look(2.5);
  earlier.participants = {record({{"id", "1"}, {"ontology", "aa"}, {"hears_us", "0"}}),
                          record({{"id", "2"}, {"ontology", "aa"}})};
  later.participants = {record({{"id", "1"}, {"ontology", "aa"}, {"hears_us", "0"}}),
                        record({{"id", "2"}, {"ontology", "bb"}, {"hears_us", "0"}}),
                        record({{"id", "3"}, {"ontology", "-"}, {"hears_us", "0"}})};
  earlier.security = {record({{"participant", "1"}, {"lacks", "k"}}), record({{"participant", "2"}, {"lacks", ""}})};
  later.security = {record({{"mode", "encrypted"}}), record({{"participant", "1"}, {"lacks", "k"}}),
                    record({{"participant", "2"}, {"lacks", "k"}})};
  Answers both = steady(earlier, later);
  EXPECT_EQ(both.participants[0]["hears_us"], "0");
  EXPECT_EQ(both.participants[0]["ontology"], "aa");
  for (const std::size_t one : {1U, 2U}) {
    EXPECT_EQ(both.participants[one]["hears_us"], "") << one;
    EXPECT_EQ(both.participants[one]["ontology"], "") << one;
  }
  EXPECT_EQ(both.security[1]["lacks"], "k");
  EXPECT_EQ(both.security[2]["lacks"], "");
  earlier.status.fields.emplace_back("ontology_loading", "1");
  both = steady(earlier, later);
  EXPECT_EQ(both.participants[0]["ontology"], "") << "files are being read here";
}

TEST(Steady, BelievesThatAnInterfaceIsQuietWhereSomethingWasSentMeanwhile) {
  struct Case {
    const char* quiet_before;
    const char* sent_before;
    double at;
    bool is_quiet;
  };
  // Four intervals of two seconds; ten datagrams were sent until the later look.
  for (const Case& one : {Case{"8.1", "9", 2.5, true}, Case{"8.0", "9", 2.5, false}, Case{"8.1", "10", 2.5, false},
                          Case{"8.1", "10", 1.9, true}}) {
    Answers earlier = look(0);
    Answers later = look(one.at);
    earlier.interfaces = {record({{"name", "eth0"}, {"sent", one.sent_before}, {"quiet", one.quiet_before}})};
    later.interfaces = {record({{"name", "eth0"}, {"sent", "10"}, {"quiet", "10.5"}})};
    EXPECT_EQ(steady(earlier, later).interfaces[0]["quiet"], one.is_quiet ? "10.5" : "")
        << one.quiet_before << ' ' << one.sent_before << ' ' << one.at;
  }
  EXPECT_EQ(steady(look(0), look(2.5)).interfaces.size(), 0U);
  Answers later = look(2.5);
  later.interfaces = {record({{"name", "eth1"}, {"sent", "1"}, {"quiet", "99"}})};
  EXPECT_EQ(steady(look(0), later).interfaces[0]["quiet"], "") << "it has just come";
}

}  // namespace
}  // namespace geminga::doctor
