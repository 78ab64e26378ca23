// convert and infer in OWL's own syntaxes, run as a user runs them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "program.hpp"
#include "team.hpp"

namespace geminga::ontology {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(Convert, WritesTheSyntaxesOfOwlWithAllThatTriplesSay) {
  const Program program;
  program.turtle("team.ttl", std::string(team) +
                                 " [] a owl:Axiom ; owl:annotatedSource :Goalie ; owl:annotatedProperty "
                                 "owl:equivalentClass ; owl:annotatedTarget :Nowhere ; rdfs:comment \"lost\" . "
                                 "[] a owl:Axiom ; owl:annotatedSource :Ball ; owl:annotatedProperty rdfs:subClassOf ; "
                                 "owl:annotatedTarget :Thing ; rdfs:comment \"of an axiom\" .");
  for (const std::string out : {"out.ofn", "out.omn", "out.owx"}) {
    const Outcome outcome = program.run({"convert", "team.ttl", "-o", out});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(closure_of(program, out), closure_of(program, "team.ttl")) << out << program.read(out);
    EXPECT_THAT(program.read(out), HasSubstr("a comment")) << out;
    EXPECT_THAT(program.read(out), HasSubstr("of an axiom")) << out;
    EXPECT_THAT(program.read(out), HasSubstr("the team")) << out;
    EXPECT_EQ(program.run({"convert", out, "-o", "again.ttl"}).status, 0);
    EXPECT_THAT(program.read("again.ttl"), HasSubstr("of an axiom")) << out;
    EXPECT_EQ(closure_of(program, "again.ttl"), closure_of(program, "team.ttl")) << out;
  }
  EXPECT_THAT(program.read("out.ofn"),
              HasSubstr("SubClassOf(Annotation(rdfs:comment \"of an axiom\") e:Ball e:Thing)"));
  EXPECT_THAT(program.run({"convert", "team.ttl", "-o", "-", "--to", "manchester"}).out, HasSubstr("Class: e:Robot\n"));
  EXPECT_THAT(program.run({"convert", "team.ttl", "-o", "x.txt"}).err, HasSubstr("functional, manchester or owlxml"));
}

TEST(Convert, WritesManchesterSyntaxWithAFrameForEachNameAsTheOwlApiNeedsIt) {
  const Program program;
  program.write("in.ofn",
                "Prefix(:=<http://e/>) Ontology(<http://e/> ClassAssertion(:A :i) HasKey(:A (:p) (:d)) "
                "AnnotationAssertion(:note :A :elsewhere))");
  const std::string text = program.run({"convert", "in.ofn", "-o", "-", "--to", "manchester"}).out;
  for (const std::string frame :
       {"Class: :A\n", "Individual: :i\n", "ObjectProperty: :p\n", "DataProperty: :d\n", "AnnotationProperty: :note\n"})
    EXPECT_THAT(text, HasSubstr(frame));
  EXPECT_THAT(text, HasSubstr("HasKey: :p, :d\n"));
  EXPECT_THAT(text, HasSubstr("Annotations: :note <http://e/elsewhere>\n"));
}

TEST(Convert, WritesTriplesThatAreReadAsTheSameAxiomsWhereNothingIsDeclared) {
  const Program program;
  program.write("in.ofn",
                "Prefix(:=<http://e/>) Ontology(<http://e/> DataPropertyAssertion(:d :i \"x\") "
                "ObjectPropertyAssertion(:p :i :j) SubClassOf(:A DataSomeValuesFrom(:d DatatypeRestriction(xsd:integer "
                "xsd:minInclusive \"1\"^^xsd:integer))) "
                "SubObjectPropertyOf(Annotation(:note \"c\") ObjectPropertyChain(:p :q) :r))");
  for (const std::string out : {"out.ttl", "out.rdf"}) {
    EXPECT_EQ(program.run({"convert", "in.ofn", "-o", out}).status, 0);
    const Outcome again = program.run({"convert", out, "-o", "-", "--to", "functional"});
    for (const std::string axiom : {"DataPropertyAssertion(:d :i \"x\")", "ObjectPropertyAssertion(:p :i :j)",
                                    "SubObjectPropertyOf(Annotation(:note \"c\") ObjectPropertyChain(:p :q) :r)",
                                    "xsd:minInclusive \"1\"^^xsd:integer"})
      EXPECT_THAT(again.out, HasSubstr(axiom)) << out << again.err;
    EXPECT_THAT(again.out, Not(HasSubstr("AnnotationAssertion"))) << out;
  }
}

TEST(Convert, TakesNoCellOfAListForAFactWhereAFileDeclaresItsVocabulary) {
  const Program program;
  program.turtle("in.ttl",
                 ":p a owl:ObjectProperty ; rdfs:domain [ owl:unionOf ( :A :B ) ; a owl:Class ] . :A a owl:Class . "
                 ":B a owl:Class . <http://www.w3.org/1999/02/22-rdf-syntax-ns#first> a owl:ObjectProperty .");
  const std::string text = program.run({"convert", "in.ttl", "-o", "-", "--to", "functional"}).out;
  EXPECT_THAT(text, HasSubstr("ObjectUnionOf("));
  EXPECT_THAT(text, Not(HasSubstr("ObjectPropertyAssertion")));
}

TEST(Infer, WritesTheSyntaxesOfOwl) {
  const Program program;
  program.turtle("team.ttl", team);
  EXPECT_EQ(program.run({"infer", "team.ttl", "--only-inferred", "-o", "new.ofn"}).status, 0);
  EXPECT_THAT(program.read("new.ofn"), HasSubstr("\nClassAssertion(e:Goalie e:bob)\n"));
  EXPECT_THAT(program.read("new.ofn"), Not(HasSubstr("SubClassOf(e:Robot e:Thing)")));
  EXPECT_EQ(program.run({"infer", "team.ttl", "-o", "all.omn"}).status, 0);
  EXPECT_THAT(program.read("all.omn"), HasSubstr("a comment"));
  EXPECT_THAT(program.read("all.omn"), Not(HasSubstr("urn:geminga:only:")));
  EXPECT_EQ(closure_of(program, "all.omn"), closure_of(program, "team.ttl"));
}

}  // namespace
}  // namespace geminga::ontology
