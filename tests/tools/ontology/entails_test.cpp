// entails and consistent: answers, exit statuses, undecided questions, and broken files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/json.hpp>

#include "tools/ontology/program.hpp"

namespace geminga::ontology {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

TEST(Entails, TellsByItsStatusWhetherAllOfTheConclusionFollows) {
  const Program program;
  program.turtle("premise.ttl", ":A rdfs:subClassOf :B . :B rdfs:subClassOf [ owl:unionOf (:C :D) ] . :i a :A .\n");
  program.turtle("yes.ttl", ":A rdfs:subClassOf [ owl:unionOf (:D :C) ] . :i a :B .\n");
  program.turtle("no.ttl", ":i a :B .\n:i a :C .\n");
  const Outcome yes = program.run({"entails", "premise.ttl", "yes.ttl"});
  EXPECT_EQ(yes.status, 0) << yes.out << yes.err;
  EXPECT_THAT(yes.out, HasSubstr("follow.\n"));
  EXPECT_THAT(yes.err, IsEmpty());
  const Outcome no = program.run({"entails", "premise.ttl", "no.ttl"});
  EXPECT_EQ(no.status, 1);
  EXPECT_EQ(no.out,
            "follows:         e:i Type e:B   [no.ttl:2]\n"
            "does not follow: e:i Type e:C   [no.ttl:3]\n");
}

TEST(Entails, KeepsPremiseAndConclusionApartEvenWhereTheyShareAFile) {
  const Program program;
  program.turtle("a.ttl", ":A rdfs:subClassOf :B .\n");
  program.turtle("b.ttl", ":B rdfs:subClassOf :A .\n");
  EXPECT_EQ(program.run({"entails", "a.ttl", "b.ttl"}).status, 1);
  EXPECT_EQ(program.run({"entails", "a.ttl", "a.ttl"}).status, 0);
  EXPECT_EQ(program.run({"entails", ".", "b.ttl"}).status, 0);
  EXPECT_EQ(program.run({"entails", "b.ttl", "."}).status, 1);
}

TEST(Entails, ReadsEverySyntaxOnEitherSide) {
  const Program program;
  program.write("premise.ofn",
                "Prefix(e:=<http://e/>)\nOntology(TransitiveObjectProperty(e:p)\n"
                "ObjectPropertyAssertion(e:p e:a e:b) ObjectPropertyAssertion(e:p e:b e:c))\n");
  program.turtle("conclusion.ttl", ":p a owl:ObjectProperty . :a :p :c . [] a owl:Thing ; :p :c .\n");
  EXPECT_EQ(program.run({"entails", "premise.ofn", "conclusion.ttl"}).status, 0);
}

TEST(Entails, SaysWhyItCannotDecide) {
  const Program program;
  program.turtle("premise.ttl", ":A rdfs:subClassOf :B . :A owl:newInOwl3 :C .\n");
  program.turtle("follows.ttl", ":A rdfs:subClassOf :B .\n");
  program.turtle("not.ttl", ":B rdfs:subClassOf :A .\n");
  EXPECT_EQ(program.run({"entails", "premise.ttl", "follows.ttl"}).status, 0) << "more premises take nothing away";
  const Outcome unknown = program.run({"entails", "premise.ttl", "not.ttl"});
  EXPECT_EQ(unknown.status, 2);
  EXPECT_THAT(unknown.err, AllOf(StartsWith("geminga-ontology: it cannot be decided"),
                                 HasSubstr("owl:newInOwl3 is not understood: premise.ttl:2")));
  // In the conclusion it is one more axiom, for which it is undecided whether it follows.
  EXPECT_EQ(program.run({"entails", "follows.ttl", "premise.ttl"}).status, 2);
  EXPECT_EQ(program.run({"entails", "not.ttl", "premise.ttl"}).status, 1);
}

TEST(Entails, LeavesOpenOnlyWhatMayHangOnADamagedLiteral) {
  const Program program;
  program.turtle(
      "premise.ttl",
      ":age a owl:DatatypeProperty ; rdfs:domain :Person ; rdfs:range <http://www.w3.org/2001/XMLSchema#integer> .\n"
      ":bob :age \"twelve\"^^<http://www.w3.org/2001/XMLSchema#integer> .\n:Dog rdfs:subClassOf :Animal .\n");
  program.turtle("apart.ttl", ":Animal rdfs:subClassOf :Dog .\n");
  program.turtle("hangs.ttl", ":bob a :Person .\n");
  const Outcome no = program.run({"entails", "premise.ttl", "apart.ttl"});
  EXPECT_EQ(no.status, 1) << no.err;
  const Outcome open = program.run({"entails", "premise.ttl", "hangs.ttl"});
  EXPECT_EQ(open.status, 2);
  EXPECT_THAT(open.err, HasSubstr("it may hang on a literal that is not of its datatype: premise.ttl:3"));
  EXPECT_EQ(program.run({"consistent", "premise.ttl"}).status, 0) << "whatever bob's age is";
}

TEST(Entails, JsonHasEveryAxiom) {
  const Program program;
  program.turtle("premise.ttl", ":A rdfs:subClassOf :B .\n");
  program.turtle("conclusion.ttl", ":A rdfs:subClassOf :B .\n:B rdfs:subClassOf :A .\n");
  const Outcome outcome = program.run({"entails", "--json", "premise.ttl", "conclusion.ttl"});
  EXPECT_EQ(outcome.status, 1);
  const boost::json::value found = boost::json::parse(outcome.out);
  EXPECT_EQ(found.at("entailed"), false);
  std::size_t following = 0;
  for (const boost::json::value& axiom : found.at("axioms").as_array()) {
    following += axiom.at("entailed") == true ? 1U : 0U;
    if (axiom.at("entailed") == true) continue;
    EXPECT_EQ(axiom.at("axiom"), "e:B SubClassOf e:A");
    EXPECT_EQ(axiom.at("file"), "conclusion.ttl");
    EXPECT_EQ(axiom.at("line"), 3);
  }
  EXPECT_EQ(following + 1, found.at("axioms").as_array().size());
}

TEST(Entails, ABrokenFileIsStatusTwoAndJsonAllTheSame) {
  const Program program;
  program.turtle("good.ttl", ":A rdfs:subClassOf :B .\n");
  program.turtle("bad.ttl", ":A rdfs:subClassOf\n");
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{"entails", "--json", "good.ttl", "bad.ttl"},
                                             {"consistent", "--json", "bad.ttl"},
                                             {"check", "--json", "bad.ttl"}}) {
    const Outcome outcome = program.run(arguments);
    EXPECT_EQ(outcome.status, arguments.front() == "check" ? 1 : 2);
    EXPECT_THAT(boost::json::value_to<std::string>(boost::json::parse(outcome.out).at("error")),
                StartsWith("bad.ttl:3: "));
    EXPECT_THAT(outcome.err, StartsWith("geminga-ontology: bad.ttl:3: "));
  }
  EXPECT_EQ(program.run({"entails", "good.ttl"}).status, 2);
  EXPECT_EQ(program.run({"entails", "good.ttl", "missing.ttl"}).status, 2);
}

TEST(Consistent, TellsByItsStatus) {
  const Program program;
  program.turtle("yes.ttl", ":A owl:disjointWith :B . :i a :A .\n");
  program.turtle("no.ttl", ":i a :B .\n");
  const Outcome yes = program.run({"consistent", "yes.ttl"});
  EXPECT_EQ(yes.status, 0) << yes.err;
  EXPECT_THAT(yes.out, StartsWith("Consistent"));
  const Outcome no = program.run({"consistent", "yes.ttl", "no.ttl"});
  EXPECT_EQ(no.status, 1);
  EXPECT_THAT(no.out, StartsWith("Contradiction"));
  EXPECT_EQ(boost::json::parse(program.run({"consistent", "--json", "."}).out).at("consistent"), false);
}

TEST(Consistent, IsUndecidedWhereSomethingWasNotUnderstoodAndNothingIsWrongYet) {
  const Program program;
  program.turtle("odd.ttl", ":A owl:newInOwl3 :B .\n");
  program.turtle("wrong.ttl", ":i a owl:Nothing .\n");
  const Outcome unknown = program.run({"consistent", "odd.ttl"});
  EXPECT_EQ(unknown.status, 2);
  EXPECT_THAT(unknown.err, HasSubstr("owl:newInOwl3 is not understood: odd.ttl:2"));
  EXPECT_EQ(program.run({"consistent", "."}).status, 1);
  const boost::json::value found = boost::json::parse(program.run({"consistent", "--json", "odd.ttl"}).out);
  EXPECT_TRUE(found.at("consistent").is_null());
  EXPECT_THAT(boost::json::value_to<std::string>(found.at("reason")), HasSubstr("owl:newInOwl3"));
}

TEST(Consistent, IsDecidedWithoutTheImportsThatNobodyGave) {
  const Program program;
  program.turtle("a.ttl", "<http://e/o> a owl:Ontology ; owl:imports <http://e/nowhere> . :A rdfs:subClassOf :B .\n");
  const Outcome outcome = program.run({"consistent", "a.ttl"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.err, HasSubstr("a.ttl:2: imports <http://e/nowhere>, which no given file answers"));
}

TEST(Progress, IsNeverSeenWhereStandardErrorIsNoTerminal) {
  const Program program;
  std::string many;
  for (int at = 0; at < 60'000; ++at)
    many += ":C" + std::to_string(at) + " rdfs:subClassOf :C" + std::to_string(at / 2) + " .\n";
  program.turtle("many.ttl", many);
  const Outcome outcome = program.run({"classify", "many.ttl"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.err, IsEmpty());
  EXPECT_THAT(outcome.out, Not(HasSubstr("\r")));
}

}  // namespace
}  // namespace geminga::ontology
