// The taxonomy, the closure and the numbers of a run.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/json.hpp>

#include "tools/ontology/program.hpp"

namespace geminga::ontology {
namespace {

using testing::IsEmpty;

constexpr const char* nothing = "http://www.w3.org/2002/07/owl#Nothing";

TEST(Closure, HoldsEveryPairOfDifferentClassesOnceAndSorted) {
  const Program program;
  program.turtle("a.ttl",
                 ":C rdfs:subClassOf :D . :A rdfs:subClassOf :C . :A owl:equivalentClass :B . :D a owl:Class .\n"
                 ":A rdfs:subClassOf owl:Thing . :A- a owl:Class .\n");
  const Outcome outcome = program.run({"classify", "--closure", "a.ttl"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out,
            "http://e/A\thttp://e/B\nhttp://e/A\thttp://e/C\nhttp://e/A\thttp://e/D\n"
            "http://e/B\thttp://e/A\nhttp://e/B\thttp://e/C\nhttp://e/B\thttp://e/D\n"
            "http://e/C\thttp://e/D\n");
}

TEST(Closure, GivesAnUnsatisfiableClassItsOneLine) {
  const Program program;
  program.turtle("a.ttl", ":A rdfs:subClassOf :B, :C . :B owl:disjointWith :C . :D rdfs:subClassOf :A, :E .\n");
  const Outcome outcome = program.run({"classify", "--closure", "a.ttl"});
  EXPECT_EQ(outcome.out, std::string("http://e/A\t") + nothing + "\nhttp://e/D\t" + nothing + "\n");
}

TEST(Closure, HoldsClassesThatAreEverything) {
  const Program program;
  program.turtle("a.ttl", "owl:Thing rdfs:subClassOf :All . :A a owl:Class .\n");
  const Outcome outcome = program.run({"classify", "--closure", "a.ttl"});
  EXPECT_EQ(outcome.out, "http://e/A\thttp://e/All\nhttp://www.w3.org/2002/07/owl#Thing\thttp://e/All\n");
}

TEST(Closure, OfAContradictionIsThatEveryClassIsEmpty) {
  const Program program;
  program.turtle("a.ttl", ":i a :A, :B . :A owl:disjointWith :B . :C rdfs:subClassOf :D .\n");
  const Outcome outcome = program.run({"classify", "--closure", "a.ttl"});
  std::string expected;
  for (const char* name : {"A", "B", "C", "D"}) expected += std::string("http://e/") + name + '\t' + nothing + '\n';
  expected += std::string("http://www.w3.org/2002/07/owl#Thing\t") + nothing + '\n';
  EXPECT_EQ(outcome.out, expected);
}

TEST(Classify, OfAContradictionWritesTheOneNodeOnce) {
  const Program program;
  program.turtle("a.ttl", ":i a :A, :B . :A owl:disjointWith :B .\n");
  EXPECT_EQ(program.run({"classify", "a.ttl"}).out, "e:A = e:B = owl:Nothing = owl:Thing\n");
}

TEST(Classify, SaysWhichImportsNoFileAnswersInTheWordsOfCheck) {
  const Program program;
  program.turtle("a.ttl", "<http://e/o> a owl:Ontology ; owl:imports <http://e/nowhere> .\n:A rdfs:subClassOf :B .\n");
  const std::string words =
      "Imports that no given file answers (nothing is fetched: name the files, too):\n"
      "  <http://e/nowhere> at a.ttl:2\n";
  const Outcome outcome = program.run({"classify", "--closure", "a.ttl"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out, "http://e/A\thttp://e/B\n");
  EXPECT_EQ(outcome.err, "geminga-ontology: " + words);
  EXPECT_THAT(program.run({"check", "a.ttl"}).out, testing::HasSubstr(words));
  program.turtle("b.ttl", "<http://e/nowhere> a owl:Ontology .\n");
  EXPECT_THAT(program.run({"classify", "a.ttl", "b.ttl"}).err, IsEmpty());
}

TEST(Closure, OfAnEmptyOntologyIsEmpty) {
  const Program program;
  program.write("a.ttl", "");
  const Outcome outcome = program.run({"classify", "--closure", "a.ttl"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.out, IsEmpty());
}

TEST(Closure, DoesNotDependOnThreadsOrTheOrderOfFiles) {
  const Program program;
  const std::string core = shipped() + "/core.ttl";
  const std::string soccer = shipped() + "/robot-soccer.ttl";
  const Outcome expected = program.run({"classify", "--closure", core, soccer});
  EXPECT_EQ(expected.status, 0);
  EXPECT_GT(expected.out.size(), 10'000U);
  EXPECT_EQ(program.run({"classify", "--closure", soccer, core, "--threads", "4"}).out, expected.out);
}

TEST(Classify, PrintsAnIndentedTreeWithEquivalentsOnOneLine) {
  const Program program;
  program.turtle("a.ttl",
                 ":B rdfs:subClassOf :A . :C rdfs:subClassOf :A . :D rdfs:subClassOf :B, :C . :E rdfs:subClassOf :D .\n"
                 ":F owl:equivalentClass :E . :U rdfs:subClassOf :B, [ owl:complementOf :B ] .\n");
  const Outcome outcome = program.run({"classify", "a.ttl"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out,
            "owl:Thing\n"
            "  e:A\n"
            "    e:B\n"
            "      e:D\n"
            "        e:E = e:F\n"
            "    e:C\n"
            "      e:D ...\n"
            "e:U = owl:Nothing\n");
}

TEST(Classify, WritesTheStatisticsOfTheContract) {
  const Program program;
  program.turtle("a.ttl", ":A rdfs:subClassOf :B . :B owl:newInOwl3 :C .\n");
  const Outcome outcome = program.run({"classify", "a.ttl", "--threads", "2", "--stats", "run.json"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const boost::json::object stats = boost::json::parse(program.read("run.json")).as_object();
  std::vector<std::string> keys;
  for (const auto& entry : stats) keys.emplace_back(entry.key());
  EXPECT_THAT(keys, testing::UnorderedElementsAre("triples", "classes", "axioms", "left_out", "load_ms", "classify_ms",
                                                  "peak_rss_kib", "threads"));
  EXPECT_EQ(stats.at("triples"), 2);
  EXPECT_EQ(stats.at("classes"), 2);
  EXPECT_EQ(stats.at("axioms"), 1);
  EXPECT_EQ(stats.at("left_out"), 1);
  EXPECT_EQ(stats.at("threads"), 2);
  EXPECT_GT(stats.at("peak_rss_kib").as_int64(), 0);
  EXPECT_GE(stats.at("load_ms").to_number<double>(), 0);
}

TEST(Classify, PrintsTheTaxonomiesOfPropertiesWhereAsked) {
  const Program program;
  program.turtle(
      "a.ttl",
      ":p a owl:ObjectProperty ; rdfs:subPropertyOf :q . :q a owl:ObjectProperty ; owl:equivalentProperty :r .\n"
      ":r a owl:ObjectProperty . :u a owl:DatatypeProperty ; rdfs:subPropertyOf :v .\n"
      ":v a owl:DatatypeProperty .\n");
  const Outcome tree = program.run({"classify", "--properties", "a.ttl"});
  EXPECT_EQ(tree.status, 0) << tree.err;
  EXPECT_EQ(tree.out, "owl:topObjectProperty\n  e:q = e:r\n    e:p\nowl:topDataProperty\n  e:v\n    e:u\n");
  EXPECT_EQ(program.run({"classify", "--properties", "--closure", "a.ttl"}).out,
            "http://e/p\thttp://e/q\nhttp://e/p\thttp://e/r\nhttp://e/q\thttp://e/r\nhttp://e/r\thttp://e/q\n"
            "http://e/u\thttp://e/v\n");
  const boost::json::value found = boost::json::parse(program.run({"classify", "--properties", "--json", "a.ttl"}).out);
  EXPECT_EQ(found.at("data_properties").as_array().size(), 4U);
  EXPECT_EQ(found.at("nodes").as_array().size(), 2U);
}

TEST(Classify, JsonHoldsNodesAndParents) {
  const Program program;
  program.turtle("a.ttl", ":A rdfs:subClassOf :B . :A owl:equivalentClass :C .\n");
  const boost::json::value found = boost::json::parse(program.run({"classify", "a.ttl", "--json"}).out);
  EXPECT_EQ(found.at("consistent"), true);
  const auto& nodes = found.at("nodes").as_array();
  const auto node =
      std::ranges::find_if(nodes, [](const auto& entry) { return entry.at("classes").at(0) == "http://e/A"; });
  ASSERT_NE(node, nodes.end());
  EXPECT_EQ(node->at("classes").at(1), "http://e/C");
  EXPECT_EQ(node->at("parents").at(0), "http://e/B");
}

}  // namespace
}  // namespace geminga::ontology
