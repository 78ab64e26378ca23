#include "discovery/participant/knowledge/ontology_change.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "discovery/matching/matcher.hpp"

namespace geminga::participant {
namespace {

using Due = OntologyChange::Due;

class OntologyChangeTest : public testing::Test {
 protected:
  class Log final : public base::LogSink {
   public:
    void write(base::LogLevel, std::string_view line, const base::LogFields&) override { lines.emplace_back(line); }
    std::vector<std::string> lines;
  };

  /// All that falls due until the change is over; no statement is listed.
  std::vector<Due> run() {
    std::vector<Due> due;
    while (change.is_under_way()) {
      const Due one = change.step();
      if (one == Due::restate_next) change.end_restating();
      if (one != Due::nothing) due.push_back(one);
    }
    return due;
  }

  matching::Matcher matcher;
  OntologyReading reading;
  Log log;
  OntologyChange change{matcher.editions(), matcher.vocabulary_change(), reading, log};
};

TEST_F(OntologyChangeTest, ComesIntoForceAndThenHasAllStatementsRestated) {
  change.begin({});
  EXPECT_EQ(run(), (std::vector{Due::came_into_force, Due::list_all, Due::restate_next}));
}

TEST_F(OntologyChangeTest, LetsOnlyTheLastOfThoseThatWaitFollow) {
  change.begin({});
  change.begin({});
  change.begin({});
  EXPECT_EQ(run(), (std::vector{Due::came_into_force, Due::list_all, Due::restate_next, Due::came_into_force,
                                Due::list_all, Due::restate_next}));
}

TEST_F(OntologyChangeTest, ListsOnlyAwaitedStatementsWhereTheOntologyIsPrepared) {
  change.take_up_expressions();
  EXPECT_EQ(run(), (std::vector{Due::list_awaited, Due::restate_next}));
}

TEST_F(OntologyChangeTest, MendsTheFailureOfItsOwnReadingAndNotOfALaterOne) {
  reading.begin({});
  reading.fail({"broken"}, {});
  reading.begin({});
  change.begin({});
  reading.begin({});
  static_cast<void>(run());
  EXPECT_FALSE(reading.failure.empty());
  change.begin({});
  static_cast<void>(run());
  EXPECT_TRUE(reading.failure.empty());
  EXPECT_FALSE(reading.is_loading);
  EXPECT_EQ(log.lines.size(), 1U);
}

TEST_F(OntologyChangeTest, IsGivenUpOnlyWhereNoOntologyIsThereAndNoneIsToCome) {
  change.give_up();
  EXPECT_EQ(run().size(), 3U);
  change.begin({});
  change.give_up();
  EXPECT_EQ(run().size(), 3U);
}

}  // namespace
}  // namespace geminga::participant
