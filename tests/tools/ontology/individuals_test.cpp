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

TEST(Realize, QueryAndInferHaveOneLimitForFacts) {
  const Program program;
  std::string same = ":p a owl:ObjectProperty . :x0 :p :x0 .\n";
  for (int at = 0; at < 200; ++at)
    same += ":x" + std::to_string(at) + " owl:sameAs :x" + std::to_string(at + 1) + " .\n";
  program.turtle("a.ttl", same);
  const std::vector<std::string> commands[] = {{"realize", "a.ttl", "--facts"},
                                               {"realize", "a.ttl", "--facts", "--json"},
                                               {"realize", "a.ttl", "--facts", "--closure"},
                                               {"infer", "a.ttl", "--facts", "-o", "out.nt"},
                                               {"query", "a.ttl", "ASK { :x1 :p :x2 }"}};
  for (std::vector<std::string> command : commands) {
    command.insert(command.end(), {"--graph-limit", "1"});
    const Outcome over = program.run(command);
    EXPECT_EQ(over.status, 4) << command.front();
    EXPECT_THAT(over.err, HasSubstr("the triples take more than 1 MiB in all: give fewer files"));
    EXPECT_THAT(over.err, HasSubstr("or raise --graph-limit"));
    EXPECT_THAT(over.out, testing::AnyOf(IsEmpty(), HasSubstr("{\"error\":"))) << command.front();
    command.back() = "64";
    EXPECT_EQ(program.run(command).status, 0) << command.front();
  }
  EXPECT_EQ(program.run({"realize", "a.ttl", "--graph-limit", "1"}).status, 0) << "no facts are asked for";
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

TEST(Query, HasOneRowForEachNameAndEachStatedValue) {
  const Program program;
  program.turtle("a.ttl",
                 ":C a owl:Class ; owl:hasKey ( :d ) . :d a owl:DatatypeProperty . :n a owl:DatatypeProperty . "
                 ":a a :C ; :d \"1\" ; :n \"x\"@de-AT . :b :n "
                 "\"y@en\"^^<http://www.w3.org/1999/02/22-rdf-syntax-ns#PlainLiteral> . :b a :C ; :d "
                 "\"1\"^^<http://www.w3.org/2001/XMLSchema#string> .");
  const auto rows = [&](const std::string& query) {
    return program.run({"query", "a.ttl", query, "--format", "tsv"}).out;
  };
  EXPECT_EQ(rows("SELECT ?x { ?x a :C }"), "?x\n<http://e/a>\n<http://e/b>\n") << "two names of one thing by its key";
  EXPECT_EQ(rows("SELECT ?x ?v { ?x :d ?v }"), "?x\t?v\n<http://e/a>\t\"1\"\n<http://e/b>\t\"1\"\n");
  EXPECT_EQ(rows("SELECT ?v { :a :n ?v } ORDER BY ?v"), "?v\n\"x\"@de-AT\n\"y\"@en\n")
      << "what follows has small letters";
  EXPECT_EQ(rows("SELECT ?v { :b :n ?v } ORDER BY ?v"), "?v\n\"x\"@de-at\n\"y\"@en\n");
  const std::string inferred =
      program.run({"infer", "a.ttl", "--facts", "--only-inferred", "-o", "-", "--to", "nt"}).out;
  EXPECT_THAT(inferred, HasSubstr("<http://e/b> <http://e/n> \"x\"@de-at ."));
  EXPECT_THAT(inferred, testing::Not(HasSubstr("<http://e/a> <http://e/n> \"x\""))) << "stated";
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

TEST(Query, FindsTheClassesBelowAboveAndEqualToAnExpression) {
  const Program program;
  program.turtle("team.ttl",
                 std::string(robots) +
                     " :Wreck rdfs:subClassOf owl:Nothing . :Keeper rdfs:subClassOf :Player . :Left "
                     "rdfs:subClassOf :Striker . :Left rdfs:subClassOf [ a owl:Restriction ; owl:onProperty "
                     ":near ; owl:someValuesFrom :Ball ] .");
  const auto answer = [&](const std::string& pattern) {
    const Outcome outcome =
        program.run({"query", "team.ttl", "SELECT ?x WHERE { " + pattern + " } ORDER BY ?x", "--format", "tsv"});
    std::string text = outcome.err;
    for (std::size_t at = 0; (at = outcome.out.find("<http://e/", at)) != std::string::npos; ++at)
      text += outcome.out.substr(at + 10, outcome.out.find('>', at) - at - 10) + ' ';
    return text;
  };
  const std::string sees = "[ a owl:Restriction ; owl:onProperty :sees ; owl:someValuesFrom :Ball ]";
  EXPECT_EQ(answer("?x rdfs:subClassOf " + sees), "Goalie Keeper Wreck ");
  EXPECT_EQ(answer(sees + " rdfs:subClassOf ?x"), "Goalie Keeper Player Robot ") << "the domain of sees";
  EXPECT_EQ(answer("?x owl:equivalentClass " + sees), "Goalie Keeper ");
  EXPECT_EQ(answer(sees + " owl:equivalentClass ?x"), "Goalie Keeper ");
  EXPECT_EQ(answer("?x rdfs:subClassOf [ owl:unionOf ( :Striker :Player ) ]"),
            "Goalie Keeper Left Player Striker Wreck ");
  EXPECT_EQ(answer("?x rdfs:subClassOf [ owl:unionOf ( :Striker :Player ) ] , [ owl:onProperty :near ; "
                   "owl:minCardinality 1 ]"),
            "Left Wreck ");
  EXPECT_EQ(answer("?x rdfs:subClassOf :Player . [ owl:unionOf ( :Keeper ) ] rdfs:subClassOf ?x"), "Goalie Keeper ");
  EXPECT_EQ(answer("?x rdfs:subClassOf [ owl:intersectionOf ( :Ball [ owl:complementOf :Ball ] ) ]"), "Wreck ");
  EXPECT_EQ(answer("?x a ?y . ?y rdfs:subClassOf [ owl:complementOf [ owl:complementOf :Striker ] ]"), "");
  EXPECT_THAT(answer("?x rdfs:subClassOf [ owl:complementOf :Bal ]"), HasSubstr("have no class <http://e/Bal>"));
  EXPECT_THAT(answer("[ owl:complementOf ?x ] rdfs:subClassOf [ owl:complementOf :Ball ]"), HasSubstr("asks for the"));
  const std::string stated = answer("?y rdfs:subClassOf [ owl:onProperty :near ; owl:someValuesFrom ?x ]");
  EXPECT_THAT(stated, HasSubstr("with a variable")) << "the files state it of Left, and that much can be answered";
  EXPECT_THAT(stated, HasSubstr("Ball "));
}

TEST(Query, SeesEquivalentClassesAsSubclassesOfEachOther) {
  const Program program;
  program.turtle("team.ttl", robots);
  EXPECT_EQ(program.run({"query", "team.ttl", "ASK { :Keeper rdfs:subClassOf :Goalie }"}).out, "yes\n");
  EXPECT_EQ(program.run({"query", "team.ttl", "ASK { :Goalie rdfs:subClassOf :Keeper }"}).out, "yes\n");
}

TEST(Query, TakesThePrefixesThatItPrints) {
  const Program program;
  program.write("team.ofn", "Ontology(<http://e/team> SubClassOf(<http://e/team#A> <http://e/team#B>))");
  const Outcome outcome = program.run({"query", "team.ofn", "SELECT ?x WHERE { ?x rdfs:subClassOf :B }"});
  EXPECT_EQ(outcome.out, "?x\n:A\n") << outcome.err;
}

}  // namespace
}  // namespace geminga::ontology
