// geminga::Result: what it shares with std::expected, and that each turns into the other.
#include "geminga/result.hpp"

#include <gtest/gtest.h>

#include <expected>
#include <memory>
#include <string>

namespace geminga {
namespace {

using Number = Result<int, std::string>;
using Nothing = Result<void, std::string>;

TEST(Result, HasAValueOrAnError) {
  const Number good = 3;
  EXPECT_TRUE(good);
  EXPECT_TRUE(good.has_value());
  EXPECT_EQ(*good, 3);
  EXPECT_EQ(good.value(), 3);
  EXPECT_EQ(good.value_or(4), 3);
  const Number bad = Failure(std::string("no"));
  EXPECT_FALSE(bad);
  EXPECT_EQ(bad.error(), "no");
  EXPECT_EQ(bad.value_or(4), 4);
  EXPECT_THROW(static_cast<void>(bad.value()), NoValue);
  EXPECT_NE(good, bad);
}

TEST(Result, MayHaveNothingButSuccess) {
  const Nothing good;
  EXPECT_TRUE(good);
  EXPECT_NO_THROW(good.value());
  const Nothing bad = Failure("no");
  EXPECT_FALSE(bad);
  EXPECT_THROW(bad.value(), NoValue);
}

TEST(Result, MovesWhatDoesNotCopy) {
  Result<std::unique_ptr<int>, std::string> result = std::make_unique<int>(3);
  const std::unique_ptr<int> taken = std::move(*result);
  EXPECT_EQ(*taken, 3);
  EXPECT_EQ(result->get(), nullptr);
}

TEST(Result, TellsAValueThatIsNothingFromAnError) {
  const Result<std::optional<int>, std::string> none = std::nullopt;
  EXPECT_TRUE(none);
  EXPECT_EQ(none.value(), std::nullopt);
}

Number unexpected() { return std::unexpected(std::string("no")); }
Nothing unexpected_nothing() { return std::unexpected("no"); }

TEST(Result, TurnsIntoExpectedAndBack) {
  const std::expected<int, std::string> good = Number(3);
  EXPECT_EQ(good, 3);
  const std::expected<int, std::string> bad = unexpected();
  EXPECT_EQ(bad.error(), "no");
  const std::expected<void, std::string> nothing = unexpected_nothing();
  EXPECT_FALSE(nothing);
  EXPECT_EQ(Number(good), Number(3));
  EXPECT_EQ(Number(bad).error(), "no");
  EXPECT_EQ(Nothing(nothing).error(), "no");
}

}  // namespace
}  // namespace geminga
