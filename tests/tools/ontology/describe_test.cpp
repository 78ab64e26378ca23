// The facts about geminga:self as one class expression, and what such an expression cannot say.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tools/ontology/program.hpp"

namespace geminga::ontology {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// In the lines behind the first, which has the prefixes.
constexpr const char* words =
    "@prefix g: <https://geminga.example/core#> .\n"
    ":has a owl:ObjectProperty . :partOf a owl:ObjectProperty . :kg a owl:DatatypeProperty . :Robot a owl:Class .\n";

class Describe : public testing::Test {
 protected:
  Describe() { program_.turtle("words.ttl", words); }
  /// The outcome for these facts, which begin on line 3.
  Outcome described(const std::string& facts) const {
    program_.turtle("robot.ttl", "@prefix g: <https://geminga.example/core#> .\n" + facts);
    return program_.run({"describe", "robot.ttl", "words.ttl"});
  }
  const Program program_;
};

TEST_F(Describe, MakesConjunctsOfClassesAndRestrictionsOfFactsNestedAsDeepAsTheyGo) {
  const Outcome outcome = described(
      "g:self a :Robot , owl:NamedIndividual ; :kg 5.0 ;\n"
      "  :has :arm , [ a :Mast ; :has [ a [ owl:onProperty :has ; owl:someValuesFrom :Lens ; a owl:Restriction ] ] ] "
      ".\n"
      ":arm :kg 1.5 ; rdfs:label \"its arm\" .\n");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err, "");
  const std::string decimal = "\"^^<http://www.w3.org/2001/XMLSchema#decimal>)";
  EXPECT_EQ(outcome.out,
            "<http://e/Robot> and (<http://e/has> some (<http://e/Mast> and (<http://e/has> some (<http://e/has> some "
            "<http://e/Lens>)))) and (<http://e/has> some (<http://e/kg> value \"1.5" +
                decimal + ") and (<http://e/kg> value \"5.0" + decimal + "\n");
}

TEST_F(Describe, CutsWhatLeadsBackAndNamesWhatItLeavesOutWithItsLine) {
  const Outcome outcome = described(
      "g:self a :Robot ; :has :a .\n"
      ":a :partOf g:self ; :has :b .\n"
      ":b :has :a .\n"
      ":other a :Robot .\n"
      "g:self owl:sameAs :other .\n"
      "[] a owl:NegativePropertyAssertion ; owl:sourceIndividual g:self ; owl:assertionProperty :kg ; owl:targetValue "
      "9 .\n"
      ":Robot rdfs:subClassOf :Thing .\n"
      "g:self :unknown :a .\n");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out,
            "<http://e/Robot> and (<http://e/has> some (<http://e/has> some <http://www.w3.org/2002/07/owl#Thing>))\n");
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("robot.ttl:4: left out: "), HasSubstr("robot.ttl:5: left out: "),
                                 HasSubstr("leads back to where it came from"), HasSubstr("robot.ttl:6: left out: "),
                                 HasSubstr("not about geminga:self"), HasSubstr("robot.ttl:7: left out: "),
                                 HasSubstr("an expression cannot say it"), HasSubstr("robot.ttl:8: left out: "),
                                 HasSubstr("robot.ttl:9: left out: "), HasSubstr("it is no fact"),
                                 HasSubstr("robot.ttl:10: left out: "), HasSubstr("unknown is declared in no file")));
}

TEST_F(Describe, FollowsFromTheFacts) {
  // The reasoner proves that geminga:self is an instance of the expression, by the facts and the ontology alone.
  const Outcome outcome = described(
      "g:self a :Robot ; :has :a , :b ; :kg 2 .\n:a a :Arm ; :has :b .\n:b a [ owl:unionOf ( :X :Y ) ] ; :partOf :a "
      ".\n");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::string expression = outcome.out.substr(0, outcome.out.size() - 1);
  const Outcome instances = program_.run({"instances", "robot.ttl", "words.ttl", expression});
  EXPECT_EQ(instances.status, 0) << expression << instances.err;
  EXPECT_THAT(instances.out, HasSubstr("self")) << expression;
}

TEST_F(Describe, SaysHowLargeAnExpressionIsThatCannotBeAnnouncedAndWhatToDrop) {
  const auto of_size = [&](std::size_t octets) {
    // not <http://e/C...>
    return described("g:self a [ a owl:Class ; owl:complementOf :" + std::string(octets - 15, 'C') + " ] .\n");
  };
  for (const std::size_t octets : {639UL, 640UL}) {
    const Outcome fits = of_size(octets);
    EXPECT_EQ(fits.status, 0) << fits.err;
    EXPECT_EQ(fits.out.size(), octets + 1);
  }
  const Outcome large = of_size(641);
  EXPECT_EQ(large.status, 2);
  EXPECT_EQ(large.out, "");
  EXPECT_THAT(large.err, AllOf(HasSubstr("robot.ttl: the facts make an expression of 641 octets"), HasSubstr("640"),
                               HasSubstr("the largest are not e:CCC"), HasSubstr("(641)")));
}

TEST_F(Describe, BoundsChainsOfFactsThatGrowWithoutEnd) {
  std::string ladder = "g:self :has :a0 , :b0 .\n";
  for (int i = 0; i < 30; ++i) {
    const std::string next = std::to_string(i + 1);
    for (const char* side : {":a", ":b"}) {
      ladder += side + std::to_string(i) + " :has :a" + next + " , :b" + next + " .\n";
    }
  }
  const Outcome outcome = described(ladder);
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.err, HasSubstr("take more than 4096 steps"));
}

TEST_F(Describe, SaysWhatIsWrongWithAFile) {
  const Outcome broken = described("g:self a :Robot\n:a a :Robot .\n");
  EXPECT_EQ(broken.status, 2);
  EXPECT_THAT(broken.err, HasSubstr("robot.ttl:4"));
  const Outcome silent = described(":a a :Robot .\n");
  EXPECT_EQ(silent.status, 2);
  EXPECT_THAT(silent.err, HasSubstr("robot.ttl: says nothing of <https://geminga.example/core#self>"));
  EXPECT_EQ(described("g:self a owl:Thing .\n").status, 2);
  EXPECT_EQ(program_.run({"describe", "nowhere.ttl"}).status, 2);
  EXPECT_EQ(program_.run({"describe", "."}).status, 2) << "a folder has many files";
}

TEST_F(Describe, ReadsEverySyntax) {
  const std::string expected = "<http://e/Robot> and (<http://e/has> some <http://e/Arm>)\n";
  program_.write("robot.ofn",
                 "Prefix(:=<http://e/>)\nOntology(\nClassAssertion(:Robot <https://geminga.example/core#self>)\n"
                 "ObjectPropertyAssertion(:has <https://geminga.example/core#self> :a)\nClassAssertion(:Arm :a)\n)\n");
  EXPECT_EQ(program_.run({"describe", "robot.ofn"}).out, expected) << "it says itself what a property is";
  program_.write("robot.omn",
                 "Prefix: : <http://e/>\nOntology: <http://e/o>\nObjectProperty: :has\nClass: :Robot\nClass: :Arm\n"
                 "Individual: <https://geminga.example/core#self>\n    Types: :Robot\n    Facts: :has :a\n"
                 "Individual: :a\n    Types: :Arm\n");
  EXPECT_EQ(program_.run({"describe", "robot.omn"}).out, expected);
}

TEST_F(Describe, TheShippedExampleIsDescribedByTheShippedOntologies) {
  const Outcome outcome = program_.run({"describe", GEMINGA_SOURCE_DIR "/examples/facts/robot.ttl", shipped()});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(outcome.out, AllOf(StartsWith("<https://geminga.example/capability#Robot> and ("),
                                 HasSubstr("value \"2.5\""), Not(HasSubstr("robot7"))));
}

}  // namespace
}  // namespace geminga::ontology
