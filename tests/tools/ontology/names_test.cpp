// The commonest typing errors in an ontology.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/json.hpp>

#include "tools/ontology/program.hpp"

namespace geminga::ontology {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Declared classes and properties, as editors write them.
constexpr std::string_view declared =
    "@prefix xsd: <http://www.w3.org/2001/XMLSchema#> . :BallInfo a owl:Class ; rdfs:label \"ball\" . :Robot a "
    "owl:Class .\n"
    ":observes a owl:ObjectProperty .\n";

Outcome check(const std::string& more) {
  const Program program;
  program.turtle("a.ttl", std::string(declared) + more);
  return program.run({"check", "a.ttl"});
}

TEST(Names, AClassThatIsOneLetterOffIsAProblemWithItsLikelyMeaning) {
  const Outcome outcome = check(":Mine a owl:Class ;\n  rdfs:subClassOf :BallInf .\n");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out, HasSubstr("e:BallInf  (class): did you mean e:BallInfo?   [a.ttl:5]"));
}

TEST(Names, AMistypedWordOfAReservedVocabularyIsAProblemWithItsLikelyMeaning) {
  Outcome outcome = check(":Mine a owl:Class ;\n  rdfs:subClasOf :BallInfo .\n");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out, HasSubstr("rdfs:subClasOf: did you mean rdfs:subClassOf?   [a.ttl:5]"));
  outcome = check(":Mine a owl:Clas .\n");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out, HasSubstr("owl:Clas: did you mean owl:Class"));
  outcome = check(":rate a owl:DatatypeProperty ; rdfs:range xsd:interger .\n");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out, HasSubstr("xsd:interger: did you mean xsd:integer"));
  outcome = check(":Mine a owl:Class ; owl:subClassOf :BallInfo .\n");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out, HasSubstr("owl:subClassOf: did you mean rdfs:subClassOf"));
}

TEST(Names, AMistypedPropertyIsAProblemInAxiomsAndInFacts) {
  Outcome outcome = check(
      ":Robot rdfs:subClassOf [ a owl:Restriction ; owl:onProperty :obsreves ; owl:someValuesFrom :BallInfo ] .\n");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out, HasSubstr("e:obsreves  (property): did you mean e:observes?   [a.ttl:4]"));
  outcome = check(":r a :Robot ; :observs :b . :b a :BallInfo .\n");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out, HasSubstr("e:observs  (property): did you mean e:observes?"));
}

TEST(Names, ADeclaredNameInANearlyEqualNamespaceIsWhatWasMeant) {
  const Outcome outcome = check(":Mine a owl:Class ; rdfs:subClassOf <https://e/BallInfo> .\n");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out, HasSubstr("<https://e/BallInfo>  (class): did you mean e:BallInfo?"));
}

TEST(Names, NamesOfANamespaceThatWasNotGivenAreSummedUpAndNoProblem) {
  const Outcome outcome = check(
      ":Robot rdfs:subClassOf <http://other/Agent> , <http://other/Thing2> ; <http://purl.org/dc/terms/title> \"r\" "
      ".\n");
  EXPECT_EQ(outcome.status, 0) << outcome.out;
  EXPECT_THAT(outcome.out, HasSubstr("http://other/  2 names, like other:Agent"));
  EXPECT_THAT(outcome.out, HasSubstr("http://purl.org/dc/terms/  1 name"));
}

TEST(Names, AFileThatDeclaresNothingIsNoProblem) {
  const Program program;
  program.turtle("a.ttl", ":Camera rdfs:subClassOf :Sensor .\n");
  const Outcome outcome = program.run({"check", "a.ttl"});
  EXPECT_EQ(outcome.status, 0) << outcome.out;
  EXPECT_THAT(outcome.out, Not(HasSubstr("declare")));
}

TEST(Names, IndividualsAndBuiltInNamesNeedNoDeclaration) {
  const Outcome outcome = check(
      ":r a :Robot ; :observes :ball7 . :Robot rdfs:subClassOf owl:Thing , [ a owl:Class ; owl:oneOf ( :r :q ) ] .\n"
      ":rate a owl:DatatypeProperty ; rdfs:range xsd:positiveInteger .\n");
  EXPECT_EQ(outcome.status, 0) << outcome.out;
  EXPECT_THAT(outcome.out, Not(HasSubstr("declared")));
}

TEST(Names, ALabelOfTwoClassesIsNamedAndNoProblem) {
  const Outcome outcome = check(":Ball a owl:Class ; rdfs:label \"ball\"@en .\n");
  EXPECT_EQ(outcome.status, 0) << outcome.out;
  EXPECT_THAT(outcome.out, HasSubstr("\"ball\": e:Ball e:BallInfo"));
}

TEST(Names, AreInTheJsonDocumentToo) {
  const Program program;
  program.turtle("a.ttl",
                 std::string(declared) + ":Mine a owl:Class ; rdfs:subClassOf :BallInf ; rdfs:lable \"x\" .\n");
  const auto document = boost::json::parse(program.run({"check", "--json", "a.ttl"}).out).as_object();
  const boost::json::object& undeclared = document.at("undeclared").at(0).as_object();
  EXPECT_EQ(undeclared.at("iri"), "http://e/BallInf");
  EXPECT_EQ(undeclared.at("line"), 4);
  EXPECT_EQ(undeclared.at("similar").at(0), "e:BallInfo");
  EXPECT_EQ(document.at("unknown_words").at(0).at("name"), "rdfs:lable");
  EXPECT_EQ(document.at("problem"), true);
}

TEST(Names, CompileSaysHowManyThereAreForTheLogOfTheDaemon) {
  const Program program;
  program.turtle("a.ttl",
                 std::string(declared) + ":Mine a owl:Class ; rdfs:subClassOf :BallInf ; rdfs:lable \"x\" .\n");
  const Outcome outcome = program.run({"compile", "a.ttl", "-o", "a.geminga"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.err, HasSubstr("1 name used and nowhere declared, the first e:BallInf at a.ttl:4: did you mean"));
  EXPECT_THAT(outcome.err,
              HasSubstr("1 name that RDF, RDFS, OWL and XSD do not have, the first rdfs:lable at a.ttl:4"));
}

TEST(Names, OfFunctionalSyntaxAreLookedAtToo) {
  const Program program;
  program.write("a.ofn",
                "Prefix(:=<http://e/>)\nPrefix(owl:=<http://www.w3.org/2002/07/owl#>)\nOntology(<http://e/o>\n"
                "Declaration(Class(:BallInfo))\nSubClassOf(:BallInfo :BalInfo)\nSubClassOf(:BallInfo owl:Thin)\n)\n");
  const Outcome outcome = program.run({"check", "a.ofn"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out, HasSubstr(":BalInfo  (class): did you mean :BallInfo?   [a.ofn:5]"));
  EXPECT_THAT(outcome.out, HasSubstr("owl:Thin: did you mean owl:Thing"));
}

}  // namespace
}  // namespace geminga::ontology
