// Vocabularies with an ontology and without one, prepared for expressions and not.
#include "reasoning/vocabulary/vocabulary.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <set>

#include "reasoning/compiled/ontology.hpp"
#include "reasoning/vocabulary/explanation.hpp"
#include "reasoning/vocabulary/expression.hpp"
#include "support/written.hpp"

namespace geminga::vocabulary {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(Vocabulary, WithoutAnOntologyKnowsNoClassAndWritesNamesInFull) {
  const Vocabulary none;
  EXPECT_FALSE(none.is_loaded());
  EXPECT_EQ(none.class_count(), 0U);
  EXPECT_EQ(none.digest(), 0U);
  EXPECT_FALSE(none.find_iri("https://t.example/#Ball"));
  EXPECT_FALSE(none.is_expression("A and B"));
  EXPECT_EQ(none.short_name("https://t.example/#Ball"), "<https://t.example/#Ball>");
  EXPECT_THAT(none.gaps(), IsEmpty());
  EXPECT_EQ(none.check_expressions().error().code, ErrorCode::not_ready);
}

TEST(Vocabulary, SaysWhichClassMayHaveBeenMeant) {
  const Vocabulary robots(owl::loaded(owl::robots));
  EXPECT_EQ(robots.short_name(*robots.find("t:BallInfo")), "t:BallInfo");
  EXPECT_THAT(robots.find("t:BalInfo").error(), HasSubstr("did you mean t:BallInfo"));
}

TEST(Vocabulary, NamesTheClassesThatBeginWithAText) {
  const Vocabulary robots(owl::loaded(owl::robots));
  const auto all = robots.short_names_with("", 1000);
  EXPECT_THAT(all, testing::SizeIs(robots.class_count()));
  EXPECT_EQ(std::set<std::string>(all.begin(), all.end()).size(), all.size());
  std::vector<std::string> balls;
  std::ranges::copy_if(all, std::back_inserter(balls), [](const auto& name) { return name.starts_with("t:Ball"); });
  EXPECT_THAT(balls, testing::Contains("t:BallInfo"));
  EXPECT_EQ(robots.short_names_with("t:Ball", 1000), balls);
  EXPECT_THAT(robots.short_names_with("t", 1000), testing::IsSupersetOf(balls));
  EXPECT_THAT(robots.short_names_with("t:Ball", 1), ElementsAre(balls.front()));
  EXPECT_THAT(robots.short_names_with("t:Ball", 0), IsEmpty());
  for (const char* text : {"t:Ballx", "u:", "<https://t.example/#", "<", ":", "t::"}) {
    EXPECT_THAT(robots.short_names_with(text, 1000), testing::Each(testing::StartsWith(text))) << text;
  }
  EXPECT_THAT(Vocabulary().short_names_with("", 1000), IsEmpty());
}

TEST(Vocabulary, TellsExpressionsFromNames) {
  const Vocabulary robots(owl::loaded(owl::robots));
  EXPECT_TRUE(robots.is_expression("t:Ball and t:Shared"));
  EXPECT_TRUE(robots.is_expression("t:Ball and ("));
  EXPECT_FALSE(robots.is_expression("t:Ball"));
  EXPECT_FALSE(robots.is_expression("t:Bal"));
}

TEST(Vocabulary, ShortensTheNamesInAnExpressionAndNothingWithinQuotes) {
  const Vocabulary robots(owl::loaded(owl::robots));
  EXPECT_EQ(robots.short_expression("<https://t.example/#p> value \"<https://t.example/#x> \\\"<y>\""),
            "t:p value \"<https://t.example/#x> \\\"<y>\"");
  EXPECT_EQ(robots.short_expression("<https://t.example/#d> some integer[< 3]"), "t:d some integer[< 3]");
}

TEST(Vocabulary, PlacesExpressionsOnceItIsPrepared) {
  const Vocabulary robots(owl::loaded(owl::robots));
  EXPECT_FALSE(robots.is_prepared());
  const Vocabulary prepared = robots.with_expressions();
  EXPECT_FALSE(robots.is_prepared());
  EXPECT_TRUE(prepared.has_ontology_of(robots));
  ASSERT_TRUE(prepared.check_expressions());
  const auto read = prepared.read("t:Shared and t:BallInfo", max_expression_bytes);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->canonical(), "<https://t.example/#BallInfo> and <https://t.example/#Shared>");
  const Place place = prepared.place(*read);
  EXPECT_TRUE(prepared.is_above(place, *prepared.find("t:SharedBallInfo")));
  EXPECT_EQ(prepared.distance_down(place, *prepared.find("t:SharedBallInfo")), 1U);
  EXPECT_EQ(prepared.distance_up(place, *prepared.find("t:TrackedObject")), 2U);
}

TEST(Vocabulary, RefusesAnExpressionThatIsTooLargeOrCannotBeRead) {
  const Vocabulary robots = Vocabulary(owl::loaded(owl::robots)).with_expressions();
  const std::string text = "t:Shared and t:BallInfo";
  EXPECT_TRUE(robots.read(text, text.size()));
  EXPECT_EQ(robots.read(text, text.size() - 1).error().code, ErrorCode::too_large);
  EXPECT_EQ(robots.read("t:Shared and", max_expression_bytes).error().code, ErrorCode::impossible);
}

TEST(Vocabulary, LivesAsLongAsOneOfItsCopies) {
  Vocabulary copy;
  {
    const Vocabulary first(owl::loaded(owl::robots));
    copy = first.with_expressions();
  }
  EXPECT_TRUE(copy.read("t:Shared and t:BallInfo", max_expression_bytes));
  EXPECT_EQ(copy.iri(*copy.find("t:Ball")), "https://t.example/#Ball");
}

TEST(Vocabulary, FindsTermsByPrefixAndIriAndByNothingElse) {
  const Vocabulary robots(owl::loaded(owl::robots));
  for (const char* name : {"t:Ball", "<https://t.example/#Ball>", "https://t.example/#Ball"})
    EXPECT_EQ(robots.find_term(name), *robots.find("t:Ball")) << name;
  for (const char* name : {"", "<", "<>", "<t:Ball>", "t:", "t:Bal", "u:Ball", "Ball", ":Ball"})
    EXPECT_FALSE(robots.find_term(name)) << name;
  EXPECT_FALSE(Vocabulary().find_term("t:Ball"));
}

TEST(Vocabulary, ExplainsWhatIsSubsumedAndWhatIsNot) {
  const Vocabulary robots(owl::loaded(owl::robots));
  const auto why = robots.explain(*robots.find("t:SharedBallInfo"), *robots.find("t:TrackedObject"));
  ASSERT_TRUE(why);
  EXPECT_TRUE(why->is_subsumed);
  EXPECT_EQ(why->axioms.size(), 2U);
  EXPECT_THAT(why->missing, IsEmpty());
  const auto why_not = robots.explain(*robots.find("t:BallInfo"), *robots.find("t:Shared"));
  ASSERT_TRUE(why_not);
  EXPECT_FALSE(why_not->is_subsumed);
  EXPECT_THAT(why_not->common, ElementsAre(*robots.find("t:Info")));
}

TEST(OntologyMark, IsOfOneReadingAndKeepsNothingAlive) {
  const auto read = [] { return std::make_shared<const compiled::Ontology>(owl::loaded(owl::robots)); };
  std::weak_ptr<const compiled::Ontology> watched;
  OntologyMark mark;
  EXPECT_TRUE(mark.is_of(Vocabulary()));
  {
    const auto ontology = read();
    watched = ontology;
    mark = OntologyMark(Vocabulary(ontology));
    EXPECT_TRUE(mark.is_of(Vocabulary(ontology)));
    EXPECT_TRUE(mark.is_of(Vocabulary(ontology).with_expressions()));
    EXPECT_FALSE(mark.is_of(Vocabulary(read())));
  }
  EXPECT_TRUE(watched.expired());
  EXPECT_FALSE(mark.is_of(Vocabulary()));
}

}  // namespace
}  // namespace geminga::vocabulary
