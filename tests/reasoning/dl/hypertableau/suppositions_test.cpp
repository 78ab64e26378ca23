// Which models of questions the base may keep.
#include "reasoning/dl/hypertableau/suppositions.hpp"

#include <gtest/gtest.h>

namespace geminga::hypertableau {
namespace {

constexpr std::size_t few_steps = 100;
constexpr std::size_t many_facts = 100;

TEST(Suppositions, HaveABranchForEachQuestionThatIsKept) {
  Suppositions suppositions(3);
  EXPECT_EQ(suppositions.current(), 0U);
  suppositions.keep();
  EXPECT_EQ(suppositions.current(), 1U);
  EXPECT_TRUE(suppositions.may_keep());
  suppositions.keep();
  EXPECT_FALSE(suppositions.may_keep()) << "the last one is for what is asked";
  EXPECT_FALSE(suppositions.may_keep_beside(few_steps, many_facts));
  EXPECT_TRUE(suppositions.is_one(2));
  EXPECT_FALSE(suppositions.is_one(3));
  suppositions.forget();
  EXPECT_EQ(suppositions.current(), 0U);
}

TEST(Suppositions, AreNotKeptBesideTheBaseWhereTooManyQuestionsWereMisled) {
  Suppositions suppositions(1000);
  suppositions.keep();
  suppositions.note_misled();
  EXPECT_TRUE(suppositions.may_keep_beside(few_steps, many_facts)) << "the first one";
  suppositions.note_misled();
  EXPECT_FALSE(suppositions.may_keep_beside(few_steps, many_facts));
  EXPECT_TRUE(suppositions.may_keep()) << "what left the base costs no model of the facts";
  for (int one = 0; one < 16; ++one) suppositions.keep();
  EXPECT_TRUE(suppositions.may_keep_beside(few_steps, many_facts));
}

TEST(Suppositions, AreNotKeptBesideTheBaseWhereAFactTakesManySteps) {
  const Suppositions suppositions(1000);
  EXPECT_TRUE(suppositions.may_keep_beside(8 * many_facts, many_facts));
  EXPECT_FALSE(suppositions.may_keep_beside(8 * many_facts + 1, many_facts));
}

}  // namespace
}  // namespace geminga::hypertableau
