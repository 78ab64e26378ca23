// Anonymous individuals of a conclusion mean "something".
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "reasoning/reasoner/argued.hpp"

namespace geminga::reasoner {
namespace {

using testing::HasSubstr;

TEST(Anonymous, SomethingOfAClassFollowsFromAnyInstanceOfIt) {
  EXPECT_EQ(answer_to("ClassAssertion(B i:a)\nSubClassOf(B A)", "ClassAssertion(A _:x)"), "yes");
  EXPECT_EQ(answer_to("SubClassOf(B A)", "ClassAssertion(A _:x)"), "no");
  EXPECT_EQ(answer_to("SubClassOf(Thing ObjectSomeValuesFrom(r A))", "ClassAssertion(A _:x)"), "yes");
}

TEST(Anonymous, ATreeHangsFromTheIndividualThatHasAName) {
  const std::string conclusion =
      "ObjectPropertyAssertion(r i:a _:x)\nObjectPropertyAssertion(s _:x _:y)\nClassAssertion(B _:y)";
  EXPECT_EQ(answer_to("ClassAssertion(ObjectSomeValuesFrom(r ObjectSomeValuesFrom(s B)) i:a)", conclusion),
            "yes, yes, yes");
  EXPECT_EQ(answer_to("ClassAssertion(ObjectSomeValuesFrom(r ObjectSomeValuesFrom(s A)) i:a)", conclusion),
            "no, no, no");
}

TEST(Anonymous, EdgesAreWalkedAgainstTheirDirectionToo) {
  EXPECT_EQ(answer_to("ObjectPropertyAssertion(r i:b i:c)\nClassAssertion(B i:b)\nClassAssertion(C i:c)",
                      "ObjectPropertyAssertion(r _:x _:y)\nClassAssertion(C _:y)\nClassAssertion(B _:x)"),
            "yes, yes, yes");
  EXPECT_EQ(answer_to("ObjectPropertyAssertion(r i:c i:b)\nClassAssertion(B i:b)\nClassAssertion(C i:c)",
                      "ObjectPropertyAssertion(r _:x _:y)\nClassAssertion(C _:y)\nClassAssertion(B _:x)"),
            "no, no, no");
}

TEST(Anonymous, ValuesLoopsAndNamesAreOfTheDescription) {
  EXPECT_EQ(answer_to("DataPropertyAssertion(d:p i:a \"1\"^x:integer)\nObjectPropertyAssertion(r i:a i:b)",
                      "DataPropertyAssertion(d:p _:x \"1\"^x:int)\nObjectPropertyAssertion(r _:x i:b)"),
            "yes, yes");
  EXPECT_EQ(answer_to("ObjectPropertyAssertion(r i:a i:a)", "ObjectPropertyAssertion(r _:x _:x)"), "yes");
  EXPECT_EQ(answer_to("ObjectPropertyAssertion(r i:a i:b)", "ObjectPropertyAssertion(r _:x _:x)"), "no");
}

TEST(Anonymous, SameIndividualsAreOne) {
  EXPECT_EQ(answer_to("ClassAssertion(A i:a)", "SameIndividual(_:x i:a)\nClassAssertion(A _:x)"), "yes, yes");
  EXPECT_EQ(answer_to("ClassAssertion(A i:a)\nClassAssertion(B i:b)",
                      "SameIndividual(_:x _:y)\nClassAssertion(A _:x)\nClassAssertion(B _:y)"),
            "no, no, no");
}

TEST(Anonymous, DifferencesFromNamesAreComplements) {
  EXPECT_EQ(answer_to("ClassAssertion(A i:a)\nDifferentIndividuals(i:a i:b)",
                      "ClassAssertion(A _:x)\nDifferentIndividuals(_:x i:b)"),
            "yes, yes");
  EXPECT_EQ(answer_to("ClassAssertion(A i:a)", "ClassAssertion(A _:x)\nDifferentIndividuals(_:x i:b)"), "no, no");
}

TEST(Anonymous, GroupsThatShareNothingStandAndFallAlone) {
  EXPECT_EQ(answer_to("ClassAssertion(A i:a)", "ClassAssertion(A _:x)\nClassAssertion(B _:y)"), "yes, no");
}

TEST(Anonymous, ACycleIsUndecidedUnlessEverythingFollows) {
  const std::string cycle =
      "ObjectPropertyAssertion(r _:x _:y)\nObjectPropertyAssertion(r _:y _:z)\nObjectPropertyAssertion(r _:z _:x)";
  EXPECT_THAT(answer_to("ObjectPropertyAssertion(r i:a i:a)", cycle), HasSubstr("form a cycle"));
  EXPECT_EQ(answer_to("ClassAssertion(Nothing i:a)", cycle), "yes, yes, yes");
}

TEST(Anonymous, ATreeOfTooManyLevelsIsUndecided) {
  const auto chain = [](int length) {
    std::string facts;
    for (int at = 0; at < length; ++at)
      facts += "ObjectPropertyAssertion(r _:n" + std::to_string(at) + " _:n" + std::to_string(at + 1) + ")\n";
    return answer_to("ObjectPropertyAssertion(r i:a i:a)", facts);
  };
  EXPECT_TRUE(chain(400).starts_with("yes, yes"));
  EXPECT_THAT(chain(900), HasSubstr("too many levels"));
}

TEST(Anonymous, InThePremiseAreSomethingThatHasNoOtherName) {
  EXPECT_EQ(answer_to("ClassAssertion(A _:p)\nObjectPropertyAssertion(r i:a _:p)",
                      "ClassAssertion(ObjectSomeValuesFrom(r A) i:a)\nClassAssertion(A _:q)"),
            "yes, yes");
}

}  // namespace
}  // namespace geminga::reasoner
