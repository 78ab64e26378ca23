// The context order, as section 4 of the paper wants it.
#include "reasoning/dl/consequence/rules/literal.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace geminga::consequence {
namespace {

constexpr Term f = successor(0);
constexpr Term g = successor(1);

TEST(Literal, IsOrderedByItsGreatestTermFirst) {
  EXPECT_LT(y_term, x_term);
  EXPECT_LT(x_term, f);
  EXPECT_LT(f, g);
  EXPECT_LT(unary(9, x_term), unary(0, f));
  EXPECT_LT(unary(9, f), equality(g, f, false));
}

TEST(Literal, IsAboveWhatIsLeftWithASmallerTerm) {
  for (const std::uint32_t predicate : {0U, 7U, 0xffffffffU}) {
    EXPECT_GT(unary(predicate, g), unary(predicate, f));
    EXPECT_GT(unary(predicate, f), unary(predicate, x_term));
    EXPECT_GT(unary(predicate, x_term), unary(predicate, y_term));
    for (const bool is_incoming : {false, true}) {
      EXPECT_GT(binary(predicate, g, is_incoming), binary(predicate, f, is_incoming));
      EXPECT_GT(binary(predicate, f, is_incoming), binary(predicate, x_term, is_incoming));
      EXPECT_GT(binary(predicate, x_term, is_incoming), binary(predicate, y_term, is_incoming));
    }
  }
}

TEST(Literal, OfThePredecessorIsBelowAllOthers) {
  const std::vector<Literal> passed{unary(0xffffffffU, y_term), binary(0xffffffffU, y_term, true),
                                    binary(0xffffffffU, y_term, false), equality(x_term, y_term, false)};
  for (const Literal literal : passed) {
    EXPECT_TRUE(is_of_predecessor(literal));
    EXPECT_LT(literal, unary(0, x_term));
    EXPECT_LT(literal, equality(f, y_term, false));
  }
  EXPECT_FALSE(is_of_predecessor(unary(0, x_term)));
  EXPECT_FALSE(is_of_predecessor(equality(f, y_term, false)));
}

TEST(Literal, OfAnEqualityIsBelowThatOfItsOpposite) {
  EXPECT_LT(equality(f, g, false), equality(f, g, true));
  EXPECT_EQ(equality(f, g, false), equality(g, f, false));
}

TEST(Literal, IsTheSameAfterGoingToTheSuccessorAndBack) {
  for (const Literal literal : {unary(3, f), binary(4, f, false), binary(4, f, true)}) {
    EXPECT_EQ(seen_by_predecessor(seen_by_successor(literal), f), literal);
  }
  EXPECT_EQ(seen_by_predecessor(unary(3, y_term), f), unary(3, x_term));
  EXPECT_EQ(seen_by_predecessor(equality(x_term, y_term, false), f), equality(f, x_term, false));
}

TEST(Literal, OfAThingAndItselfHasNoDirection) {
  EXPECT_EQ(binary(5, x_term, true), binary(5, x_term, false));
  EXPECT_EQ(binary(5, x_term, true).kind(), LiteralKind::reflexive);
}

}  // namespace
}  // namespace geminga::consequence
