// geminga-query export: the living team as RDF, whatever modules call themselves, and asked by SPARQL with inference.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "support/process.hpp"
#include "tools/clients/query.hpp"

namespace geminga::tools {
namespace {

using testing::Each;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

using Export = Query;

/// The answer of geminga-ontology to a query over the living team and the shipped ontologies.
Outcome asked(const Bench& bench, const std::string& format, const std::string& sparql) {
  const std::string script =
      "\"$0\" export --format " + format + " | \"$1\" query - " GEMINGA_SOURCE_DIR "/ontology \"$2\"";
  return bench.run("/bin/sh",
                   {"-c", script, system::program("geminga-query"), system::program("geminga-ontology"), sparql});
}

TEST_F(Export, IsAskedByInferenceInBothSyntaxes) {
  for (const std::string format : {"turtle", "ntriples"}) {
    const auto found = asked(bench_, format,
                             "SELECT ?name ?rate WHERE { ?robot geminga:name ?name ; geminga:offers ?service . "
                             "?service geminga:provides ?it ; <https://geminga.example/attribute#rate> ?rate . "
                             "?it a <https://geminga.example/soccer#TrackedObject> }");
    EXPECT_EQ(found.status, 0) << format << found.out << found.errors;
    EXPECT_THAT(found.out, HasSubstr("robot0")) << format;
    EXPECT_THAT(found.out, HasSubstr("30")) << format;
  }
}

TEST_F(Export, WritesClassExpressionsSoThatInferenceSeesWhatTheyDescribe) {
  peer_.say("0 sys describe concept=\"capability:Robot and capability:hasPart some capability:Gripper\"");
  peer_.say(
      "5 pub create mode=oto port=5002 concept=\"soccer:SharedBallInfo and geminga:carries some soccer:BallInfo\"");
  EXPECT_THAT(peer_.lines_until_pong(), IsEmpty());
  for (const std::string format : {"turtle", "ntriples"}) {
    const auto service = asked(bench_, format,
                               "SELECT ?port WHERE { ?service geminga:provides ?it ; geminga:port ?port . "
                               "?it a <https://geminga.example/soccer#BallInfo> }");
    EXPECT_THAT(service.out, HasSubstr("5002")) << format << service.errors;
    const auto robot =
        asked(bench_, format,
              "PREFIX owl: <http://www.w3.org/2002/07/owl#> PREFIX c: <https://geminga.example/capability#> "
              "SELECT ?name WHERE { ?robot geminga:name ?name ; a [ a owl:Restriction ; "
              "owl:onProperty c:hasCapability ; owl:someValuesFrom c:Grasping ] }");
    EXPECT_THAT(robot.out, HasSubstr("robot0")) << format << robot.errors;
  }
}

TEST_F(Export, TellsAHostileNameAsTextAndNothingElse) {
  Talk hostile = bench_.talk();
  hostile.say("0 sys hello name=intruder");
  hostile.say(
      R"(1 pub create mode=oto port=5009 text="x\" . <http://e/a> a <http://e/Evil> . #" note="a\"@en , <http://e/b> \\")");
  EXPECT_THAT(hostile.lines_until_pong(), Each(Not(HasSubstr("1 4")))) << "it is taken";
  for (const std::string format : {"turtle", "ntriples"}) {
    const auto evil =
        asked(bench_, format, "SELECT ?x WHERE { { ?x a <http://e/Evil> } UNION { ?s ?p <http://e/b> } }");
    EXPECT_EQ(evil.status, 1) << format << evil.out << evil.errors;
    const auto text = asked(bench_, format, "SELECT ?text WHERE { ?x geminga:text ?text }");
    EXPECT_EQ(text.status, 0) << format << text.errors;
    EXPECT_THAT(text.out, HasSubstr("<http://e/Evil>")) << format;
  }
}

TEST_F(Export, SaysWhatItCannotDo) {
  const auto json = bench_.query({"--json", "export"});
  EXPECT_EQ(json.status, 2);
  EXPECT_THAT(json.errors, HasSubstr("export writes RDF"));
  const auto format = bench_.query({"export", "--format", "xml"});
  EXPECT_EQ(format.status, 2);
  EXPECT_THAT(format.errors, Not(IsEmpty()));
}

}  // namespace
}  // namespace geminga::tools
