// Degrees of match of identities, by a table of pairs.
#include "discovery/matching/degrees/degree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "discovery/matching/degrees/representation.hpp"
#include "discovery/matching/taxonomy.hpp"

namespace geminga::matching {
namespace {

using enum Degree;

std::optional<Match> degree_of(const Identity& offered, const Identity& requested,
                               const vocabulary::Vocabulary& ontology) {
  return degree_of_identity({offered, classes_of(offered, ontology)}, {requested, classes_of(requested, ontology)},
                            ontology);
}

struct Case {
  Identity offered;
  Identity requested;
  std::optional<Match> wanted;
};

void expect_all(const std::vector<Case>& cases, const vocabulary::Vocabulary& ontology) {
  for (const auto& [offered, requested, wanted] : cases) {
    const auto got = degree_of(offered, requested, ontology);
    EXPECT_EQ(got.has_value(), wanted.has_value()) << canonical_form(offered) << " for " << canonical_form(requested);
    if (got && wanted) {
      EXPECT_EQ(got->degree, wanted->degree) << canonical_form(offered) << " for " << canonical_form(requested);
      EXPECT_EQ(got->distance, wanted->distance) << canonical_form(offered) << " for " << canonical_form(requested);
    }
  }
}

TEST(Degree, FollowsSubsumptionBetweenConcepts) {
  const auto ontology = soccer();
  expect_all({{semantic("Ball"), semantic("Ball"), Match{exact, 0}},
              {semantic("Sphere"), semantic("Ball"), Match{equivalent, 0}},
              {semantic("Ball"), semantic("Sphere"), Match{equivalent, 0}},
              {semantic("OwnBall"), semantic("Ball"), Match{narrower, 1}},
              {semantic("OwnBall"), semantic("Sphere"), Match{narrower, 1}},
              {semantic("OwnBall"), semantic("Tracked"), Match{narrower, 2}},
              {semantic("Tracked"), semantic("OwnBall"), Match{broader, 2}},
              {semantic("Ball"), semantic("Robot"), std::nullopt}},
             ontology);
}

TEST(Degree, IsTheWeakerOfConceptAndRepresentationAndDistancesAdd) {
  const auto ontology = soccer();
  expect_all({{semantic("Ball", "Frame"), semantic("Ball", "Frame"), Match{exact, 0}},
              {semantic("Ball", "Pitch"), semantic("Ball", "FieldFrame"), Match{equivalent, 0}},
              {semantic("Sphere", "Frame"), semantic("Ball", "Frame"), Match{equivalent, 0}},
              {semantic("Ball", "FieldFrame"), semantic("Ball", "Frame"), Match{narrower, 1}},
              {semantic("Sphere", "PolarFieldFrame"), semantic("Ball", "Frame"), Match{narrower, 2}},
              {semantic("OwnBall", "PolarFieldFrame"), semantic("Tracked", "Frame"), Match{narrower, 4}},
              {semantic("OwnBall", "Frame"), semantic("Ball", "FieldFrame"), Match{broader, 2}},
              {semantic("Tracked", "FieldFrame"), semantic("Ball", "Frame"), Match{broader, 2}},
              {semantic("Ball", "Robot"), semantic("Ball", "Frame"), std::nullopt},
              {semantic("Robot", "Frame"), semantic("Ball", "Frame"), std::nullopt}},
             ontology);
}

TEST(Degree, ARequestWithoutRepresentationTakesAnyAndIsNotWeakened) {
  const auto ontology = soccer();
  expect_all({{semantic("Ball", "Frame"), semantic("Ball"), Match{exact, 0}},
              {semantic("Ball", "Unheard"), semantic("Ball"), Match{exact, 0}},
              {semantic("OwnBall", "PolarFieldFrame"), semantic("Ball"), Match{narrower, 1}}},
             ontology);
}

TEST(Degree, AnUnstatedRepresentationMeetsOnlyARequestWithoutOne) {
  const auto ontology = soccer();
  expect_all({{semantic("Ball"), semantic("Ball"), Match{exact, 0}},
              {semantic("OwnBall"), semantic("Ball"), Match{narrower, 1}},
              {semantic("Ball"), semantic("Ball", "Frame"), std::nullopt},
              {semantic("OwnBall"), semantic("Ball", "Frame"), std::nullopt}},
             ontology);
}

TEST(Degree, KindsNeverMatchAcrossButForANumberAndTheConceptWhoseHashItIs) {
  const auto ontology = soccer();
  const Identity text = TextIdentity{"<http://example.org/Ball>"};
  EXPECT_EQ(canonical_form(text), canonical_form(semantic("Ball")));
  expect_all({{text, semantic("Ball"), std::nullopt},
              {semantic("Ball"), text, std::nullopt},
              {NumericIdentity{id32(text)}, text, std::nullopt},
              {text, NumericIdentity{id32(text)}, std::nullopt},
              {NumericIdentity{id32(text)}, semantic("Ball"), Match{exact, 0}},
              {semantic("Ball"), NumericIdentity{id32(text)}, Match{exact, 0}},
              {NumericIdentity{id32(text) + 1}, semantic("Ball"), std::nullopt},
              {NumericIdentity{7}, TextIdentity{"7"}, std::nullopt}},
             ontology);
}

TEST(Degree, NumbersAndTextsMatchExactlyOrNotAtAll) {
  const auto ontology = soccer();
  expect_all({{NumericIdentity{7}, NumericIdentity{7}, Match{exact, 0}},
              {NumericIdentity{7}, NumericIdentity{8}, std::nullopt},
              {TextIdentity{"a"}, TextIdentity{"a"}, Match{exact, 0}},
              {TextIdentity{"a"}, TextIdentity{"A"}, std::nullopt},
              {TextIdentity{"service-3352"}, TextIdentity{"service-724358"}, std::nullopt}},
             ontology);
}

TEST(Degree, WhatTheOntologyDoesNotKnowMatchesExactlyOrNotAtAll) {
  const auto ontology = soccer();
  const std::vector<Case> cases{{semantic("New"), semantic("New"), Match{exact, 0}},
                                {semantic("New", "Frame"), semantic("New", "Frame"), Match{exact, 0}},
                                {semantic("New", "Frame"), semantic("New"), Match{exact, 0}},
                                {semantic("New", "FieldFrame"), semantic("New", "Frame"), std::nullopt},
                                {semantic("New"), semantic("Ball"), std::nullopt},
                                {semantic("Ball"), semantic("New"), std::nullopt},
                                {semantic("New"), semantic("New", "Frame"), std::nullopt}};
  expect_all(cases, ontology);
  expect_all(cases, {});
  expect_all({{semantic("Ball", "New"), semantic("Ball", "New"), Match{exact, 0}},
              {semantic("OwnBall", "New"), semantic("Ball", "New"), Match{narrower, 1}},
              {semantic("Ball", "New"), semantic("Ball", "Frame"), std::nullopt}},
             ontology);
  expect_all({{semantic("OwnBall"), semantic("Ball"), std::nullopt}}, {});
}

TEST(Degree, WhatCannotExistMatchesNothingButItselfExactly) {
  const auto ontology = soccer();
  expect_all({{semantic("Ghost"), semantic("Ghost"), Match{exact, 0}},
              {semantic("Ghost"), semantic("Ball"), std::nullopt},
              {semantic("Ghost"), semantic("Robot"), std::nullopt},
              {semantic("Ghost"), semantic("Phantom"), std::nullopt},
              {semantic("Ball"), semantic("Ghost"), std::nullopt},
              {semantic("Ball", "Ghost"), semantic("Ball", "Frame"), std::nullopt},
              {semantic("Ball", "Ghost"), semantic("Ball", "Ghost"), Match{exact, 0}},
              {semantic("Ghost", "FieldFrame"), semantic("Ghost", "Frame"), std::nullopt}},
             ontology);
}

TEST(Degree, EverythingThatCanExistIsAThing) {
  const auto ontology = soccer();
  const Identity thing = SemanticIdentity{std::string(owl::owl_thing), ""};
  EXPECT_EQ(degree_of(semantic("Ball"), thing, ontology)->degree, narrower);
  EXPECT_FALSE(degree_of(semantic("Ghost"), thing, ontology));
  EXPECT_FALSE(degree_of(semantic("New"), thing, ontology));
}

TEST(Degree, DistancesThatDoNotFitStayAtTheGreatest) {
  constexpr auto greatest = std::numeric_limits<std::uint32_t>::max();
  EXPECT_EQ(combined({narrower, greatest - 1}, {exact, 1}), (Match{narrower, greatest}));
  EXPECT_EQ(combined({narrower, greatest}, {broader, 1}), (Match{broader, greatest}));
}

/// Frames that convert into each other: between robot and field for 10, between polar and cartesian for 1.
vocabulary::Vocabulary frames() {
  Taxonomy taxonomy;
  taxonomy.sub("OwnBall", "Ball").sub("Field", "Frame").sub("Robot", "Frame").sub("FieldPolar", "Field");
  taxonomy.sub("RobotPolar", "Robot").sub("MyRobotPolar", "RobotPolar").sub("FieldOfPlay", "Field");
  taxonomy.convert("RobotPolar", "Robot").convert("Robot", "Field", 10).convert("Field", "FieldPolar");
  taxonomy.convert("Ghost", "FieldPolar").unsatisfiable("Ghost").convert("Robot", "Ghost");
  return taxonomy.classified();
}

std::string turned(const Identity& offered, const Identity& requested, std::uint32_t convert) {
  static const vocabulary::Vocabulary ontology = frames();
  const auto match = degree_of_identity({offered, classes_of(offered, ontology)},
                                        {requested, classes_of(requested, ontology)}, ontology, convert);
  if (!match) return "none";
  std::string words = std::string(to_string(match->degree)) + " " + std::to_string(match->distance);
  if (match->cost == 0) return words;
  const auto chain = chain_between(classes_of(offered, ontology).representation_class,
                                   classes_of(requested, ontology).representation_class, ontology);
  return words + " " + chain_words(chain.get(), ontology) + " " + std::to_string(match->cost);
}

TEST(Degree, IsConvertedWhereADeclaredChainLeadsToWhatIsAskedFor) {
  const Identity polar = semantic("Ball", "RobotPolar");
  EXPECT_EQ(turned(polar, semantic("Ball", "FieldPolar"), 0), "none");
  EXPECT_EQ(turned(polar, semantic("Ball", "FieldPolar"), 10), "none");
  // RobotPolar is below Robot, so that the first step need not be taken.
  EXPECT_EQ(turned(polar, semantic("Ball", "FieldPolar"), 11), "converted 1 :Robot>:Field>:FieldPolar 11");
  EXPECT_EQ(turned(semantic("OwnBall", "MyRobotPolar"), semantic("Ball", "Field"), any_cost),
            "converted 3 :Robot>:Field 10");
  EXPECT_EQ(turned(semantic("Ball", "Robot"), semantic("OwnBall", "FieldPolar"), any_cost),
            "broader 1 :Robot>:Field>:FieldPolar 11")
      << "broader is the weaker of the two";
}

TEST(Degree, IsConvertedOnlyWhereNothingBetterHolds) {
  EXPECT_EQ(turned(semantic("Ball", "RobotPolar"), semantic("Ball", "Robot"), any_cost), "narrower 1");
  EXPECT_EQ(turned(semantic("Ball", "Field"), semantic("Ball", "Field"), any_cost), "exact 0");
  EXPECT_EQ(turned(semantic("Ball", "Field"), semantic("Ball", "FieldPolar"), 0), "broader 1");
  EXPECT_EQ(turned(semantic("Ball", "Field"), semantic("Ball", "FieldPolar"), 1), "converted 0 :Field>:FieldPolar 1");
  EXPECT_EQ(turned(semantic("Ball", "Frame"), semantic("Ball", "FieldPolar"), any_cost), "broader 2");
  EXPECT_EQ(turned(semantic("Ball", "FieldPolar"), semantic("Ball", "FieldOfPlay"), any_cost), "none");
  EXPECT_EQ(turned(semantic("Ball"), semantic("Ball", "Field"), any_cost), "none");
  EXPECT_EQ(turned(semantic("Ball", "Robot"), semantic("Ball"), any_cost), "exact 0");
  EXPECT_EQ(turned(semantic("Ball", "Ghost"), semantic("Ball", "FieldPolar"), any_cost), "none");
  EXPECT_EQ(turned(semantic("Ball", "Robot"), semantic("Ball", "Ghost"), any_cost), "none");
  EXPECT_EQ(turned(semantic("Unknown", "Robot"), semantic("Unknown", "Field"), any_cost), "none");
  EXPECT_EQ(turned(TextIdentity{"a"}, TextIdentity{"a"}, any_cost), "exact 0");
}

TEST(Degree, StaysConvertedBesideWhateverIsCombinedWithIt) {
  const Match by_chain{converted, 1, 5, 9};
  EXPECT_EQ(combined(by_chain, {narrower, 2}), (Match{converted, 3, 5, 9}));
  EXPECT_EQ(combined({narrower, 2}, by_chain), (Match{converted, 3, 5, 9}));
  EXPECT_EQ(combined(by_chain, {broader, 2}), (Match{broader, 3, 5, 9}));
}

TEST(Degree, OrdersConvertedBeforeBroaderAndByCost) {
  const std::vector<Match> order = {{exact, 9},           {equivalent, 0},      {narrower, 1},
                                    {narrower, 2},        {converted, 5, 1, 7}, {converted, 6, 1, 3},
                                    {converted, 0, 2, 1}, {broader, 0},         {broader, 0, 3, 1}};
  EXPECT_TRUE(std::ranges::is_sorted(order));
  EXPECT_EQ(std::ranges::adjacent_find(order, std::ranges::greater_equal()), order.end());
  EXPECT_FALSE((Match{converted, 1, 1, 1} < Match{converted, 1, 1, 2}));
  EXPECT_NE((Match{converted, 1, 1, 1}), (Match{converted, 1, 1, 2}));
  EXPECT_TRUE(is_weaker(broader, converted));
  EXPECT_TRUE(is_weaker(converted, narrower));
}

}  // namespace
}  // namespace geminga::matching
