// "Why not": the nearest classes and requirements if one class is not below another.
#include "reasoning/explanation/why_not.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/random.hpp"
#include "support/reference.hpp"
#include "support/rounds.hpp"
#include "support/written.hpp"

namespace geminga::explanation {
namespace {

using compiled::Ontology;
using owl::loaded;
using owl::named;
using testing::ElementsAre;

std::vector<std::string> lines_for(std::string_view axioms, std::string_view sub, std::string_view super) {
  const Ontology ontology = loaded(axioms);
  const taxonomy::ClassNumber one = named(ontology, sub);
  const taxonomy::ClassNumber other = named(ontology, super);
  return describe(ontology, one, other, why_not(ontology, one, other));
}

std::vector<std::string> common(std::string_view axioms, std::string_view sub, std::string_view super) {
  const Ontology ontology = loaded(axioms);
  std::vector<std::string> names;
  for (const taxonomy::ClassNumber number : why_not(ontology, named(ontology, sub), named(ontology, super)).common) {
    names.push_back(ontology.short_name(number));
  }
  return names;
}

TEST(WhyNot, NamesTheMostSpecificCommonClasses) {
  constexpr std::string_view axioms =
      "SubClassOf(A B)\nSubClassOf(A C)\nSubClassOf(D B)\nSubClassOf(D C)\nSubClassOf(B E)\nSubClassOf(C E)\n"
      "SubClassOf(X Y)";
  EXPECT_THAT(common(axioms, "A", "D"), ElementsAre("t:B", "t:C"));
  EXPECT_THAT(common(axioms, "A", "X"), ElementsAre("owl:Thing"));
  EXPECT_THAT(common(axioms, "E", "A"), ElementsAre("t:E"));
  EXPECT_THAT(common("EquivalentClasses(B C)\nSubClassOf(A B)\nSubClassOf(D C)", "A", "D"), ElementsAre("t:B"));
}

TEST(WhyNot, TellsWhatOfADefinitionIsMet) {
  EXPECT_THAT(lines_for("EquivalentClasses(D ObjectIntersectionOf(B ObjectSomeValuesFrom(r C) ObjectSomeValuesFrom(s F)"
                        " G))\nSubClassOf(A B)\nSubClassOf(A ObjectSomeValuesFrom(r H))\nSubClassOf(H C)\n"
                        "SubClassOf(A ObjectSomeValuesFrom(s H))",
                        "A", "D"),
              ElementsAre("Nearest: both are t:B", "Enough to be t:D:   [written.ofn:1]", "  met      t:B",
                          "  missing  t:G", "  met      t:r some t:C",
                          "  missing  t:s some t:F   (it has t:s, but to nothing that is known to be t:F)"));
}

TEST(WhyNot, ShowsTheWayOfWhichLeastIsMissingFirst) {
  const Ontology ontology = loaded(
      "SubClassOf(ObjectIntersectionOf(P Q R) D)\nSubClassOf(ObjectIntersectionOf(B R) D)\nSubClassOf(A B)\n"
      "SubClassOf(D N)");
  const WhyNot found = why_not(ontology, named(ontology, "A"), named(ontology, "D"));
  ASSERT_EQ(found.ways.size(), 3U);
  EXPECT_EQ(found.ways[0].missing_count(), 1U);
  EXPECT_EQ(found.ways[1].missing_count(), 3U);
  EXPECT_FALSE(found.ways[2].is_sufficient);
  EXPECT_EQ(describe_briefly(ontology, named(ontology, "A"), named(ontology, "D"), found),
            "nearest: they have nothing in common but owl:Thing; to be t:D it lacks t:R");
}

TEST(WhyNot, SaysWhenOnlyBeingToldIsEnough) {
  EXPECT_THAT(lines_for("SubClassOf(D B)\nSubClassOf(A C)", "A", "D"),
              ElementsAre("Nearest: they have nothing in common but owl:Thing",
                          "No axiom says what is enough to be t:D: only what is said to be below it is",
                          "What every t:D is, too:", "  missing  t:B   [written.ofn:1]"));
}

TEST(WhyNot, SaysWhenTheTwoExcludeEachOther) {
  EXPECT_THAT(
      lines_for("SubClassOf(A B)\nSubClassOf(D C)\nDisjointClasses(B C)", "A", "D"),
      testing::IsSupersetOf({"Nothing can be t:A and t:D, because:", "  t:A SubClassOf t:B   [written.ofn:1]",
                             "  t:D SubClassOf t:C   [written.ofn:2]", "  t:B DisjointWith t:C   [written.ofn:3]"}));
}

TEST(WhyNot, SaysWhenSomethingMayHaveBeenMissed) {
  owl::Ontology source = owl::written("SubClassOf(A B)\nSubClassOf(D C)");
  EXPECT_FALSE(why_not(loaded(source), taxonomy::ClassNumber{0}, taxonomy::ClassNumber{1}).may_be_incomplete);
  source.leave_out("swrl:Imp", owl::FileId{0}, 7);
  EXPECT_TRUE(why_not(loaded(source), taxonomy::ClassNumber{0}, taxonomy::ClassNumber{1}).may_be_incomplete);
}

TEST(RandomWhyNots, NeverMissEverythingOfAClassThatIsCommon) {
  int checked = 0;
  for (std::uint64_t seed = 1; seed <= test::rounds(60U); ++seed) {
    base::Random random(seed);
    const std::string text = owl::random_ontology(random, 14);
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + text);
    const Ontology ontology = loaded(text);
    for (std::uint32_t one = 0; one < ontology.class_count(); ++one) {
      for (std::uint32_t other = 0; other < ontology.class_count(); ++other) {
        const taxonomy::ClassNumber sub{one};
        const taxonomy::ClassNumber super{other};
        if (ontology.is_subsumed(sub, super)) continue;
        const WhyNot found = why_not(ontology, sub, super);
        ASSERT_FALSE(found.common.empty());
        for (const taxonomy::ClassNumber above : found.common) {
          ASSERT_TRUE(ontology.is_subsumed(sub, above) && ontology.is_subsumed(super, above));
          // No common class is below another that is listed.
          for (const taxonomy::ClassNumber more : found.common) {
            ASSERT_TRUE(more == above || !ontology.is_subsumed(more, above));
          }
        }
        for (std::uint32_t number = 0; number < ontology.class_count(); ++number) {
          const taxonomy::ClassNumber any{number};
          if (!ontology.is_subsumed(sub, any) || !ontology.is_subsumed(super, any)) continue;
          ASSERT_TRUE(std::ranges::any_of(
              found.common, [&](taxonomy::ClassNumber lowest) { return ontology.is_subsumed(lowest, any); }));
        }
        // An element that meets a sufficient set of requirements is in the class.
        for (const Way& way : found.ways) ASSERT_TRUE(!way.is_sufficient || way.missing_count() > 0);
        ++checked;
      }
    }
  }
  EXPECT_GT(checked, test::rounds(500));
}

}  // namespace
}  // namespace geminga::explanation
