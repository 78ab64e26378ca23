// convert and infer in OWL's own syntaxes, run as a user runs them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "program.hpp"
#include "team.hpp"

namespace geminga::ontology {
namespace {

using testing::Contains;
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

TEST(Convert, WritesManchesterSyntaxThatDeclaresNothingNewWithoutAWord) {
  const Program program;
  const std::string head = "Prefix(:=<http://e/>) Ontology(<http://e/> <http://e/1> ";
  program.write("in.ofn", head +
                              "Declaration(AnnotationProperty(:n)) AnnotationAssertion(:note :A \"x\") "
                              "SubClassOf(Annotation(:k \"x\") :A :B) SubAnnotationPropertyOf(:n :m) "
                              "AnnotationPropertyDomain(:o :A) AnnotationPropertyRange(:n :B) "
                              "AnnotationAssertion(:note _:x \"x\"))");
  const Outcome silent = program.run({"convert", "in.ofn", "-o", "out.omn"});
  EXPECT_EQ(silent.err, "");
  EXPECT_THAT(program.read("out.omn"),
              testing::AllOf(Not(HasSubstr("AnnotationProperty: rdfs:")), Not(HasSubstr("AnnotationProperty: owl:")),
                             HasSubstr("AnnotationProperty: :m\n")));
  EXPECT_EQ(program.run({"diff", "in.ofn", "out.omn"}).out, "Both say the same.\n");

  program.write("in.ofn", head + "AnnotationAssertion(owl:versionIRI :A \"x\") AnnotationAssertion(:note :A \"y\"))");
  const Outcome outcome = program.run({"convert", "in.ofn", "-o", "out.omn"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.err,
              HasSubstr("1 name that is the subject of annotations alone is written as an individual, because "
                        "Manchester syntax has no other place for the annotations: <http://e/A>\n"));
  EXPECT_EQ(program.run({"diff", "in.ofn", "out.omn"}).out, "Names: 0 removed, 1 added\n  + http://e/A\n");
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

TEST(Convert, WritesTriplesThatAreReadAsTheSameAnnotationsWhereNothingIsDeclared) {
  const Program program;
  program.write(
      "in.ofn",
      "Prefix(:=<http://e/>) Ontology(<http://e/> Annotation(:h \"x\") SubAnnotationPropertyOf(:n :m) "
      "AnnotationPropertyDomain(:o :A) AnnotationPropertyRange(:r :A) ClassAssertion(Annotation(:k \"x\") :A :i) "
      "AnnotationAssertion(:note :i \"x\")SubObjectPropertyOf(:p :q))");
  for (const std::string out : {"out.ttl", "out.nt", "out.owl"}) {
    EXPECT_EQ(program.run({"convert", "in.ofn", "-o", out}).status, 0);
    const Outcome outcome = program.run({"diff", "in.ofn", out});
    EXPECT_EQ(outcome.out, "Both say the same.\n") << program.read(out);
    EXPECT_THAT(program.run({"check", out, "--all"}).out, Not(HasSubstr("read as annotations"))) << out;
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

/// The axioms of a file without annotations: sorted lines of triples.
std::vector<std::string> axioms_of(const Program& program, const std::string& file) {
  const Outcome outcome = program.run({"convert", file, "-o", "-", "--to", "ntriples"});
  EXPECT_EQ(outcome.status, 0) << file << outcome.err;
  std::vector<std::string> lines;
  std::istringstream text(outcome.out);
  for (std::string line; std::getline(text, line);) {
    if (line.find("#Ontology>") == std::string::npos) lines.push_back(line);
  }
  std::ranges::sort(lines);
  return lines;
}

TEST(Infer, WritesTheSameAxiomsInEverySyntaxWithTheirNamesDeclared) {
  const Program program;
  program.turtle(
      "in.ttl",
      ":Robot a owl:Class . :sees a owl:ObjectProperty ; owl:inverseOf :seenBy ; rdfs:domain :Robot . :seenBy a "
      "owl:ObjectProperty . :speed a owl:DatatypeProperty ; rdfs:subPropertyOf :number . :number a "
      "owl:DatatypeProperty . :name a owl:DatatypeProperty ; rdfs:subPropertyOf :word . :word a owl:DatatypeProperty . "
      ":id a owl:ObjectProperty , owl:FunctionalProperty . :never a owl:DatatypeProperty ; rdfs:range "
      "xsd:integer , xsd:string . :ball a owl:NamedIndividual . :x a owl:NamedIndividual . :y a owl:NamedIndividual . "
      ":bob a owl:NamedIndividual ; :sees :ball . :bob :sees :ball ; :speed 1 ; :name \"Bob\"@en , \"bob\" ; :id :x , "
      ":y . ");
  const std::string e = "<http://e/";
  const std::string type = "> <http://www.w3.org/1999/02/22-rdf-syntax-ns#type> ";
  const std::string owl = "<http://www.w3.org/2002/07/owl#";
  for (const std::string only : {"--only-inferred", "--closure"}) {
    std::vector<std::string> expected;
    for (const std::string name : {"out.nt", "out.ttl", "out.owl", "out.ofn", "out.omn", "out.owx"}) {
      ASSERT_EQ(program.run({"infer", "in.ttl", "--facts", only, "-o", name}).status, 0) << name;
      const std::vector<std::string> axioms = axioms_of(program, name);
      if (expected.empty()) expected = axioms;
      EXPECT_EQ(axioms, expected) << name << ' ' << only;
    }
    for (const std::string& axiom :
         {e + "ball> " + e + "seenBy> " + e + "bob> .", e + "bob> " + e + "word> \"Bob\"@en .",
          e + "bob> " + e + "word> \"bob\" .", e + "x> " + owl + "sameAs> " + e + "y> .",
          e + "bob> " + e + "number> \"1\"^^<http://www.w3.org/2001/XMLSchema#integer> .",
          e + "bob" + type + e + "Robot> .", e + "Robot" + type + owl + "Class> .",
          e + "seenBy" + type + owl + "ObjectProperty> .", e + "word" + type + owl + "DatatypeProperty> ."})
      EXPECT_THAT(expected, Contains(axiom)) << only;
    EXPECT_THAT(expected, Not(Contains(HasSubstr("ball" + type + owl + "Class>")))) << only;
    EXPECT_THAT(expected, Not(Contains(HasSubstr("bob" + type + owl + "Class>")))) << only;
  }
}

}  // namespace
}  // namespace geminga::ontology
