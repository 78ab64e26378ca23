// Omissions of an ontology: the classes that they may matter to, and --lenient, which leaves less out.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/json.hpp>

#include "tools/ontology/program.hpp"

namespace geminga::ontology {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(Check, SaysWhichClassesWhatWasLeftOutMayMatterTo) {
  const Program program;
  const std::string axioms =
      ":p a owl:ObjectProperty, owl:TransitiveProperty, owl:AsymmetricProperty . :A a owl:Class ; rdfs:subClassOf "
      "[ a owl:Restriction ; owl:onProperty :p ; owl:someValuesFrom :B ] . :B a owl:Class . :C a owl:Class ; "
      "rdfs:subClassOf :D . :D a owl:Class . :x a :C .";
  program.turtle("a.ttl", axioms);
  const Outcome outcome = program.run({"check", "a.ttl"});
  EXPECT_THAT(outcome.out, HasSubstr("What was left out may matter to the superclasses of 1 class:\n  e:A\n"));
  EXPECT_THAT(outcome.out, HasSubstr("All superclasses of 3 of 4 classes were found.\n"));
  EXPECT_THAT(program.run({"check", "a.ttl", "--json"}).out, HasSubstr(R"("touched":["e:A"])"));
  // A fact that leads to the property may contradict what was left out, and everything follows from a contradiction.
  program.turtle("b.ttl", axioms + " :y a :A .");
  EXPECT_THAT(program.run({"check", "b.ttl"}).out, HasSubstr("superclasses of 4 classes:\n"));
}

TEST(Check, ListsEachPlaceWhereTheReaderLeftSomethingOut) {
  const Program program;
  program.turtle("a.ttl",
                 ":p a owl:ObjectProperty .\n"
                 ":A rdfs:subClassOf [ a owl:Restriction ; owl:onProperty :p ] .\n"
                 ":B rdfs:subClassOf [ a owl:Restriction ; owl:onProperty :p ] .\n");
  program.turtle("b.ttl", ":C a owl:Class ; rdfs:subClassOf [ a owl:Restriction ; owl:onProperty :p ] .\n");
  const Outcome few = program.run({"check", "a.ttl", "b.ttl"});
  EXPECT_THAT(few.out, HasSubstr("  an owl:Restriction without a constraint: 3, first at a.ttl:3\n"));
  EXPECT_THAT(few.out, Not(HasSubstr("    at ")));
  const Outcome all = program.run({"check", "a.ttl", "b.ttl", "--all"});
  EXPECT_THAT(all.out, HasSubstr("first at a.ttl:3\n    at a.ttl:3\n    at a.ttl:4\n    at b.ttl:2\n"));
  const auto found = boost::json::parse(program.run({"check", "a.ttl", "b.ttl", "--json"}).out);
  const boost::json::array places = found.at("left_out").at(0).at("places").as_array();
  ASSERT_EQ(places.size(), 3U);
  EXPECT_EQ(places[2].at("file"), "b.ttl");
  EXPECT_EQ(places[2].at("line"), 2);
}

TEST(Check, SaysThatFactsOfAnUndeclaredPropertyAreAnnotations) {
  const Program program;
  program.turtle("a.ttl",
                 ":A a owl:Class .\n:i a :A ; :knows :j .\n:j a :A ; :age 5 .\n"
                 ":A :madeBy :i . <http://e/o> a owl:Ontology ; :version 1 . :k :knows :i .\n");
  const Outcome outcome = program.run({"check", "a.ttl"});
  EXPECT_EQ(outcome.status, 0) << outcome.out;
  EXPECT_THAT(outcome.out, HasSubstr("  facts of properties that nothing declares, such as <http://e/knows>, read as "
                                     "annotations (declare them as owl:ObjectProperty or owl:DatatypeProperty): 2, "
                                     "first at a.ttl:3\n"));
  EXPECT_THAT(outcome.out, HasSubstr("Complete: "));
  program.turtle("b.ttl", ":knows a owl:ObjectProperty . :age a owl:DatatypeProperty .\n");
  EXPECT_THAT(program.run({"check", "a.ttl", "b.ttl"}).out, Not(HasSubstr("nothing declares")));
}

TEST(Check, ListsEachPlaceThatIsReadOtherwiseThanWritten) {
  const Program program;
  program.turtle("a.ttl", ":q a owl:DatatypeProperty .\n:i :q \"5.0\"^^xsd:integer .\n:j :q \"6.0\"^^xsd:integer .\n");
  const Outcome all = program.run({"check", "a.ttl", "--lenient", "--all"});
  EXPECT_THAT(all.out, HasSubstr("    at a.ttl:3\n    at a.ttl:4\n"));
  const auto found = boost::json::parse(program.run({"check", "a.ttl", "--lenient", "--json"}).out);
  EXPECT_EQ(found.at("remarks").at(0).at("places").as_array().size(), 2U);
}

TEST(Lenient, IsAFlagOfEveryCommandThatReadsOntologies) {
  const Program program;
  for (const std::string command :
       {"check",     "classify", "subsumes", "entails", "consistent", "explain", "repair",
        "compile",   "draw",     "infer",    "convert", "merge",      "query",   "realize",
        "instances", "id",       "diff",     "extract", "report",     "align",   "describe"})
    EXPECT_THAT(program.run({command, "--help"}).out, HasSubstr("--lenient")) << command;
}

TEST(Lenient, MakesABoundOfAnotherDatatypeCountInEntailments) {
  const Program program;
  const std::string properties =
      "@prefix xsd: <http://www.w3.org/2001/XMLSchema#> . :u a owl:DatatypeProperty . :A a owl:Class . :B a owl:Class "
      ".";
  const std::string small =
      "[ a owl:Restriction ; owl:onProperty :u ; owl:someValuesFrom [ a rdfs:Datatype ; "
      "owl:onDatatype xsd:double ; owl:withRestrictions ( [ xsd:maxInclusive 1 ] ) ] ] .";
  program.turtle("a.ttl", properties + ":A rdfs:subClassOf " + small + " :B owl:equivalentClass " + small);
  program.turtle("b.ttl", properties + ":A rdfs:subClassOf :B .");
  EXPECT_NE(program.run({"entails", "a.ttl", "b.ttl"}).status, 0);
  EXPECT_EQ(program.run({"entails", "a.ttl", "b.ttl", "--lenient"}).status, 0);
  EXPECT_EQ(program.run({"explain", "a.ttl", "--sub", "A", "--super", "B"}).status, 1);
  EXPECT_EQ(program.run({"explain", "a.ttl", "--sub", "A", "--super", "B", "--lenient"}).status, 0);
}

TEST(Lenient, MakesNoContradictionOfALiteralThatIsIllFormed) {
  const Program program;
  for (const std::string range : {"xsd:int", "xsd:double", "xsd:byte", "xsd:string"}) {
    program.turtle(
        "a.ttl", "@prefix xsd: <http://www.w3.org/2001/XMLSchema#> . :q a owl:DatatypeProperty ; rdfs:range " + range +
                     " . :A a owl:Class . :i a :A ; :q \"7.5\"^^xsd:int .");
    EXPECT_EQ(program.run({"check", "a.ttl", "--lenient"}).status, 0) << range;
    EXPECT_NE(program.run({"consistent", "a.ttl", "--lenient"}).status, 1) << range;
  }
}

/// Whether the bound is one of the datatype cannot be known; if it is none, A is below B.
constexpr std::string_view damaged_bound =
    "Prefix(:=<http://e/#>) Prefix(xsd:=<http://www.w3.org/2001/XMLSchema#>)\n"
    "Ontology(<http://e/> Declaration(DataProperty(:d)) Declaration(Class(:A)) Declaration(NamedIndividual(:a))\n"
    "EquivalentClasses(:B DataSomeValuesFrom(:d xsd:double)) ClassAssertion(:A :a)\n"
    "SubClassOf(:A DataSomeValuesFrom(:d DatatypeRestriction(xsd:double xsd:minInclusive \"1\"^^xsd:integer))))\n";

TEST(LeftOutByTheReader, IsToldByEachCommandWhoseAnswerItMayChange) {
  const Program program;
  program.write("a.ofn", damaged_bound);
  const std::string what = "a facet or bound that its datatype does not have is not understood: a.ofn:4";
  const Outcome realized = program.run({"realize", "a.ofn"});
  EXPECT_EQ(realized.out, ":a: :A\n");
  EXPECT_THAT(realized.err, testing::HasSubstr(what));
  const Outcome instances = program.run({"instances", "a.ofn", ":B"});
  EXPECT_EQ(instances.status, 2);
  EXPECT_THAT(instances.err, testing::HasSubstr(what));
  EXPECT_THAT(program.run({"classify", "a.ofn"}).err, testing::HasSubstr(what));
  const Outcome subsumed = program.run({"subsumes", "a.ofn", "--sub", ":A", "--super", ":B"});
  EXPECT_EQ(subsumed.status, 1);
  EXPECT_EQ(subsumed.out, ":A is not known to be subsumed by :B: " + what + "\n");
  const Outcome explained = program.run({"explain", "a.ofn", "--individual", ":a", "--super", ":B"});
  EXPECT_EQ(explained.status, 1);
  EXPECT_EQ(explained.out, ":a is not known to be in :B: " + what + "\n");
}

TEST(LeftOutByTheReader, OfLiteralsIsNamedBesideConsistent) {
  const Program program;
  program.write("a.ofn",
                "Prefix(:=<http://e/#>) Prefix(xsd:=<http://www.w3.org/2001/XMLSchema#>)\n"
                "Ontology(<http://e/> DataPropertyAssertion(:d :a \"abc\"^^xsd:integer))\n");
  const Outcome outcome = program.run({"consistent", "a.ofn"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.err, testing::HasSubstr("a.ofn:2; there can be a world whatever value of the datatype is meant"));
}

}  // namespace
}  // namespace geminga::ontology
