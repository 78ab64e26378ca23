#include "discovery/participant/clients/answering.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "discovery/matching/matcher.hpp"
#include "discovery/participant/clients/limits.hpp"
#include "discovery/participant/clients/session.hpp"
#include "discovery/participant/knowledge/expressions.hpp"
#include "discovery/participant/knowledge/overlaps.hpp"

namespace geminga::participant {
namespace {

class AnsweringTest : public testing::Test {
 protected:
  /// The lines said since the last call.
  std::ptrdiff_t said() {
    text = session.take_outbox();
    return std::ranges::count(text, '\n');
  }

  matching::Matcher matcher;
  Expressions expressions;
  Overlaps overlaps;
  WorkMeter work{matcher, expressions, overlaps};
  Session session{env::StreamId{1}, PeerId{1}, "", ClientLimits{}};
  std::string text;
};

TEST_F(AnsweringTest, TellsALongAnswerInPiecesOfBoundedWork) {
  constexpr std::ptrdiff_t lines_in_piece = work_in_step / cost_of_answer_line;
  Answer answer{.kind = "peers", .lines = std::vector<Line>(2 * lines_in_piece + 1, Line{{"peer", "1"}}), .end = {}};
  begin_answer(session, work, 7, telling(std::move(answer)));
  EXPECT_EQ(said(), lines_in_piece);
  EXPECT_EQ(work.done(), work_in_step);
  proceed_answer(session, work);
  EXPECT_EQ(said(), lines_in_piece);
  ASSERT_TRUE(session.answering);
  proceed_answer(session, work);
  EXPECT_EQ(said(), 2);
  EXPECT_NE(text.find("7 msg end count=41"), std::string::npos) << text;
  EXPECT_FALSE(session.answering);
}

TEST_F(AnsweringTest, ChargesThePeerForWhatWasLookedAtAndNotForOtherWork) {
  Answering answering{.kind = "why", .proceed = [](Piece& piece) {
                        piece.look_at(4 * work_per_statement);
                        piece.add_work(1000);
                        return true;
                      }};
  ASSERT_EQ(session.gate.count(base::Instant{}), RateGate::Verdict::pass);
  begin_answer(session, work, 7, std::move(answering));
  EXPECT_EQ(work.done(), 4 * work_per_statement * cost_of_entry + 1000);
  std::size_t passed = 0;
  while (session.gate.count(base::Instant{}) == RateGate::Verdict::pass) ++passed;
  EXPECT_EQ(passed, ClientLimits{}.statements_per_second - 1 - 4);
}

}  // namespace
}  // namespace geminga::participant
