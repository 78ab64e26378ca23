// Values that are kept once, and values that are seldom there.
#include "base/shared_values.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/rare.hpp"

namespace geminga::base {
namespace {

using Texts = SharedValues<int, std::string>;

std::shared_ptr<const std::string> share(Texts& texts, int key, const std::string& text) {
  return texts.share(key, [&](const std::string& known) { return known == text; }, [&] { return text; });
}

TEST(SharedValues, GiveOneForEqualOnesOfOneKeyWhileSomebodyHasIt) {
  Texts texts;
  const auto first = share(texts, 1, "a");
  EXPECT_EQ(share(texts, 1, "a"), first);
  EXPECT_NE(share(texts, 2, "a"), first);
  const auto other = share(texts, 1, "b");
  EXPECT_EQ(*other, "b");
  EXPECT_EQ(*first, "a") << "what somebody has does not change";
}

TEST(SharedValues, KeepNothingAliveAndForgetItsKey) {
  Texts texts;
  const auto kept = share(texts, -1, "kept");
  for (int key = 0; key < 5000; ++key) (void)share(texts, key, "gone");
  EXPECT_LT(texts.size(), 1100U);
  EXPECT_EQ(share(texts, -1, "kept"), kept);
}

TEST(Rare, CopiesItsValueAndTakesThePlaceOfAPointer) {
  static_assert(sizeof(Rare<std::string>) == sizeof(void*));
  Rare<std::string> none;
  EXPECT_FALSE(none);
  Rare<std::string> one(std::string("a"));
  Rare<std::string> copy = one;
  *copy += "b";
  EXPECT_EQ(*one, "a");
  EXPECT_EQ(*copy, "ab");
  copy = none;
  EXPECT_FALSE(copy);
  EXPECT_EQ(copy.made(), "");
  one.reset();
  EXPECT_FALSE(one);
}

}  // namespace
}  // namespace geminga::base
