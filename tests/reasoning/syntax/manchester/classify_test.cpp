// The places of expressions: each construct and each trap.
#include <gtest/gtest.h>

#include "place.hpp"
#include "support/written.hpp"

namespace geminga::manchester {
namespace {

constexpr std::string_view sensors =
    "SubClassOf(Camera Sensor)\n"
    "SubClassOf(BallCamera ObjectIntersectionOf(Camera ObjectSomeValuesFrom(observes Ball)))\n"
    "SubClassOf(RedBallCamera ObjectIntersectionOf(Camera ObjectSomeValuesFrom(observes RedBall)))\n"
    "SubClassOf(Lidar Sensor)\n"
    "SubClassOf(RedBall Ball)\n"
    "SubClassOf(Ball Thing)\n"
    "EquivalentClasses(BallWatcher ObjectSomeValuesFrom(observes Ball))\n"
    "DisjointClasses(Camera Lidar)\n";

TEST(Place, IsBetweenWhatIsRightAboveAndRightBelow) {
  const Asked asked(sensors);
  EXPECT_EQ(asked.place("Sensor and (observes some Ball)"), "< BallWatcher Sensor > BallCamera RedBallCamera");
  EXPECT_EQ(asked.place("Camera and (observes some RedBall)"), "< BallWatcher Camera > RedBallCamera");
  EXPECT_EQ(asked.place("observes some RedBall"), "< BallWatcher > RedBallCamera");
  EXPECT_EQ(asked.place("observes some Sensor"), "< Thing");
}

TEST(Place, OfAnEquivalentClassIsThatClass) {
  const Asked asked(sensors);
  EXPECT_EQ(asked.place("observes some Ball"), "= BallWatcher");
  EXPECT_EQ(asked.place("Camera and Sensor"), "= Camera");
  EXPECT_EQ(asked.place("Camera and owl:Thing"), "= Camera");
  EXPECT_EQ(asked.place("owl:Thing"), "= Thing");
  EXPECT_EQ(asked.place("observes min 1 Ball"), "= BallWatcher");
  EXPECT_EQ(asked.place("observes min 0"), "= Thing");
  EXPECT_EQ(asked.place("not not Lidar"), "= Lidar");
}

TEST(Place, OfWhatCanHaveNoInstanceIsNowhere) {
  const Asked asked(sensors);
  EXPECT_EQ(asked.place("Camera and Lidar"), "nothing");
  EXPECT_EQ(asked.place("observes some (Camera and Lidar)"), "nothing");
  EXPECT_EQ(asked.place("owl:Nothing"), "nothing");
  EXPECT_EQ(asked.place("Camera and not Sensor"), "nothing");
  EXPECT_EQ(asked.place("not owl:Thing"), "nothing");
  EXPECT_EQ(asked.place("BallCamera and not (observes some Ball)"), "nothing");
  EXPECT_EQ(asked.place("BallCamera and (observes max 0 Ball)"), "nothing");
}

TEST(Place, OfAUnionIsAboveEachPartAndBelowWhatAllAre) {
  const Asked asked(sensors);
  EXPECT_EQ(asked.place("BallCamera or Lidar"), "< Sensor > BallCamera Lidar");
  EXPECT_EQ(asked.place("BallCamera or RedBallCamera"), "< BallWatcher Camera > BallCamera RedBallCamera");
  EXPECT_EQ(asked.place("Camera or Sensor"), "= Sensor");
  EXPECT_EQ(asked.place("observes some (Ball or RedBall)"), "= BallWatcher");
  EXPECT_EQ(asked.place("(Camera or Lidar) and (observes some Ball)"),
            "< BallWatcher Sensor > BallCamera RedBallCamera");
  EXPECT_EQ(asked.place("Camera or (Camera and Lidar)"), "= Camera");
}

TEST(Place, OfAComplementIsAboveWhatIsDisjoint) {
  const Asked asked(sensors);
  EXPECT_EQ(asked.place("not Camera"), "< Thing > Lidar");
  EXPECT_EQ(asked.place("Sensor and not Camera"), "< Sensor > Lidar");
  EXPECT_EQ(asked.place("Sensor and not (Camera or Lidar)"), "< Sensor");
  EXPECT_EQ(asked.place("not (Camera and Lidar)"), "= Thing");
  EXPECT_EQ(asked.place("not (observes some (Camera and Lidar))"), "= Thing");
}

TEST(Place, OfAComplementIsAboveWhatIsDisjointByARuleWithAPremiseFromEach) {
  EXPECT_EQ(Asked("SubClassOf(ObjectIntersectionOf(A B) Nothing)\nDeclaration(C)\n").place("not A"), "< Thing > B");
  const Asked conjunctions(
      "SubClassOf(ObjectIntersectionOf(A B) C)\nSubClassOf(ObjectIntersectionOf(A D) E)\nDisjointClasses(C A)\n");
  EXPECT_EQ(conjunctions.place("not A"), "< Thing > B C");
  const Asked functional(
      "FunctionalObjectProperty(f)\nSubObjectPropertyOf(g f)\nSubClassOf(A ObjectSomeValuesFrom(f C))\n"
      "SubClassOf(B ObjectSomeValuesFrom(g D))\nSubClassOf(E ObjectSomeValuesFrom(f F))\nDisjointClasses(C D)\n");
  EXPECT_EQ(functional.place("not A"), "< Thing > B");
  EXPECT_EQ(functional.place("not (f some C)"), "< Thing > B");
  const Asked itself(
      "FunctionalObjectProperty(f)\nSubClassOf(A ObjectHasSelf(f))\nSubClassOf(B ObjectSomeValuesFrom(f C))\n"
      "DisjointClasses(A C)\nReflexiveObjectProperty(r)\nSubClassOf(ObjectSomeValuesFrom(r D) E)\n"
      "DisjointClasses(E C)\n");
  EXPECT_EQ(itself.place("not A"), "< Thing > B C");
  EXPECT_EQ(itself.place("not D"), "< Thing > C");
}

TEST(Place, KnowsHierarchiesChainsRangesAndDomains) {
  const Asked asked(
      "SubObjectPropertyOf(hasWheel hasPart)\nTransitiveObjectProperty(hasPart)\n"
      "SubClassOf(Car ObjectSomeValuesFrom(hasWheel Wheel))\nSubClassOf(Wheel ObjectSomeValuesFrom(hasPart Tyre))\n"
      "ObjectPropertyRange(hasPart Thingy)\nObjectPropertyDomain(hasWheel Vehicle)\nDeclaration(Rubber)\n"
      "SubClassOf(Tyre ObjectSomeValuesFrom(hasPart Rubber))\n");
  EXPECT_EQ(asked.place("hasPart some Rubber"), "< Thing > Car Tyre Wheel");
  EXPECT_EQ(asked.place("hasPart some Wheel"), "< Thing > Car");
  EXPECT_EQ(asked.place("hasWheel some Wheel"), "< Vehicle > Car");
  EXPECT_EQ(asked.place("hasPart some Thingy"), "< Thing > Car Tyre Wheel");
  EXPECT_EQ(asked.place("hasPart only Thingy"), "= Thing");
  EXPECT_EQ(asked.place("hasPart some (hasPart some owl:Thing)"), "< Thing > Car Wheel");
  EXPECT_EQ(asked.is_subsumed("hasWheel some (hasPart some Tyre)", "hasPart some Tyre"), "yes");
  EXPECT_EQ(asked.is_subsumed("hasPart some Tyre", "hasWheel some Tyre"), "no");
  EXPECT_EQ(asked.is_subsumed("hasWheel some owl:Thing", "Vehicle and (hasPart some Thingy)"), "yes");
}

TEST(Place, KnowsFunctionalProperties) {
  const Asked asked(
      "FunctionalObjectProperty(hasHead)\nSubClassOf(Robot ObjectSomeValuesFrom(hasHead Head))\n"
      "EquivalentClasses(RedHeaded ObjectSomeValuesFrom(hasHead ObjectIntersectionOf(Head Red)))\n"
      "DisjointClasses(Head Arm)\nDeclaration(Arm)\n");
  EXPECT_EQ(asked.place("Robot and (hasHead some Red)"), "< RedHeaded Robot");
  EXPECT_EQ(asked.place("Robot and (hasHead some Arm)"), "nothing");
  EXPECT_EQ(asked.place("hasHead min 2"), "nothing");
  EXPECT_EQ(asked.place("hasHead max 1 owl:Thing"), "= Thing");
}

TEST(Place, KnowsSelf) {
  const Asked asked(
      "SubClassOf(Narcissus ObjectHasSelf(loves))\nSubObjectPropertyOf(loves likes)\n"
      "EquivalentClasses(SelfLiker ObjectHasSelf(likes))\nReflexiveObjectProperty(knows)\n");
  EXPECT_EQ(asked.place("loves Self"), "< SelfLiker > Narcissus");
  EXPECT_EQ(asked.place("likes Self"), "= SelfLiker");
  EXPECT_EQ(asked.place("knows Self"), "= Thing");
  EXPECT_EQ(asked.place("Narcissus and (likes some SelfLiker)"), "= Narcissus");
}

TEST(Place, KnowsValuesAndIndividuals) {
  const Asked asked(
      "SubClassOf(Heavy DataHasValue(d:mass \"7\"^x:integer))\nSubClassOf(Light DataSomeValuesFrom(d:mass x:integer))\n"
      "SubClassOf(Mine ObjectHasValue(owner i:bob))\nClassAssertion(Person i:bob)\nDeclaration(Person)\n"
      "SubDataPropertyOf(d:mass d:quantity)\n");
  EXPECT_EQ(asked.place("mass value 7"), "< Thing > Heavy");
  EXPECT_EQ(asked.place("mass value \"7.0\"^^decimal"), "< Thing > Heavy");
  EXPECT_EQ(asked.place("mass some integer"), "< Thing > Heavy Light");
  EXPECT_EQ(asked.place("quantity some decimal"), "< Thing > Heavy Light");
  EXPECT_EQ(asked.place("mass value 8"), "< Thing");
  EXPECT_EQ(asked.is_subsumed("mass value 8", "mass some integer"), "yes");
  EXPECT_EQ(asked.is_subsumed("mass value 8.5", "mass some integer"), "no");
  EXPECT_EQ(asked.place("owner value bob"), "< Thing > Mine");
  EXPECT_EQ(asked.place("owner some Person"), "< Thing > Mine");
  EXPECT_EQ(asked.place("owner some {bob}"), "< Thing > Mine");
}

TEST(Place, FindsTheValuesWithinBounds) {
  const Asked asked(
      "SubClassOf(Two DataHasValue(d:mass \"2\"^x:integer))\nSubClassOf(Nine DataHasValue(d:mass \"9\"^x:integer))\n"
      "SubClassOf(Ten DataHasValue(d:mass \"10\"^x:integer))\nSubClassOf(Minus DataHasValue(d:mass \"-3\"^x:integer))\n"
      "SubClassOf(Part DataHasValue(d:mass \"2.5\"^x:decimal))\nSubClassOf(Less DataHasValue(d:mass "
      "\"-3.5\"^x:decimal))\n");
  EXPECT_EQ(asked.place("mass some integer[> 2]"), "< Thing > Nine Ten ?");
  EXPECT_EQ(asked.place("mass some integer[>= 2, < 10]"), "< Thing > Nine Two ?");
  EXPECT_EQ(asked.place("mass some decimal[> 2, <= 9.0]"), "< Thing > Nine Part ?");
  EXPECT_EQ(asked.place("mass some decimal[< -3]"), "< Thing > Less ?");
  EXPECT_EQ(asked.place("mass some decimal[<= -3]"), "< Thing > Less Minus ?");
  EXPECT_EQ(asked.place("mass some decimal[>= -3, < 2]"), "< Thing > Minus ?");
  EXPECT_EQ(asked.place("mass some integer[> 10]"), "< Thing ?");
  EXPECT_EQ(asked.is_subsumed("mass value 2.4", "mass some decimal[> 2]"), "no?") << "of a value of the ontology only";
}

TEST(Place, IsExactWhereIndividualsDecide) {
  // The king is the only one on the throne, and he is bald.
  const Asked asked(
      "SubClassOf(Enthroned ObjectOneOf(i:king))\nClassAssertion(Bald i:king)\nDeclaration(Crowned)\n"
      "SubClassOf(Court ObjectSomeValuesFrom(has ObjectIntersectionOf(Enthroned Crowned)))\n"
      "SubClassOf(ObjectIntersectionOf(Bald Crowned) Marked)\nSubClassOf(Marked Known)\n");
  EXPECT_EQ(asked.place("Enthroned and Crowned"), "< Crowned Enthroned Marked");
  EXPECT_EQ(asked.place("has some Enthroned"), "< Thing > Court");
  EXPECT_EQ(asked.place("{king} and Crowned"), "< Bald Crowned Marked");
  EXPECT_EQ(asked.place("Court and (has some Marked)"), "= Court");
}

TEST(Place, SaysWhereItMayMissSomething) {
  const Asked asked(sensors);
  EXPECT_EQ(asked.place("observes only Ball"), "< Thing ?");
  EXPECT_EQ(asked.place("inverse observes some Camera"), "< Thing ?");
  EXPECT_EQ(asked.place("observes min 2 Ball"), "< BallWatcher ?");
  EXPECT_EQ(asked.place("Camera and (observes max 3 Ball)"), "< Camera ?");
  EXPECT_EQ(asked.place("(observes only RedBall) and (observes some Ball)"), "< BallWatcher ?");
  EXPECT_EQ(asked.place("Camera and not (Camera and not (observes some Ball))"), "< Camera ?");
  EXPECT_EQ(asked.is_subsumed("(observes only RedBall) and (observes some Ball)", "observes some RedBall"), "yes");
  const Asked beyond("SubClassOf(A ObjectUnionOf(B C))\nSubClassOf(B D)\nSubClassOf(C D)\n");
  EXPECT_EQ(beyond.place("A"), "= A");
  EXPECT_EQ(beyond.place_of("B or D").gaps, std::vector<std::string>{});
  EXPECT_EQ(beyond.place_of("A and B").gaps, std::vector<std::string>{"owl:unionOf"});
}

TEST(Place, OfAUnionWithAComplementMayBeHigherThanItSays) {
  EXPECT_EQ(Asked(sensors).place("(Camera and Sensor) or (Camera and not Sensor)"), "= Camera");
  const std::string place = Asked(sensors).place("(Sensor and BallWatcher) or (Sensor and not BallWatcher)");
  EXPECT_TRUE(place == "= Sensor" || place.ends_with('?')) << place;
}

TEST(Place, IsTheTaxonomysWhereThatKnowsMore) {
  // An axiom that the rules do not use, and a class that is below another by it in the taxonomy of a stronger engine.
  owl::Ontology source = owl::written(
      "SubClassOf(A ObjectUnionOf(B C))\nSubClassOf(B D)\nSubClassOf(C D)\nSubClassOf(E ObjectSomeValuesFrom(r A))\n"
      "EquivalentClasses(F ObjectSomeValuesFrom(r D))\n");
  source.add(owl::AxiomKind::sub_class_of,
             {source.named_class("https://t.example/#A"), source.named_class("https://t.example/#D")}, owl::FileId{0},
             9);
  EXPECT_EQ(Asked(source).place("r some A"), "< F > E ?");
}

TEST(Place, OfTheSameExpressionInOtherWordsIsTheSame) {
  const Asked asked(sensors);
  const auto one = asked.place_of("Sensor and (observes some Ball)");
  EXPECT_EQ(one, asked.place_of("(observes some Ball) and Sensor and (observes some owl:Thing)"));
  EXPECT_EQ(one, asked.place_of("Sensor and BallWatcher"));
}

TEST(Distance, IsThatOfAClassInThePlace) {
  const Asked asked(sensors);
  const auto place = asked.place_of("Sensor and (observes some Ball)");
  const auto number = [&](std::string_view name) { return owl::named(asked.ontology(), name); };
  EXPECT_EQ(placement::distance_up(place, number("Sensor"), asked.ontology()), 1U);
  EXPECT_EQ(placement::distance_up(place, *asked.ontology().find_iri(owl::owl_thing), asked.ontology()), 2U);
  EXPECT_EQ(placement::distance_up(place, number("Camera"), asked.ontology()), std::nullopt);
  EXPECT_EQ(placement::distance_down(place, number("BallCamera"), asked.ontology()), 1U);
  EXPECT_EQ(placement::distance_down(place, number("Lidar"), asked.ontology()), std::nullopt);
  const auto same = asked.place_of("Camera and Sensor");
  EXPECT_EQ(placement::distance_up(same, number("Camera"), asked.ontology()), 0U);
  EXPECT_EQ(placement::distance_down(same, number("BallCamera"), asked.ontology()), 1U);
}

TEST(Base, IsRefusedBeyondItsLimits) {
  const compiled::Ontology ontology = owl::loaded(sensors);
  placement::ExpressionLimits limits;
  limits.axioms = 8;
  EXPECT_TRUE(placement::ExpressionClassifier::build(ontology, limits));
  limits.axioms = 7;
  const auto refused = placement::ExpressionClassifier::build(ontology, limits);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().text,
            "the ontology has 8 axioms, and class expressions are possible with at most 7: name a class instead");
  limits = {};
  limits.conclusions = 3;
  EXPECT_FALSE(placement::ExpressionClassifier::build(ontology, limits));
  EXPECT_FALSE(placement::ExpressionClassifier::build(owl::loaded("ClassAssertion(Nothing i:a)\n")));
}

TEST(Base, DoesNotGrowByTenThousandQuestions) {
  const Asked asked(sensors);
  const std::size_t contexts = asked.classifier().context_count();
  const auto first = asked.place_of("Camera and (observes some Ball)");
  for (int turn = 0; turn < 10'000; ++turn) {
    const std::string number = std::to_string(turn);
    const auto read = parse("Camera and (observes min " + number + " Ball)", asked.names());
    ASSERT_TRUE(read);
    (void)asked.classifier().classify(read->source, read->term);
  }
  EXPECT_EQ(asked.classifier().context_count(), contexts);
  EXPECT_EQ(asked.place_of("Camera and (observes some Ball)"), first);
}

TEST(Work, OverTheLimitLeavesAGapAndNothingWrong) {
  placement::ExpressionLimits limits;
  limits.work = 2;
  const Asked asked(sensors, limits);
  EXPECT_EQ(asked.place("Camera and (observes some (RedBall and Lidar))").back(), '?');
  limits = {};
  limits.parts = 2;
  const Asked few(sensors, limits);
  EXPECT_EQ(few.place("Camera or Lidar"), "< Sensor > Camera Lidar");
  EXPECT_EQ(few.place("Camera or Lidar or Ball"), "< Thing > Ball Camera Lidar ?");
}

}  // namespace
}  // namespace geminga::manchester
