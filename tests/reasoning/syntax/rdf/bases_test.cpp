// Bases that are marked for raptor, and what becomes of their marks.
#include "reasoning/syntax/rdf/scan/bases.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace geminga::rdf {
namespace {

/// The marks of bases that stand one behind the other.
std::vector<Rewrite> marked(const std::vector<std::string>& iris, bool is_xml, Bases& bases) {
  std::string text;
  std::vector<BaseText> texts;
  for (const std::string& iri : iris) {
    texts.push_back({text.size(), iri.size(), iri});
    text += iri + '\n';
  }
  return bases.mark(text, texts, is_xml);
}

TEST(Bases, OfTheUsualShapesStay) {
  for (const bool is_xml : {false, true}) {
    Bases bases;
    EXPECT_TRUE(
        marked({"http://e/", "http://e/o.owl", "file:///a", "urn:a:b", "relative", "", "?q", "#"}, is_xml, bases)
            .empty());
    EXPECT_TRUE(bases.is_empty());
    std::string room;
    EXPECT_EQ(bases.restored("http://e/A", room), "http://e/A");
  }
}

TEST(Bases, AreRestoredWithTheReferenceBehindThem) {
  Bases bases;
  const auto rewrites = marked({"http://e/d/o?q&r#f", "http://cmt", "http://e/d/o?q&r"}, true, bases);
  ASSERT_EQ(rewrites.size(), 3U);
  EXPECT_EQ(rewrites[0].text, rewrites[2].text) << "one base";
  std::string room;
  const std::string mark = rewrites[0].text;
  EXPECT_TRUE(mark.starts_with("http://e/d/")) << mark;
  EXPECT_EQ(bases.restored(mark, room), "http://e/d/o?q&r");
  EXPECT_EQ(bases.restored(mark + "#A", room), "http://e/d/o?q&r#A");
  EXPECT_EQ(bases.restored(mark + "?s", room), "http://e/d/o?s");
  EXPECT_EQ(bases.restored(rewrites[1].text + "#A", room), "http://cmt#A");
  EXPECT_EQ(bases.restored("http://cmt/A", room), "http://cmt/A");
}

TEST(Bases, AreMarkedUpToALimit) {
  for (const std::size_t count : {63U, 64U, 65U}) {
    std::vector<std::string> iris;
    for (std::size_t number = 0; number < count; ++number) iris.push_back("http://host" + std::to_string(number));
    Bases bases;
    EXPECT_EQ(marked(iris, true, bases).size(), std::min<std::size_t>(count, 64));
  }
}

}  // namespace
}  // namespace geminga::rdf
