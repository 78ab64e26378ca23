// realize and instances, and individuals in query, run as a user runs them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "program.hpp"

namespace geminga::ontology {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

/// A robot that is a goalie by its task, with two names, and one that is of one of two kinds.
constexpr std::string_view robots =
    ":Robot a owl:Class . :sees a owl:ObjectProperty ; owl:inverseOf :seenBy ; rdfs:domain :Robot . :seenBy a "
    "owl:ObjectProperty . :near a owl:ObjectProperty , owl:TransitiveProperty . :Ball a owl:Class . "
    ":Goalie a owl:Class ; owl:equivalentClass [ owl:intersectionOf ( :Robot [ a owl:Restriction ; owl:onProperty "
    ":sees "
    "; owl:someValuesFrom :Ball ] ) ] . :Keeper a owl:Class ; owl:equivalentClass :Goalie . "
    ":Striker a owl:Class ; rdfs:subClassOf :Robot . :Other a owl:Class ; rdfs:subClassOf :Robot . "
    ":ball a :Ball . :bob :sees :ball ; owl:sameAs :rob . :eve a [ owl:unionOf ( :Striker :Other ) ] ; :near :bob . "
    ":zoe a owl:NamedIndividual ; :near :eve .";

TEST(Realize, PrintsTheMostSpecificTypesAndWhoIsTheSame) {
  const Program program;
  program.turtle("team.ttl", robots);
  const Outcome outcome = program.run({"realize", "team.ttl"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.err, IsEmpty());
  EXPECT_EQ(outcome.out, "e:ball: e:Ball\ne:bob = e:rob: e:Goalie = e:Keeper\ne:eve: e:Robot\ne:zoe: owl:Thing\n");
  EXPECT_THAT(program.run({"realize", "team.ttl", "--all"}).out, HasSubstr("e:Goalie = e:Keeper, e:Robot\n"));
}

TEST(Realize, PrintsTheClosureOfFullIris) {
  const Program program;
  program.turtle("team.ttl", robots);
  std::string expected = "http://e/ball\thttp://e/Ball\n";
  for (const std::string name : {"bob", "rob"}) {
    for (const std::string of : {"Goalie", "Keeper", "Robot"})
      expected.append("http://e/").append(name).append("\thttp://e/").append(of).append("\n");
    if (name == "bob") expected += "http://e/eve\thttp://e/Robot\n";
  }
  EXPECT_EQ(program.run({"realize", "team.ttl", "--closure"}).out, expected);
}

TEST(Realize, AndQueryKnowClassesOfEverything) {
  const Program program;
  program.turtle("a.ttl",
                 ":A a owl:Class . :All a owl:Class . :is a owl:ObjectProperty, owl:ReflexiveProperty ; rdfs:range "
                 ":All . :x a :A .");
  EXPECT_EQ(program.run({"realize", "a.ttl"}).out, "e:x: e:A\n");
  EXPECT_EQ(program.run({"realize", "a.ttl", "--all"}).out, "e:x: e:A, e:All = owl:Thing\n");
  EXPECT_EQ(program.run({"realize", "a.ttl", "--closure"}).out, "http://e/x\thttp://e/A\nhttp://e/x\thttp://e/All\n");
  EXPECT_EQ(program.run({"query", "a.ttl", "SELECT ?x { ?x a e:All }", "--format", "csv"}).out, "x\r\nhttp://e/x\r\n");
}

TEST(Realize, PrintsFactsThatFollow) {
  const Program program;
  program.turtle("team.ttl", robots);
  const std::string out = program.run({"realize", "team.ttl", "--closure", "--facts"}).out;
  EXPECT_THAT(out, HasSubstr("http://e/ball\thttp://e/seenBy\thttp://e/rob\n"));
  EXPECT_THAT(out, HasSubstr("http://e/zoe\thttp://e/near\thttp://e/rob\n"));
  EXPECT_THAT(program.run({"realize", "team.ttl", "--json", "--facts"}).out,
              HasSubstr(R"({"subject":"http://e/ball","property":"http://e/seenBy","object":"http://e/bob"})"));
}

TEST(Individuals, AreNotAskedForWhereFilesContradictThemselves) {
  const Program program;
  program.turtle("a.ttl", ":A a owl:Class ; owl:disjointWith :B . :B a owl:Class . :x a :A, :B .");
  const std::vector<std::string> commands[] = {{"realize", "a.ttl"},
                                               {"realize", "a.ttl", "--json"},
                                               {"instances", "a.ttl", "A"},
                                               {"instances", "a.ttl", "A", "--json"},
                                               {"query", "a.ttl", "ASK { :x a :A }"}};
  for (const auto& command : commands) {
    const Outcome outcome = program.run(command);
    EXPECT_EQ(outcome.status, 1) << command.front();
    EXPECT_THAT(outcome.err, HasSubstr("contradicts itself"));
  }
}

TEST(Instances, AreThoseOfAnExpression) {
  const Program program;
  program.turtle("team.ttl", robots);
  EXPECT_EQ(program.run({"instances", "team.ttl", "Robot and (sees some Ball)"}).out, "e:bob\ne:rob\n");
  EXPECT_EQ(program.run({"instances", "team.ttl", "Striker or Other"}).out, "e:eve\n");
  EXPECT_EQ(program.run({"instances", "team.ttl", "Goalie"}).status, 0);
  EXPECT_EQ(program.run({"instances", "team.ttl", "Striker"}).status, 1);
  EXPECT_EQ(program.run({"instances", "team.ttl", "Robot and and"}).status, 2);
  EXPECT_EQ(program.run({"instances", "team.ttl"}).status, 2);
  EXPECT_EQ(program.run({"instances", "team.ttl", "Goalie", "--json"}).out,
            "{\"consistent\":true,\"instances\":[\"http://e/bob\",\"http://e/rob\"]}\n");
}

TEST(Query, SeesFactsThatFollowAndInstancesOfExpressions) {
  const Program program;
  program.turtle("team.ttl", robots);
  EXPECT_EQ(program.run({"query", "team.ttl", "ASK { :ball :seenBy :rob . :zoe :near :bob }"}).status, 0);
  const auto answer = [&](const std::string& expression) {
    const Outcome outcome = program.run(
        {"query", "team.ttl", "SELECT ?x WHERE { ?x a " + expression + " } ORDER BY ?x", "--format", "csv"});
    return outcome.status == 2 ? outcome.err : outcome.out;
  };
  const std::string sees = "[ a owl:Restriction ; owl:onProperty :sees ; owl:someValuesFrom :Ball ]";
  EXPECT_EQ(answer(sees), "x\r\nhttp://e/bob\r\nhttp://e/rob\r\n");
  EXPECT_EQ(answer("[ owl:intersectionOf ( :Robot [ owl:unionOf ( :Striker :Other ) ] ) ] ; :near :rob"),
            "x\r\nhttp://e/eve\r\n");
  EXPECT_EQ(answer("[ owl:oneOf ( :rob :zoe ) ]"), "x\r\nhttp://e/bob\r\nhttp://e/rob\r\nhttp://e/zoe\r\n");
  EXPECT_EQ(answer("[ owl:onProperty [ owl:inverseOf :sees ] ; owl:minQualifiedCardinality 1 ; owl:onClass :Goalie ]"),
            "x\r\nhttp://e/ball\r\n");
  EXPECT_EQ(answer("[ owl:onProperty :near ; owl:hasValue :bob ]"), "x\r\nhttp://e/eve\r\nhttp://e/zoe\r\n");
  EXPECT_THAT(answer("[ owl:complementOf :Bal ]"), HasSubstr("the files have no class <http://e/Bal>"));
  EXPECT_THAT(answer("[ owl:onProperty :sees ]"), HasSubstr("an owl:Restriction without a constraint"));
  EXPECT_THAT(answer("[ owl:complementOf :Ball ; rdfs:label \"x\" ]"), HasSubstr("rdfs:label is no part of it"));
  EXPECT_EQ(program.run({"query", "team.ttl", "--asserted", "SELECT ?x WHERE { ?x a " + sees + " }"}).status, 1);
}

}  // namespace
}  // namespace geminga::ontology
