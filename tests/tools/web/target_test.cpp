// Targets of requests.
#include "web/site/target.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "web/site/limits.hpp"

namespace geminga::web {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

TEST(Target, IsAPathAndParameters) {
  const auto target = read_target("/api/match?concept=soccer:BallInfo&where=rate%20%3E%3D+30&limit=3");
  ASSERT_TRUE(target);
  EXPECT_EQ(target->path, "/api/match");
  EXPECT_THAT(target->parameters,
              ElementsAre(Pair("concept", "soccer:BallInfo"), Pair("where", "rate >= 30"), Pair("limit", "3")));
  EXPECT_THAT(read_target("/metrics")->parameters, IsEmpty());
  EXPECT_THAT(read_target("/api/services?unused")->parameters, ElementsAre(Pair("unused", "")));
  EXPECT_EQ(read_target("/api/services?text=%C3%A4")->parameters.front().second, "ä");
}

TEST(Target, StaysAPathWhateverIsInIt) {
  EXPECT_EQ(read_target("/../../etc/passwd")->path, "/../../etc/passwd");
  EXPECT_EQ(read_target("/%2e%2e%2fetc")->path, "/../etc");
}

TEST(Target, IsNothingElse) {
  for (const char* text :
       {"", "*", "metrics", "http://localhost/metrics", "/a b", "/%", "/%zz", "/a\\b", "/a#b", "localhost:80"}) {
    EXPECT_FALSE(read_target(text)) << text;
  }
}

TEST(Target, HasNoControlCharactersAndNoBrokenUtf8) {
  for (const char* text :
       {"/%00", "/a?x=%00", "/a?x%00=1", "/a?x=%0d%0a", "/a?x=%1b", "/a?x=%7f", "/a?x=%ff", "/%c3"}) {
    EXPECT_FALSE(read_target(text)) << text;
  }
}

TEST(Target, HasSoManyParameters) {
  for (const int beyond : {-1, 0, 1}) {
    std::string text = "/a?x";
    for (std::size_t i = 1; i < max_target_parameters + static_cast<std::size_t>(beyond); ++i) text += "&x";
    EXPECT_EQ(read_target(text).has_value(), beyond <= 0) << beyond;
  }
}

}  // namespace
}  // namespace geminga::web
