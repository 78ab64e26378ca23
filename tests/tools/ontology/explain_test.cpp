// Answers to "is A subsumed by B", and the reasons.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/json.hpp>

#include "tools/ontology/program.hpp"

namespace geminga::ontology {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

class Explain : public testing::Test {
 protected:
  Explain() {
    program_.turtle("a.ttl",
                    ":A rdfs:subClassOf :B ,\n :X .\n:B rdfs:subClassOf :C .\n:C rdfs:label \"the third\" .\n"
                    ":N rdfs:subClassOf :B, [ owl:complementOf :B ] .\n");
  }
  const Program program_;
};

TEST_F(Explain, SubsumesSaysYesAndNo) {
  EXPECT_EQ(program_.run({"subsumes", "a.ttl", "--sub", "e:A", "--super", "<http://e/C>"}).status, 0);
  EXPECT_EQ(program_.run({"subsumes", "a.ttl", "--sub", "e:A", "--super", "the third"}).status, 0);
  EXPECT_EQ(program_.run({"subsumes", "a.ttl", "--sub", "e:A", "--super", "e:A"}).status, 0);
  EXPECT_EQ(program_.run({"subsumes", "a.ttl", "--sub", "e:A", "--super", "owl:Thing"}).status, 0);
  EXPECT_EQ(program_.run({"subsumes", "a.ttl", "--sub", "e:N", "--super", "e:X"}).status, 0);
  const Outcome no = program_.run({"subsumes", "a.ttl", "--sub", "http://e/C", "--super", "e:A"});
  EXPECT_EQ(no.status, 1);
  EXPECT_EQ(no.out, "e:C is not subsumed by e:A\n");
}

TEST_F(Explain, PrintsExactlyTheAxiomsThatAreNeeded) {
  const Outcome outcome = program_.run({"explain", "a.ttl", "--sub", "e:A", "--super", "e:C"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out,
            "e:A is subsumed by e:C, because:\ne:A SubClassOf e:B   [a.ttl:2]\ne:B SubClassOf e:C   [a.ttl:4]\n");
}

TEST_F(Explain, LaconicPrintsTheNeededPartsOfAxioms) {
  program_.turtle("b.ttl", ":A rdfs:subClassOf [ owl:intersectionOf ( :B :D ) ] .\n:B rdfs:subClassOf :C .\n");
  const Outcome outcome = program_.run({"explain", "b.ttl", "--sub", "e:A", "--super", "e:C", "--laconic"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out,
            "e:A is subsumed by e:C, because:\n"
            "e:A SubClassOf e:B   [b.ttl:2]\n  is a part of e:A SubClassOf e:B and e:D\n"
            "e:B SubClassOf e:C   [b.ttl:3]\n");
  const auto document = boost::json::parse(
      program_.run({"explain", "b.ttl", "--sub", "e:A", "--super", "e:C", "--laconic", "--json"}).out);
  EXPECT_EQ(document.at("axioms").at(0).at("whole"), "e:A SubClassOf e:B and e:D");
  EXPECT_FALSE(document.at("axioms").at(1).as_object().contains("whole"));
}

TEST_F(Explain, AReasonThatALimitCutOffIsNotSaidToBeMinimal) {
  const Outcome outcome = program_.run({"explain", "a.ttl", "--sub", "e:A", "--super", "e:C", "--steps", "1"});
  EXPECT_EQ(outcome.status, 4);
  EXPECT_THAT(outcome.err, HasSubstr("raise it"));
}

TEST_F(Explain, SaysWhenNothingEntailsIt) {
  const Outcome outcome = program_.run({"explain", "a.ttl", "--sub", "e:C", "--super", "e:A"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out,
              StartsWith("e:C is not subsumed by e:A\nNearest: e:A is subsumed by e:C, but not the other"));
}

TEST_F(Explain, SaysWhatIsMissing) {
  program_.turtle("b.ttl",
                  ":D owl:equivalentClass [ owl:intersectionOf ( :B [ a owl:Restriction ; owl:onProperty :r ;\n"
                  "  owl:someValuesFrom :X ] ) ] .\n"
                  ":E rdfs:subClassOf :B, [ a owl:Restriction ; owl:onProperty :r ; owl:someValuesFrom :Y ] .\n"
                  ":r a owl:ObjectProperty .\n");
  const Outcome outcome = program_.run({"explain", "b.ttl", "--sub", "e:E", "--super", "e:D"});
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  EXPECT_EQ(outcome.out,
            "e:E is not subsumed by e:D\nNearest: both are e:B\nEnough to be e:D:   [b.ttl:2]\n  met      e:B\n"
            "  missing  e:r some e:X   (it has e:r, but to nothing that is known to be e:X)\n");
  const Outcome json = program_.run({"explain", "b.ttl", "--sub", "e:E", "--super", "e:D", "--json"});
  const boost::json::value found = boost::json::parse(json.out);
  EXPECT_EQ(found.at("why_not").at("common").at(0), "http://e/B");
  EXPECT_EQ(found.at("why_not").at("ways").at(0).at("requirements").at(1).at("met"), false);
}

TEST_F(Explain, FindsAllReasonsAndSaysWhenThereAreMore) {
  program_.turtle("b.ttl", ":A rdfs:subClassOf :B, :C .\n:B rdfs:subClassOf :D .\n:C rdfs:subClassOf :D .\n");
  const Outcome all = program_.run({"explain", "b.ttl", "--sub", "e:A", "--super", "e:D", "--all"});
  EXPECT_THAT(all.out, AllOf(StartsWith("e:A is subsumed by e:D, for 2 reasons:\nreason 1\n"),
                             EndsWith("There are no others.\n")));
  const Outcome one = program_.run({"explain", "b.ttl", "--sub", "e:A", "--super", "e:D", "--all", "--limit", "1"});
  EXPECT_THAT(one.out, AllOf(HasSubstr("for 1 reason:"), EndsWith("There are more, or may be: raise --limit.\n")));
  const Outcome json = program_.run({"explain", "b.ttl", "--sub", "e:A", "--super", "e:D", "--all", "--json"});
  EXPECT_EQ(boost::json::parse(json.out).at("sets").as_array().size(), 2U);
  EXPECT_EQ(boost::json::parse(json.out).at("may_have_more"), false);
}

TEST_F(Explain, ShowsTheStepsOfAProof) {
  const Outcome outcome = program_.run({"explain", "a.ttl", "--sub", "e:A", "--super", "e:C", "--proof"});
  EXPECT_EQ(outcome.out,
            "e:A is subsumed by e:C, because:\n 1. e:A SubClassOf e:B   [a.ttl:2]\n"
            " 2. e:B SubClassOf e:C   [a.ttl:4]\nso\n"
            " 3. e:A SubClassOf e:C   from 1 and 2 by a chain of subclasses\n");
  const Outcome json =
      program_.run({"explain", "a.ttl", "--sub", "e:N", "--super", "owl:Nothing", "--proof", "--json"});
  const boost::json::value proof = boost::json::parse(json.out).at("proofs").at(0);
  EXPECT_EQ(proof.at("steps").as_array().back().at("rule"), "negation");
}

TEST_F(Explain, TellsWhyTheOntologyContradictsItself) {
  program_.turtle("b.ttl", ":x a :A, :B .\n:A owl:disjointWith :B .\n:A a owl:Class . :B a owl:Class .\n");
  const Outcome outcome = program_.run({"explain", "b.ttl", "--inconsistent"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(StartsWith("The ontology contradicts itself, because:\n"), HasSubstr("e:x Type e:A"),
                                 HasSubstr("e:x Type e:B"), HasSubstr("e:A DisjointWith e:B")));
  const Outcome no = program_.run({"explain", "a.ttl", "--inconsistent"});
  EXPECT_EQ(no.status, 1);
  EXPECT_EQ(no.out, "The ontology does not contradict itself\n");
  EXPECT_EQ(program_.run({"explain", "a.ttl", "--sub", "e:A"}).status, 2);
}

TEST_F(Explain, JsonNamesAxiomsWithTheirPlaces) {
  const Outcome outcome = program_.run({"explain", "a.ttl", "--sub", "e:A", "--super", "e:C", "--json"});
  const boost::json::value found = boost::json::parse(outcome.out);
  EXPECT_EQ(found.at("entailed"), true);
  EXPECT_EQ(found.at("sub"), "http://e/A");
  EXPECT_EQ(found.at("axioms").at(1).at("file"), "a.ttl");
  EXPECT_EQ(found.at("axioms").at(1).at("line"), 4);
  const Outcome no = program_.run({"explain", "a.ttl", "--sub", "e:C", "--super", "e:A", "--json"});
  EXPECT_EQ(no.status, 1);
  EXPECT_EQ(boost::json::parse(no.out).at("entailed"), false);
}

/// bob is tired by a rule; eve is not, by the same rule.
constexpr std::string_view tired_robots =
    "Prefix(:=<http://e/#>) Prefix(xsd:=<http://www.w3.org/2001/XMLSchema#>)\n"
    "Prefix(swrlb:=<http://www.w3.org/2003/11/swrlb#>)\n"
    "Ontology(<http://e/> Declaration(DataProperty(:hours)) Declaration(NamedIndividual(:bob))\n"
    "DLSafeRule(Body(ClassAtom(:Robot Variable(<urn:x>)) DataPropertyAtom(:hours Variable(<urn:x>) Variable(<urn:h>))"
    " BuiltInAtom(swrlb:greaterThan Variable(<urn:h>) \"8\"^^xsd:integer)) Head(ClassAtom(:Tired Variable(<urn:x>))))\n"
    "ClassAssertion(:Goalie :bob) ClassAssertion(:Robot :eve) DataPropertyAssertion(:hours :eve \"8\"^^xsd:integer)\n"
    "SubClassOf(:Goalie :Robot) SubClassOf(:Tired :Unfit)\n"
    "DataPropertyAssertion(:hours :bob \"12\"^^xsd:integer))\n";

TEST(ExplainIndividuals, SaysWhyAnIndividualIsInAClassWithTheRulesThatPutItThere) {
  const Program program;
  program.write("a.ofn", tired_robots);
  const std::string reasons =
      ":bob Type :Goalie   [a.ofn:5]\n:bob Fact :hours \"12\"^^xsd:integer   [a.ofn:7]\n"
      ":Goalie SubClassOf :Robot   [a.ofn:6]\n:hours(?x, ?h), :Robot(?x), ?h > 8 -> :Tired(?x)   [a.ofn:4]\n"
      ":Tired SubClassOf :Unfit   [a.ofn:6]\n";
  EXPECT_EQ(program.run({"explain", "a.ofn", "--individual", ":bob", "--super", ":Unfit"}).out,
            ":bob is in :Unfit, because:\n" + reasons);
  EXPECT_EQ(program.run({"explain", "a.ofn", "--sub", "{:bob}", "--super", ":Unfit"}).out,
            "{:bob} is subsumed by :Unfit, because:\n" + reasons);
  EXPECT_EQ(program.run({"explain", "a.ofn", "--individual", "bob", "--super", ":Robot and :Unfit", "--laconic"}).out,
            ":bob is in :Robot and :Unfit, because:\n" + reasons);
  const Outcome proof = program.run({"explain", "a.ofn", "--individual", ":bob", "--super", ":Robot", "--proof"});
  EXPECT_THAT(proof.out, HasSubstr("<about:individual> EquivalentTo {:bob}\n"));
  const Outcome json = program.run({"explain", "a.ofn", "--individual", ":bob", "--super", ":Robot", "--json"});
  EXPECT_THAT(json.out, HasSubstr("{\"individual\":\"http://e/#bob\",\"super\":\"http://e/#Robot\",\"entailed\":true"));
  EXPECT_THAT(json.out, Not(HasSubstr("about:")));
}

TEST(ExplainIndividuals, SaysWhatIsNotSoOfIndividualsAndExpressions) {
  const Program program;
  program.write("a.ofn", tired_robots);
  const Outcome eve = program.run({"explain", "a.ofn", "--individual", ":eve", "--super", ":Tired"});
  EXPECT_EQ(eve.status, 1);
  EXPECT_EQ(eve.out, ":eve need not be in :Tired\n");
  const Outcome always =
      program.run({"explain", "a.ofn", "--sub", ":Robot and :Tired", "--super", ":Tired or :Goalie"});
  EXPECT_EQ(always.status, 0);
  EXPECT_THAT(always.out, HasSubstr(": that is so in every ontology\n"));
  const Outcome unknown = program.run({"explain", "a.ofn", "--individual", ":bobb", "--super", ":Tired"});
  EXPECT_EQ(unknown.status, 2);
  EXPECT_THAT(unknown.err, HasSubstr("did you mean :bob?"));
  for (const std::string words : {":bob, :eve", ":bob} or {:eve", ":bob} and {:eve", ""}) {
    const Outcome odd = program.run({"explain", "a.ofn", "--individual", words, "--super", ":Tired"});
    EXPECT_EQ(odd.status, 2) << words;
  }
  EXPECT_EQ(program.run({"explain", "a.ofn", "--individual", ":bob", "--sub", ":Robot", "--super", ":Tired"}).status,
            2);
  EXPECT_EQ(program.run({"compile", "a.ofn", "-o", "a.geminga"}).status, 0);
  const Outcome compiled = program.run({"explain", "a.geminga", "--individual", ":bob", "--super", ":Tired"});
  EXPECT_EQ(compiled.status, 2);
  EXPECT_THAT(compiled.err, HasSubstr("a compiled file explains classes alone"));
}

}  // namespace
}  // namespace geminga::ontology
