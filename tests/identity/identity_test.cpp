#include "geminga/identity.hpp"

#include <gtest/gtest.h>

namespace geminga {
namespace {

struct Vector {
  Identity identity;
  const char* canonical;
  Id32 id;
};

TEST(Identity, MeetsTheTestVectorsOfItsSpecification) {
  const Vector vectors[] = {
      {NumericIdentity{4717}, "4717", 4717},
      {TextIdentity{"vision"}, "vision", 807676232},
      {TextIdentity{"\xc3\x96lstand"}, "\xc3\x96lstand", 2274838804},
      {SemanticIdentity{"http://example.org/a", ""}, "<http://example.org/a>", 2331597606},
      {SemanticIdentity{"http://example.org/a", "http://example.org/b"}, "<http://example.org/a><http://example.org/b>",
       926581932},
      {SemanticIdentity{"<http://example.org/A> and (<http://example.org/r> some <http://example.org/B>)", ""},
       "(<http://example.org/A> and (<http://example.org/r> some <http://example.org/B>))", 3845069870U},
      {SemanticIdentity{"<http://example.org/A> and (<http://example.org/r> some <http://example.org/B>)",
                        "http://example.org/b"},
       "(<http://example.org/A> and (<http://example.org/r> some <http://example.org/B>))<http://example.org/b>",
       1474806827U},
  };
  for (const auto& vector : vectors) {
    EXPECT_EQ(canonical_form(vector.identity), vector.canonical);
    EXPECT_EQ(id32(vector.identity), vector.id) << vector.canonical;
  }
}

TEST(Identity, CollidingTextsHaveOneNumberAndStayDifferent) {
  const Identity one = TextIdentity{"service-3352"};
  const Identity other = TextIdentity{"service-724358"};
  EXPECT_EQ(id32(one), 0x9ddb3b5fU);
  EXPECT_EQ(id32(one), id32(other));
  EXPECT_NE(one, other);
}

TEST(Identity, IsToldToBeAnExpressionByItsBrackets) {
  EXPECT_TRUE(has_expression(Identity(SemanticIdentity{"not <http://example.org/a>", ""})));
  EXPECT_FALSE(has_expression(Identity(SemanticIdentity{"http://example.org/a", "http://example.org/b"})));
  EXPECT_FALSE(has_expression(Identity(TextIdentity{"not <http://example.org/a>"})));
  EXPECT_FALSE(has_expression(Identity(NumericIdentity{7})));
}

TEST(Identity, KindsAreNeverEqualEvenWithOneCanonicalForm) {
  const Identity text = TextIdentity{"<http://example.org/a>"};
  const Identity semantic = SemanticIdentity{"http://example.org/a", ""};
  EXPECT_EQ(canonical_form(text), canonical_form(semantic));
  EXPECT_NE(text, semantic);
}

}  // namespace
}  // namespace geminga
