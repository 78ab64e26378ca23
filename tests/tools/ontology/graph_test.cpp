// infer, convert, merge and query, run as a user runs them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

#include "program.hpp"
#include "team.hpp"

namespace geminga::ontology {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

TEST(Convert, GivesTheSameClosureInEverySyntax) {
  const Program program;
  program.turtle("team.ttl", team);
  for (const std::string out : {"out.ttl", "out.owl", "out.nt"}) {
    const Outcome outcome = program.run({"convert", "team.ttl", "-o", out});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(closure_of(program, out), closure_of(program, "team.ttl")) << out;
    EXPECT_THAT(program.read(out), HasSubstr("a comment")) << out;
  }
  EXPECT_THAT(program.read("out.ttl"), HasSubstr("rdfs:comment"));
  EXPECT_THAT(program.run({"convert", "team.ttl", "-o", "-", "--to", "rdfxml"}).out, HasSubstr("<rdf:RDF"));
}

TEST(Convert, ReadsEverySyntaxOfOwl) {
  const Program program;
  program.write("a.omn",
                "Prefix: : <http://e/>\nOntology: <http://e/o>\nObjectProperty: p\nClass: A\n  Annotations: rdfs:label "
                "\"an A\"@en\n  SubClassOf: p some (B or C)\nClass: B SubClassOf: D\nClass: C SubClassOf: D\nClass: D\n"
                "Class: E EquivalentTo: p some D\n");
  program.write("b.ofn",
                "Prefix(:=<http://e/>) Ontology(<http://e/o> Declaration(ObjectProperty(:p)) "
                "AnnotationAssertion(rdfs:label :A \"an A\"@en) SubClassOf(:A ObjectSomeValuesFrom(:p ObjectUnionOf(:B "
                ":C))) SubClassOf(:B :D) SubClassOf(:C :D) EquivalentClasses(:E ObjectSomeValuesFrom(:p :D)))");
  program.write(
      "c.owx",
      "<Ontology xmlns='http://www.w3.org/2002/07/owl#' xml:base='http://e/' ontologyIRI='http://e/o'>"
      "<Declaration><ObjectProperty IRI='p'/></Declaration><AnnotationAssertion><AnnotationProperty "
      "abbreviatedIRI='rdfs:label'/><IRI>A</IRI><Literal xml:lang='en'>an A</Literal></AnnotationAssertion>"
      "<SubClassOf><Class IRI='A'/><ObjectSomeValuesFrom><ObjectProperty IRI='p'/><ObjectUnionOf><Class "
      "IRI='B'/><Class IRI='C'/></ObjectUnionOf></ObjectSomeValuesFrom></SubClassOf><SubClassOf><Class IRI='B'/>"
      "<Class IRI='D'/></SubClassOf><SubClassOf><Class IRI='C'/><Class IRI='D'/></SubClassOf>"
      "<EquivalentClasses><Class IRI='E'/><ObjectSomeValuesFrom><ObjectProperty IRI='p'/><Class IRI='D'/>"
      "</ObjectSomeValuesFrom></EquivalentClasses></Ontology>");
  const std::string closure = closure_of(program, "b.ofn");
  EXPECT_THAT(closure, HasSubstr("http://e/A\thttp://e/E\n"));
  for (const std::string file : {"a.omn", "b.ofn", "c.owx"}) {
    EXPECT_EQ(closure_of(program, file), closure) << file;
    EXPECT_EQ(program.run({"convert", file, "-o", "out.ttl"}).status, 0) << file;
    EXPECT_EQ(closure_of(program, "out.ttl"), closure) << file;
    EXPECT_THAT(program.read("out.ttl"), HasSubstr("\"an A\"@en")) << file;
    EXPECT_THAT(program.read("out.ttl"), HasSubstr("owl:Ontology")) << file;
  }
}

/// One ontology in OWL's three own syntaxes, with an annotation wherever one may stand.
constexpr std::string_view annotated_functional =
    "Prefix(:=<http://e/>)\nOntology(<http://e/o> <http://e/o/1>\n"
    "Annotation(Annotation(:n \"of of o\") :n \"of o\")\n"
    "Declaration(Annotation(:n \"of declaration\") Class(:A)) Declaration(Class(:B)) Declaration(Class(:C))\n"
    "Declaration(AnnotationProperty(:n)) Declaration(AnnotationProperty(:m)) SubAnnotationPropertyOf(:m :n)\n"
    "AnnotationPropertyRange(:m <http://www.w3.org/2001/XMLSchema#string>)\n"
    "AnnotationAssertion(Annotation(:n \"of label\") rdfs:label :A \"an A\"@en)\n"
    "SubClassOf(Annotation(Annotation(:n \"deep\") :n _:x) Annotation(:m \"5\"^^xsd:integer) :A :B)\n"
    "DisjointClasses(Annotation(:n \"of three\") :A :C :D)\n"
    "EquivalentClasses(Annotation(:n \"of pairs\") :E :F :G)\n"
    "ClassAssertion(Annotation(:n \"of fact\") :A _:x)\n"
    "NegativeObjectPropertyAssertion(Annotation(:n \"of negative\") :p :i :j)\n"
    "DataPropertyAssertion(Annotation(:n \"of damaged\") :d :i \"five\"^^xsd:integer)\n"
    "SubClassOf(Annotation(:n \"of some\") :A ObjectSomeValuesFrom(:p :B)))\n";
constexpr std::string_view annotated_manchester =
    "Prefix: : <http://e/>\nOntology: <http://e/o> <http://e/o/1>\nAnnotations: Annotations: n \"of of o\" n \"of o\"\n"
    "AnnotationProperty: n\nAnnotationProperty: m\n  SubPropertyOf: n\n  Range: xsd:string\n"
    "ObjectProperty: p\nDataProperty: d\n"
    "Class: A\n  Annotations: Annotations: n \"of label\" rdfs:label \"an A\"@en\n"
    "  SubClassOf: Annotations: Annotations: n \"deep\" n _:x, m 5 B, Annotations: n \"of some\" p some B\n"
    "DisjointClasses: Annotations: n \"of three\" A, C, D\nEquivalentClasses: Annotations: n \"of pairs\" E, F, G\n"
    "Individual: _:x\n  Types: Annotations: n \"of fact\" A\n"
    "Individual: i\n  Facts: Annotations: n \"of negative\" not p j, Annotations: n \"of damaged\" d "
    "\"five\"^^xsd:integer\n"
    "Class: B\nClass: C\nClass: D\nClass: E\nClass: F\nClass: G\nIndividual: j\n";
constexpr std::string_view annotated_xml =
    "<Ontology xmlns='http://www.w3.org/2002/07/owl#' xml:base='http://e/' ontologyIRI='http://e/o' "
    "versionIRI='http://e/o/1'>"
    "<Annotation><Annotation><AnnotationProperty IRI='n'/><Literal>of of o</Literal></Annotation>"
    "<AnnotationProperty IRI='n'/><Literal>of o</Literal></Annotation>"
    "<Declaration><Annotation><AnnotationProperty IRI='n'/><Literal>of declaration</Literal></Annotation>"
    "<Class IRI='A'/></Declaration><Declaration><Class IRI='B'/></Declaration>"
    "<SubAnnotationPropertyOf><AnnotationProperty IRI='m'/><AnnotationProperty IRI='n'/></SubAnnotationPropertyOf>"
    "<AnnotationPropertyRange><AnnotationProperty IRI='m'/><IRI>http://www.w3.org/2001/XMLSchema#string</IRI>"
    "</AnnotationPropertyRange>"
    "<AnnotationAssertion><Annotation><AnnotationProperty IRI='n'/><Literal>of label</Literal></Annotation>"
    "<AnnotationProperty abbreviatedIRI='rdfs:label'/><IRI>A</IRI><Literal xml:lang='en'>an A</Literal>"
    "</AnnotationAssertion>"
    "<SubClassOf><Annotation><Annotation><AnnotationProperty IRI='n'/><Literal>deep</Literal></Annotation>"
    "<AnnotationProperty IRI='n'/><AnonymousIndividual nodeID='x'/></Annotation><Annotation><AnnotationProperty "
    "IRI='m'/><Literal datatypeIRI='http://www.w3.org/2001/XMLSchema#integer'>5</Literal></Annotation>"
    "<Class IRI='A'/><Class IRI='B'/></SubClassOf>"
    "<DisjointClasses><Annotation><AnnotationProperty IRI='n'/><Literal>of three</Literal></Annotation><Class "
    "IRI='A'/><Class IRI='C'/><Class IRI='D'/></DisjointClasses>"
    "<EquivalentClasses><Annotation><AnnotationProperty IRI='n'/><Literal>of pairs</Literal></Annotation><Class "
    "IRI='E'/><Class IRI='F'/><Class IRI='G'/></EquivalentClasses>"
    "<ClassAssertion><Annotation><AnnotationProperty IRI='n'/><Literal>of fact</Literal></Annotation><Class "
    "IRI='A'/><AnonymousIndividual nodeID='x'/></ClassAssertion>"
    "<NegativeObjectPropertyAssertion><Annotation><AnnotationProperty IRI='n'/><Literal>of negative</Literal>"
    "</Annotation><ObjectProperty IRI='p'/><NamedIndividual IRI='i'/><NamedIndividual IRI='j'/>"
    "</NegativeObjectPropertyAssertion>"
    "<DataPropertyAssertion><Annotation><AnnotationProperty IRI='n'/><Literal>of damaged</Literal></Annotation>"
    "<DataProperty IRI='d'/><NamedIndividual IRI='i'/><Literal "
    "datatypeIRI='http://www.w3.org/2001/XMLSchema#integer'>five</Literal></DataPropertyAssertion>"
    "<SubClassOf><Annotation><AnnotationProperty IRI='n'/><Literal>of some</Literal></Annotation><Class IRI='A'/>"
    "<ObjectSomeValuesFrom><ObjectProperty IRI='p'/><Class IRI='B'/></ObjectSomeValuesFrom></SubClassOf></Ontology>";

TEST(Convert, WritesAnnotationsOfAxiomsAndOfAnnotations) {
  const Program program;
  program.write("a.ofn", annotated_functional);
  program.write("b.omn", annotated_manchester);
  program.write("c.owx", annotated_xml);
  const std::string axiom =
      "?x a owl:Axiom ; owl:annotatedSource :A ; owl:annotatedProperty rdfs:subClassOf ; owl:annotatedTarget ";
  const std::string questions[] = {
      axiom +
          ":B ; :n ?blank ; :m 5 . ?y a owl:Annotation ; owl:annotatedSource ?x ; owl:annotatedProperty :n ; "
          "owl:annotatedTarget ?blank ; :n \"deep\" . ?blank a :A",
      axiom + "?some ; :n \"of some\" . :A rdfs:subClassOf ?some . ?some owl:someValuesFrom :B",
      ("?x a owl:Axiom ; owl:annotatedSource :A ; owl:annotatedProperty rdfs:label ; owl:annotatedTarget \"an A\"@en ; "
       ":n \"of label\""),
      "?all a owl:AllDisjointClasses ; :n \"of three\"",
      ("?x owl:annotatedSource :E ; owl:annotatedTarget :F ; :n \"of pairs\" . ?y owl:annotatedSource :F ; "
       "owl:annotatedTarget :G ; :n \"of pairs\""),
      "?x owl:annotatedSource ?i ; owl:annotatedProperty rdf:type ; :n \"of fact\" . ?i a :A",
      "?x a owl:NegativePropertyAssertion ; :n \"of negative\"",
      "?x owl:annotatedSource :i ; owl:annotatedProperty :d ; :n \"of damaged\" . :i :d ?five",
      "<http://e/o> a owl:Ontology ; owl:versionIRI <http://e/o/1> ; :n \"of o\" . ?x a owl:Annotation ; "
      "owl:annotatedSource <http://e/o> ; owl:annotatedTarget \"of o\" ; :n \"of of o\"",
      ":m rdfs:subPropertyOf :n ; rdfs:range xsd:string",
  };
  for (const std::string file : {"a.ofn", "b.omn", "c.owx"}) {
    for (const std::string out : {"out.ttl", "out.owl", "out.nt"}) {
      const Outcome converted = program.run({"convert", file, "-o", out});
      ASSERT_EQ(converted.status, 0) << converted.err;
      EXPECT_THAT(converted.err, IsEmpty()) << file;
      EXPECT_EQ(closure_of(program, out), closure_of(program, file)) << file << out;
      for (const std::string& question : questions) {
        const Outcome asked =
            program.run({"query", out, "PREFIX : <http://e/> ASK { " + question + " }", "--asserted"});
        EXPECT_EQ(asked.status, 0) << file << ' ' << out << ' ' << question << asked.err;
      }
      EXPECT_THAT(program.run({"check", out}).out, Not(HasSubstr("owl:Axiom"))) << "what is reified is there";
    }
  }
}

TEST(Convert, KeepsRulesInEverySyntax) {
  const Program program;
  const std::string rule =
      "DLSafeRule(Annotation(isEnabled \"true\"^^xsd:boolean) Body(ClassAtom(A Variable(x)) DataPropertyAtom(d "
      "Variable(x) "
      "Variable(v)) BuiltInAtom(lessThan Variable(v) \"5\"^^xsd:integer)) Head(ObjectPropertyAtom(p Variable(x) i)))";
  program.write(
      "rule.ofn",
      "Prefix(:=<http://e/>)\nOntology(<http://e/o>\nDeclaration(DataProperty(:isEnabled))\n"
      "DLSafeRule(Annotation(:isEnabled \"true\"^^xsd:boolean) Body(ClassAtom(:A Variable(:x)) DataPropertyAtom(:d "
      "Variable(:x) Variable(:v)) BuiltInAtom(<http://www.w3.org/2003/11/swrlb#lessThan> Variable(:v) "
      "\"5\"^^xsd:integer)) Head(ObjectPropertyAtom(:p Variable(:x) :i)))\n)\n");
  // RDF/XML names a prefix of its own, and N-Triples none.
  const std::regex name("<http://[^>]*[/#](\\w+)>|\\b(?:ns\\d+):(\\w+)|([ (]):(\\w+)");
  for (const std::string file : {"out.ttl", "out.owl", "out.nt", "out.ofn", "out.omn", "out.owx"}) {
    ASSERT_EQ(program.run({"convert", "rule.ofn", "-o", file}).status, 0);
    const Outcome again = program.run({"convert", file, "-o", "-", "--to", "functional"});
    EXPECT_EQ(again.status, 0) << again.err;
    EXPECT_THAT(again.err, IsEmpty()) << file;
    EXPECT_THAT(std::regex_replace(again.out, name, "$1$2$3$4"), HasSubstr(rule)) << file;
    EXPECT_THAT(again.out, Not(HasSubstr("DataPropertyAssertion"))) << file;
  }
}

TEST(Convert, KeepsABlankNodeOneNodeWhateverItsLabelIs) {
  const Program program;
  program.turtle("a.ttl",
                 "_:x_1 :p :A . :B :q _:x_1 . :C :r _:x_1 , _:xZ1 , _:x.1 , _:x-1 . _:xZ1 :p :D . :B :s _:xZ1 .\n");
  for (const std::string out : {"out.ttl", "out.owl", "out.nt"}) {
    ASSERT_EQ(program.run({"convert", "a.ttl", "-o", out}).status, 0);
    const Outcome asked = program.run(
        {"query", out, "PREFIX : <http://e/> ASK { ?x :p :A . :B :q ?x . :C :r ?x , ?y . ?y :p :D . :B :s ?y }",
         "--asserted"});
    EXPECT_EQ(asked.status, 0) << program.read(out);
    EXPECT_THAT(
        program
            .run({"query", out, "SELECT DISTINCT ?x { <http://e/C> <http://e/r> ?x }", "--asserted", "--format", "csv"})
            .out,
        testing::ResultOf([](const std::string& csv) { return std::ranges::count(csv, '\n'); }, 5))
        << "four nodes and the head";
  }
}

TEST(Convert, NamesWhatItCannotWrite) {
  const Program program;
  program.write("a.ofn", "Prefix(:=<http://e/>)\nOntology(SubClassOf(:A :B)\nDGRule(Body() Head()))\n");
  const Outcome outcome = program.run({"convert", "a.ofn", "-o", "-"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.err, HasSubstr("a.ofn:3: DGRule is not written"));
}

TEST(Convert, KeepsTheAnnotationsOfNamesAndOfTheOntology) {
  const Program program;
  program.write(
      "a.omn",
      "Prefix: : <http://e/>\nOntology: <http://e/o>\nAnnotations: rdfs:comment \"of o\"\nAnnotationProperty: n\n"
      "Class: A\n  Annotations: rdfs:comment \"of A\"@de, :n 5, :n :B\n");
  program.write("b.ofn",
                "Prefix(:=<http://e/>) Ontology(<http://e/o> Annotation(rdfs:comment \"of o\") "
                "Declaration(AnnotationProperty(:n)) Declaration(Class(:A)) AnnotationAssertion(rdfs:comment :A \"of "
                "A\"@de) AnnotationAssertion(:n :A \"5\"^^xsd:integer) AnnotationAssertion(:n :A :B))");
  program.write("c.owx",
                "<Ontology xmlns='http://www.w3.org/2002/07/owl#' xml:base='http://e/' ontologyIRI='http://e/o'>"
                "<Annotation><AnnotationProperty abbreviatedIRI='rdfs:comment'/><Literal>of o</Literal></Annotation>"
                "<Declaration><AnnotationProperty IRI='n'/></Declaration><Declaration><Class IRI='A'/></Declaration>"
                "<AnnotationAssertion><AnnotationProperty abbreviatedIRI='rdfs:comment'/><IRI>A</IRI><Literal "
                "xml:lang='de'>of A</Literal></AnnotationAssertion><AnnotationAssertion><AnnotationProperty IRI='n'/>"
                "<IRI>A</IRI><Literal datatypeIRI='http://www.w3.org/2001/XMLSchema#integer'>5</Literal>"
                "</AnnotationAssertion><AnnotationAssertion><AnnotationProperty IRI='n'/><IRI>A</IRI><IRI>B</IRI>"
                "</AnnotationAssertion></Ontology>");
  const std::string written = program.run({"convert", "a.omn", "-o", "-", "--to", "nt"}).out;
  EXPECT_THAT(written, HasSubstr("<http://e/o> <http://www.w3.org/2000/01/rdf-schema#comment> \"of o\" .\n"));
  EXPECT_THAT(written, HasSubstr("<http://e/A> <http://www.w3.org/2000/01/rdf-schema#comment> \"of A\"@de .\n"));
  EXPECT_THAT(written, HasSubstr("<http://e/A> <http://e/n> \"5\"^^<http://www.w3.org/2001/XMLSchema#integer> .\n"));
  EXPECT_THAT(written, HasSubstr("<http://e/A> <http://e/n> <http://e/B> .\n"));
  for (const std::string file : {"b.ofn", "c.owx"})
    EXPECT_EQ(program.run({"convert", file, "-o", "-", "--to", "nt"}).out, written) << file;
}

TEST(Convert, RefusesManyFilesWrongFormatsAndItsOwnSource) {
  const Program program;
  program.turtle("a.ttl", ":A a owl:Class .");
  program.turtle("b.ttl", ":B a owl:Class .");
  EXPECT_THAT(program.run({"convert", "a.ttl", "b.ttl", "-o", "c.ttl"}).err, HasSubstr("geminga-ontology merge"));
  EXPECT_EQ(program.run({"convert", "a.ttl", "-o", "c.ttl", "--to", "json"}).status, 2);
  EXPECT_THAT(program.run({"convert", "a.ttl", "-o", "c.txt"}).err, HasSubstr("c.txt: the name ends in none of .ttl"));
  EXPECT_THAT(program.run({"convert", "a.ttl", "-o", "a.ttl"}).err, HasSubstr("is one of the sources"));
}

TEST(Merge, MakesOneOntologyOfManyWithTheFirstNameAndNoImportOfItself) {
  const Program program;
  program.turtle("a.ttl",
                 "<http://e/a> a owl:Ontology ; owl:imports <http://e/b>, <http://e/c> . :A a owl:Class ; "
                 "rdfs:subClassOf :B .");
  program.turtle("b.ttl",
                 "<http://e/b> a owl:Ontology ; rdfs:comment \"of b\" . :B a owl:Class ; rdfs:subClassOf _:x . "
                 "_:x owl:unionOf ( :C :D ) .");
  ASSERT_EQ(program.run({"merge", "a.ttl", "b.ttl", "-o", "all.nt"}).status, 0);
  const std::string all = program.read("all.nt");
  EXPECT_THAT(all, HasSubstr("<http://e/a> <http://www.w3.org/1999/02/22-rdf-syntax-ns#type> "
                             "<http://www.w3.org/2002/07/owl#Ontology>"));
  EXPECT_THAT(all, HasSubstr("<http://www.w3.org/2002/07/owl#imports> <http://e/c>"));
  EXPECT_THAT(all, Not(HasSubstr("<http://e/b>")));
  EXPECT_EQ(closure_of(program, "all.nt"), "http://e/A\thttp://e/B\n");
}

TEST(Infer, WritesDirectRelationsAndTypes) {
  const Program program;
  program.turtle("team.ttl", team);
  const Outcome outcome = program.run({"infer", "team.ttl", "--only-inferred", "-o", "-", "--to", "ntriples"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.err, IsEmpty());
  const auto has = [&](const std::string& s, const std::string& p, const std::string& o) {
    return outcome.out.find("<http://e/" + s + "> <http://www.w3.org/" + p + "> <http://e/" + o + "> .\n") !=
           std::string::npos;
  };
  EXPECT_TRUE(has("Goalie", "2000/01/rdf-schema#subClassOf", "Robot"));
  EXPECT_FALSE(has("Goalie", "2000/01/rdf-schema#subClassOf", "Thing")) << "not direct";
  EXPECT_TRUE(has("bob", "1999/02/22-rdf-syntax-ns#type", "Goalie"));
  EXPECT_TRUE(has("bob", "1999/02/22-rdf-syntax-ns#type", "Keeper"));
  EXPECT_FALSE(has("bob", "1999/02/22-rdf-syntax-ns#type", "Robot")) << "not direct";
  EXPECT_FALSE(has("ball", "1999/02/22-rdf-syntax-ns#type", "Ball")) << "asserted";
  EXPECT_THAT(outcome.out, Not(HasSubstr("urn:geminga")));
  EXPECT_THAT(outcome.out, Not(HasSubstr("comment")));
}

TEST(Infer, WritesTheOntologyThatHasTheSameClosureAndSaysAllOfIt) {
  const Program program;
  program.turtle("team.ttl", team);
  for (const std::string out : {"out.ttl", "out.owl"}) {
    ASSERT_EQ(program.run({"infer", "team.ttl", "-o", out, "--closure"}).status, 0);
    EXPECT_EQ(closure_of(program, out), closure_of(program, "team.ttl")) << out;
    EXPECT_EQ(
        program.run({"query", out, "--asserted", "ASK { :bob a :Robot . :Goalie rdfs:subClassOf :Thing }"}).status, 0);
  }
}

TEST(Infer, RefusesWhatContradictsItself) {
  const Program program;
  program.turtle("a.ttl", ":A a owl:Class ; owl:disjointWith :B . :B a owl:Class . :x a :A, :B .");
  const Outcome outcome = program.run({"infer", "a.ttl", "-o", "b.ttl"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("contradicts itself"));
}

TEST(Query, AnswersOverWhatFollowsInEachFormat) {
  const Program program;
  program.turtle("team.ttl", team);
  const std::string query = "SELECT ?x WHERE { ?x a :Robot }";
  EXPECT_EQ(program.run({"query", "team.ttl", query}).out, "?x\ne:bob\n");
  EXPECT_EQ(program.run({"query", "team.ttl", query, "--format", "csv"}).out, "x\r\nhttp://e/bob\r\n");
  EXPECT_EQ(program.run({"query", "team.ttl", query, "--format", "tsv"}).out, "?x\n<http://e/bob>\n");
  EXPECT_EQ(program.run({"query", "team.ttl", query, "--json"}).out,
            "{\"head\":{\"vars\":[\"x\"]},\"results\":{\"bindings\":[{\"x\":{\"type\":\"uri\",\"value\":\"http://e/"
            "bob\"}}]}}\n");
  program.write("q.rq", query);
  EXPECT_EQ(program.run({"query", "team.ttl", "q.rq"}).out, "?x\ne:bob\n");
  const Outcome asserted = program.run({"query", "team.ttl", "--asserted", query});
  EXPECT_EQ(asserted.out, "?x\n");
  EXPECT_EQ(asserted.status, 1);
}

TEST(Query, AnswersWithItsExitStatusAndRefusesWhatFetches) {
  const Program program;
  program.turtle("team.ttl", team);
  EXPECT_EQ(program.run({"query", "team.ttl", "ASK { :Keeper rdfs:subClassOf :Thing }"}).status, 0);
  const Outcome no = program.run({"query", "team.ttl", "ASK { :Thing rdfs:subClassOf :Keeper }"});
  EXPECT_EQ(no.status, 1);
  EXPECT_EQ(no.out, "no\n");
  EXPECT_THAT(program.run({"query", "team.ttl", "CONSTRUCT { ?x :is :Robot } WHERE { ?x a :Robot }"}).out,
              HasSubstr(":is :Robot"));
  const Outcome fetch = program.run({"query", "team.ttl", "SELECT * FROM <http://127.0.0.1/x> WHERE { ?s ?p ?o }"});
  EXPECT_EQ(fetch.status, 2);
  EXPECT_THAT(fetch.err, HasSubstr("nothing is fetched"));
  EXPECT_EQ(program.run({"query", "team.ttl"}).status, 2);
  const Outcome cut = program.run({"query", "team.ttl", "SELECT * WHERE { ?s ?p ?o }", "--rows", "2"});
  EXPECT_EQ(cut.status, 4);
  EXPECT_THAT(cut.err, HasSubstr("more than 2 rows"));
}

TEST(Query, NamesTheLimitOfTriplesAndTheFlagThatRaisesIt) {
  const Program program;
  std::string chain;
  for (int at = 0; at < 100; ++at)
    chain += ":C" + std::to_string(at) + " rdfs:subClassOf :C" + std::to_string(at + 1) + " .\n";
  program.turtle("a.ttl", chain);
  const Outcome query = program.run({"query", "a.ttl", "ASK { ?s ?p ?o }", "--graph-limit", "1"});
  EXPECT_EQ(query.status, 4);
  EXPECT_THAT(query.err, HasSubstr("more than 1 MiB in all"));
  EXPECT_THAT(query.err, HasSubstr("raise --graph-limit"));
  EXPECT_EQ(program.run({"query", "a.ttl", "ASK { ?s ?p ?o }", "--graph-limit", "16"}).status, 0);
  const Outcome infer = program.run({"infer", "a.ttl", "--closure", "-o", "out.nt", "--graph-limit", "1"});
  EXPECT_EQ(infer.status, 4);
  EXPECT_THAT(infer.err, HasSubstr("raise --graph-limit"));
}

TEST(Query, EndsAtItsLimitOfStepsWithoutAnAnswer) {
  const Program program;
  program.turtle("a.ttl", ":A rdfs:subClassOf :B . :B rdfs:subClassOf :C .\n");
  const auto nested = [](int levels) {
    std::string query = "SELECT * WHERE { ?s ?p ?o ";
    for (int at = 0; at < levels; ++at) query += "OPTIONAL { ?s ?p ?o ";
    return query + std::string(static_cast<std::size_t>(levels), '}') + " }";
  };
  program.write("nested.rq", nested(5));
  program.write("too-deep.rq", nested(3000));
  EXPECT_EQ(program.run({"query", "a.ttl", "nested.rq"}).status, 0);
  EXPECT_EQ(program.run({"query", "a.ttl", "too-deep.rq"}).status, 2);
  const Outcome ended = program.run({"query", "a.ttl", "nested.rq", "--query-steps", "50"});
  EXPECT_EQ(ended.status, 4) << ended.err;
  EXPECT_THAT(ended.err, testing::HasSubstr("raise --query-steps"));
  EXPECT_THAT(ended.out, testing::IsEmpty());
  const Outcome json = program.run({"query", "a.ttl", "nested.rq", "--query-steps", "50", "--json"});
  EXPECT_EQ(json.status, 4);
  EXPECT_THAT(json.out, testing::HasSubstr("{\"error\":\"the query has no answer, because the limit of 50 steps"));
}

}  // namespace
}  // namespace geminga::ontology
