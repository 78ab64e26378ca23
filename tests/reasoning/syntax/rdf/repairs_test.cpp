// Files that are not quite as their syntax has it: a fault costs what it stands in, is named, and nothing else is lost.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reasoning/syntax/rdf/functional.hpp"
#include "reasoning/syntax/rdf/reading.hpp"
#include "reasoning/syntax/rdf/scratch.hpp"

namespace geminga::rdf {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// The axioms of a file, then what is left out, then the remarks with their lines.
std::vector<std::string> told(const std::string& name, std::string_view content) {
  syntax::FileLimits limits;
  limits.keeps_annotations = true;
  const auto loaded = load_text(name, content, limits);
  if (!loaded) return {to_string(loaded.error())};
  std::vector<std::string> lines = functional(loaded->source);
  const auto add = [&](std::string_view what, std::span<const owl::Ontology::Omission> notes) {
    for (const auto& note : notes) {
      lines.push_back(std::string(what) + ' ' + std::to_string(note.line) + ": " +
                      std::string(loaded->source.name(note.construct)));
    }
  };
  add("left out", loaded->source.omissions());
  add("remark", loaded->source.remarks());
  for (const owl::Annotation& annotation : loaded->annotations) lines.push_back("text " + annotation.value);
  return lines;
}

const std::string axiom =
    "<rdf:Description rdf:about='http://e/A'><rdfs:subClassOf rdf:resource='http://e/B'/></rdf:Description>\n";
const std::string said = "SubClassOf(:A :B)";

/// The axiom, and behind it a description of :A that begins on line 4.
std::string described(std::string_view inside, std::string_view doctype = "") {
  return xml(axiom + "<rdf:Description rdf:about='http://e/A'>" + std::string(inside) + "</rdf:Description>\n",
             doctype);
}

TEST(Repairs, WhatADoctypeSaysOfOtherFilesCostsNothing) {
  const std::string remark = "remark 2: an external DTD or entity, which is never read";
  for (const char* doctype :
       {"<!DOCTYPE rdf:RDF SYSTEM 'x.dtd'>\n", "<!DOCTYPE rdf:RDF PUBLIC \"-//a>b\" 'http://127.0.0.1:9/x' []>\n",
        "<!DOCTYPE rdf:RDF [<!ENTITY x SYSTEM 'file:///etc/passwd'>]>\n",
        "<!DOCTYPE rdf:RDF [<!ENTITY % x PUBLIC 'p' 'file:///etc/passwd'> %x; <!ENTITY y 'z'>]>\n"}) {
    EXPECT_THAT(told("a.owl", described("", doctype)), ElementsAre(said, remark)) << doctype;
  }
  EXPECT_THAT(told("a.owl", described("",
                                      "<!DOCTYPE rdf:RDF [<!ELEMENT rdf:RDF ANY><!NOTATION n SYSTEM '>'>"
                                      "<!ATTLIST rdf:RDF a CDATA #IMPLIED>]>\n")),
              ElementsAre(said));
}

TEST(Repairs, AReferenceToAnEntityOfAnotherFileStaysAsWrittenInATextAndIsRefusedInAName) {
  const std::string outside = "<!DOCTYPE rdf:RDF [<!ENTITY x SYSTEM 'x'><!ENTITY y '-&x;'><!ENTITY z 'z'>]>\n";
  EXPECT_THAT(told("a.owl", described("<rdfs:comment>&x; &y; &z; &amp;</rdfs:comment>", outside)),
              ElementsAre(said, "remark 5: a reference to an entity of another file, kept as it is written",
                          "remark 2: an external DTD or entity, which is never read", "text &x; &y; z &"));
  EXPECT_THAT(told("a.owl", described("<rdfs:seeAlso rdf:resource='http://e/&y;'/>", outside)),
              ElementsAre("a.owl:5: refers to the entity y of another file, which is never read"));
  EXPECT_THAT(told("a.owl", described("<rdfs:comment>&u;&#65;</rdfs:comment>", "<!DOCTYPE rdf:RDF SYSTEM 'x'>\n")),
              testing::Contains("text &u;A"));
  EXPECT_THAT(told("a.owl", described("<rdfs:comment>&u;</rdfs:comment>")),
              ElementsAre("a.owl:4: Entity 'u' not defined"));
}

TEST(Repairs, AnEntityMayHoldReferencesToCharacters) {
  const std::string doctype =
      "<!DOCTYPE rdf:RDF [<!ENTITY u '&#252;'><!ENTITY v \"&#xFC;&u;&#34;&#39;&#62;&#x1F916;&#37;&#9;&amp;\">"
      "<!ENTITY b 'http://&#252;/'>]>\n";
  EXPECT_THAT(told("a.owl", described("<rdfs:comment>&u;&v;</rdfs:comment>"
                                      "<rdfs:subClassOf rdf:resource='http://e/&u;'/>"
                                      "<rdfs:subClassOf xml:base='&b;' rdf:resource='C'/>",
                                      doctype)),
              ElementsAre(said, "SubClassOf(:A :ü)", "SubClassOf(:A <http://ü/C>)", "text üüü\"'>🤖%\t&"));
}

TEST(Repairs, MarkupInATextIsAnXmlLiteral) {
  const std::string remark = "remark 4: markup in a text, read as an XML literal";
  EXPECT_THAT(told("a.owl", described("<rdfs:comment>see <e:a href='h'>b</e:a></rdfs:comment>")),
              ElementsAre(said, remark, testing::StartsWith("text see <e:a xmlns:e=\"http://e/\" href=\"h\">b</e:a>")));
  EXPECT_THAT(told("a.owl", described("<rdfs:comment rdf:datatype='http://e/t'><e:b>b</e:b> c</rdfs:comment>")),
              ElementsAre(said, remark, testing::EndsWith("</e:b> c")));
  EXPECT_THAT(told("a.owl", described("<rdfs:subClassOf>,<rdf:Description rdf:about='http://e/C'/></rdfs:subClassOf>")),
              ElementsAre(said, "SubClassOf(:A :C)"))
      << "a property of OWL has no text";
}

TEST(Repairs, AFaultOfOneStatementCostsThatStatement) {
  EXPECT_THAT(told("a.owl", described("<rdfs:subClassOf sex='m' rdf:resource='http://e/C'/>")),
              ElementsAre(said, "SubClassOf(:A :C)", "remark 4: an attribute without a namespace, passed over"));
  EXPECT_THAT(told("a.owl", described("<rdf:Description>x</rdf:Description>")),
              ElementsAre(said,
                          "left out 4: a statement that cannot be read (rdf:Description is forbidden as a property "
                          "element)"));
  EXPECT_THAT(told("a.owl", described("<a>x</a>")),
              ElementsAre(said, "left out 4: a statement that cannot be read (an element without a namespace)"));
  const std::string list =
      "<rdfs:subClassOf><rdf:Description><e:p rdf:parseType='Collection'><a/></e:p>"
      "</rdf:Description></rdfs:subClassOf>";
  EXPECT_THAT(told("a.owl", described(list)),
              ElementsAre("a.owl:4: Using an element 'p' without a namespace is forbidden."))
      << "the list would lose a member";
}

TEST(Repairs, ABlankNodeMayHaveANameThatXmlDoesNotHave) {
  EXPECT_THAT(told("a.owl", described("<rdfs:subClassOf rdf:nodeID='_:genid1'/>")), testing::Contains(said));
  EXPECT_THAT(told("a.owl", xml("<e:A rdf:nodeID='_:1'/>\n<e:B rdf:nodeID='_:1'/><e:C rdf:nodeID='_:2'/>")),
              ElementsAre("ClassAssertion(:A _:1)", "ClassAssertion(:B _:1)", "ClassAssertion(:C _:2)",
                          "remark 3: rdf:nodeID that is no name of XML, read as one"));
}

TEST(Repairs, APrefixWithOneMeaningNeedNoDeclarationInTurtle) {
  const std::string head = "\xef\xbb\xbf@prefix : <http://e/> .\n";
  EXPECT_THAT(told("a.ttl", head + ":A a owl:Class ;\nrdfs:subClassOf :B .\n"),
              ElementsAre(said, "remark 1: a prefix of RDF, RDFS, OWL or XSD that the file does not declare"));
  EXPECT_THAT(told("a.ttl", head + "PREFIX rdfs: <http://www.w3.org/2000/01/rdf-schema#>\n:A rdfs:subClassOf :B .\n"),
              ElementsAre(said));
  EXPECT_THAT(told("a.ttl", head + ":A foaf:knows :B .\n"),
              ElementsAre("a.ttl:2: The namespace prefix in \"foaf:knows\" was not declared."));
}

TEST(Repairs, TriplesMayHaveRelativeNames) {
  EXPECT_THAT(told("a.nt", "<http://e/A> <http://www.w3.org/2000/01/rdf-schema#subClassOf> <B> .\n"),
              ElementsAre("SubClassOf(:A <file:///B>)"));
}

TEST(Repairs, AreFaultsOfLinesThatAreThere) {
  EXPECT_THAT(told("a.owl", "<?xml version='1.0'?><x:RDF/>"),
              ElementsAre(testing::StartsWith("a.owl:1: The namespace prefix in \"x:RDF\" was not declared. (")));
}

TEST(Faults, SayWhatAFileIsInsteadOfTurtleOrRdfXml) {
  const Scratch scratch;
  const auto error = [&](const char* name, std::string_view text) {
    const auto loaded = load(std::vector{scratch.write(name, std::string(text))});
    return loaded ? "read" : to_string(loaded.error());
  };
  EXPECT_THAT(error("a.xml", "<project xmlns=\"http://e/\"><a><b/><c/></a></project>"),
              testing::EndsWith(" (it names neither RDF's nor OWL's namespace: is it an ontology?)"));
  EXPECT_THAT(error("a.n3", "@prefix : <http://e/> .\n{ :a a :B } :c :d .\n"), testing::HasSubstr(":2"));
}

TEST(Repairs, TakeFormerWordsForTodaysInEveryFileOfSeveral) {
  const Scratch scratch;
  constexpr std::string_view text = "@prefix n: <http://www.w3.org/2006/12/owl11#> .\n";
  const auto property = [&](const char* name) {
    return scratch.write(std::string(name) + ".ttl", std::string(text) + "<http://e/" + name +
                                                         "> a n:IrreflexiveProperty , n:FunctionalObjectProperty .\n");
  };
  const auto loaded = load(std::vector{property("p"), property("q")});
  ASSERT_TRUE(loaded) << to_string(loaded.error());
  EXPECT_THAT(functional(loaded->source),
              testing::IsSupersetOf({"IrreflexiveObjectProperty(:q)", "FunctionalObjectProperty(:q)"}));
  EXPECT_TRUE(loaded->source.omissions().empty());
}

TEST(Repairs, ABlankPropertyWithSeveralInversesMakesThemEquivalent) {
  const std::string head = "@prefix : <http://e/> .\n@prefix owl: <http://www.w3.org/2002/07/owl#> .\n";
  EXPECT_THAT(told("a.ttl", head + "[] owl:inverseOf :p, :q .\n"), ElementsAre("EquivalentObjectProperties(:p :q)"));
  EXPECT_THAT(told("a.ttl", head + "_:x owl:inverseOf :p, :q, :r, :p . :A owl:equivalentClass [ a owl:Restriction ; "
                                   "owl:onProperty _:x ; owl:someValuesFrom :B ] .\n"),
              ElementsAre("EquivalentObjectProperties(:p :q)", "EquivalentObjectProperties(:p :r)",
                          "EquivalentClasses(:A ObjectSomeValuesFrom(ObjectInverseOf(:p) :B))"));
  EXPECT_THAT(told("a.ttl", head + "_:x owl:inverseOf _:y, :p . _:y owl:inverseOf :q .\n"),
              ElementsAre("InverseObjectProperties(ObjectInverseOf(:p) ObjectInverseOf(:q))"));
  EXPECT_THAT(told("a.ttl", head + "_:x owl:inverseOf _:y, _:x .\n"),
              ElementsAre("left out 3: a blank property without owl:inverseOf"));
}

TEST(Repairs, OfAPlainFileAreNone) {
  EXPECT_THAT(told("a.owl", xml("")), IsEmpty());
  EXPECT_THAT(told("a.owl", xml(axiom)), ElementsAre(said));
}

}  // namespace
}  // namespace geminga::rdf
