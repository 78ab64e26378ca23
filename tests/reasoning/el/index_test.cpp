// An index of expressions that are made by hand: what is interned, what stands for what, and the limit of its closures.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>

#include "reasoning/el/index/index_builder.hpp"

namespace geminga::el {
namespace {

using testing::ElementsAre;

TEST(IndexBuilder, HasOneExpressionForConjunctionsOfTheSameParts) {
  IndexBuilder builder;
  const ExprId a = builder.add_atom();
  const ExprId b = builder.add_atom();
  const ExprId c = builder.add_atom();
  const ExprId both = builder.conjunction({a, b});
  EXPECT_EQ(builder.conjunction({b, top_expr, a, a}), both);
  EXPECT_EQ(builder.conjunction({both, c}), builder.conjunction({c, b, a}));
  EXPECT_EQ(builder.conjunction({a}), a);
  EXPECT_EQ(builder.conjunction({}), top_expr);
  EXPECT_EQ(builder.conjunction({both, bottom_expr}), bottom_expr);
  EXPECT_EQ(builder.existential(builder.roles().add(), bottom_expr), bottom_expr);
}

TEST(IndexedOntology, HasOneRepresentativeForToldEquivalents) {
  IndexBuilder builder;
  const ExprId a = builder.add_atom();
  const ExprId b = builder.add_atom();
  const ExprId above = builder.add_atom();
  builder.add_told(a, b);
  builder.add_told(b, a);
  builder.add_told(b, above);
  const auto index = builder.finish(100);
  ASSERT_TRUE(index);
  EXPECT_EQ(index->representative(b), a);
  EXPECT_THAT(index->told_atoms(a), ElementsAre(above));
  EXPECT_TRUE(index->is_told_below(a, above));
  EXPECT_FALSE(index->is_told_below(above, a));
  EXPECT_TRUE(index->needs_no_context(a)) << "it has no rule";
}

TEST(IndexedOntology, FilesARuleUnderTheExpressionThatItWaitsFor) {
  IndexBuilder builder;
  const ExprId a = builder.add_atom();
  const ExprId b = builder.add_atom();
  const ExprId c = builder.add_atom();
  const RoleId role = builder.roles().add();
  builder.add_told(a, builder.existential(role, b));
  const ExprId both = builder.conjunction({b, c});
  builder.mark_negative(both);
  builder.add_told(both, bottom_expr);
  const auto index = builder.finish(100);
  ASSERT_TRUE(index);
  ASSERT_EQ(index->links(a).size(), 1U);
  EXPECT_EQ(index->links(a)[0].target, b);
  ASSERT_EQ(index->conjunctions(c).size(), 1U);
  EXPECT_EQ(index->conjunctions(c)[0].partner, b);
  EXPECT_EQ(index->conjunctions(c)[0].conjunction, both);
  EXPECT_TRUE(index->is_told_bottom(both));
  EXPECT_TRUE(index->has_rules(b, RuleBits::conjunctions));
  EXPECT_FALSE(index->has_rules(a, RuleBits::conjunctions));
}

TEST(IndexBuilder, GivesNoIndexWhereAClosureIsOverTheLimit) {
  for (const std::size_t most : {5U, 6U, 7U}) {
    IndexBuilder builder;
    const RoleId low = builder.roles().add();
    const RoleId middle = builder.roles().add();
    const RoleId high = builder.roles().add();
    builder.roles().add_sub_role(low, middle);
    builder.roles().add_sub_role(middle, high);
    EXPECT_EQ(builder.finish(most).has_value(), most >= 6) << "of three roles, each below itself: " << most;
  }
}

}  // namespace
}  // namespace geminga::el
