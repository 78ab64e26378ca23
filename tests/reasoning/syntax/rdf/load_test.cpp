// Loads of several files: imports, prefixes, names, labels, encodings, mixed syntaxes.
#include "reasoning/syntax/rdf/load.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reasoning/owl/loaded_file.hpp"
#include "reasoning/syntax/rdf/functional.hpp"
#include "reasoning/syntax/rdf/reading.hpp"
#include "reasoning/syntax/rdf/scratch.hpp"

namespace geminga::rdf {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

std::string ontology(std::string_view iri, std::string_view rest) {
  return std::string(turtle_prefixes) + "<" + std::string(iri) + "> a owl:Ontology " + std::string(rest) + ".\n";
}

TEST(Imports, AreResolvedByOntologyVersionAndFile) {
  const Scratch scratch;
  const std::string core = scratch.write("core.ttl", ontology("http://e/core", "; owl:versionIRI <http://e/core/2>"));
  const std::string hash = scratch.write("hash.ttl", ontology("http://e/hash#", ""));
  const std::string team = scratch.write(
      "team.ttl",
      ontology("http://e/team", "; owl:imports <http://e/core>, <http://e/core/2>, <http://e/hash>, <file://" + core +
                                    ">, <core.ttl>, <http://e/team>, <http://e/nowhere>,\n <http://e/nowhere>"));
  const auto loaded = load(std::vector{team, core, hash});
  ASSERT_TRUE(loaded) << to_string(loaded.error());
  ASSERT_THAT(loaded->unresolved, SizeIs(1));
  EXPECT_EQ(loaded->unresolved[0].iri, "http://e/nowhere");
  EXPECT_EQ(loaded->unresolved[0].file, team);
  EXPECT_EQ(loaded->unresolved[0].line, 2U);
  ASSERT_THAT(loaded->source.omissions(), SizeIs(1));
  EXPECT_EQ(loaded->source.name(loaded->source.omissions()[0].construct), "owl:imports <http://e/nowhere>");
  EXPECT_EQ(loaded->source.files()[0].ontology_iri, "http://e/team");
  EXPECT_EQ(loaded->source.files()[2].ontology_iri, "http://e/hash#");
}

TEST(Imports, MayBeCircular) {
  const Scratch scratch;
  const std::string a = scratch.write("a.ttl", ontology("http://e/a", "; owl:imports <http://e/b>"));
  const std::string b = scratch.write("b.ttl", ontology("http://e/b", "; owl:imports <http://e/a>"));
  const auto loaded = load(std::vector{a, b});
  ASSERT_TRUE(loaded) << to_string(loaded.error());
  EXPECT_THAT(loaded->unresolved, IsEmpty());
}

TEST(Imports, MayDifferInCaseFromTheNameOfTheOntology) {
  const Scratch scratch;
  const std::string a = scratch.write("a.ttl", ontology("http://e/a", "; owl:imports <http://E/Core-ALL>"));
  const std::string b = scratch.write("b.ttl", ontology("http://e/core-All", ""));
  const auto loaded = load(std::vector{a, b});
  ASSERT_TRUE(loaded) << to_string(loaded.error());
  EXPECT_THAT(loaded->unresolved, IsEmpty());
}

TEST(Imports, AreResolvedThroughTheCatalogueOfAFolder) {
  const Scratch scratch;
  scratch.write("team.ttl",
                ontology("http://e/team", "; owl:imports <http://old/core>, <http://old/gone>, <http://old/url>"));
  const std::string core = scratch.write("core.ttl", ontology("http://e/core", ""));
  scratch.write("catalog-v001.xml",
                "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"no\"?>\n"
                "<catalog prefer=\"public\" xmlns=\"urn:oasis:names:tc:entity:xmlns:xml:catalog\">\n"
                "  <group id=\"Folder Repository\" prefer=\"public\">\n"
                "    <uri id=\"1\" name=\"http://old/core\" uri=\"./core.ttl\"/>\n"
                "    <uri id=\"2\" name=\"http://old/gone\" uri=\"../../../etc/passwd\"/>\n"
                "    <uri id=\"3\" name=\"http://old/url\" uri=\"file://" +
                    core +
                    "\"/>\n"
                    "  </group>\n</catalog>\n");
  const auto loaded = load(std::vector{scratch.path().string()});
  ASSERT_TRUE(loaded) << to_string(loaded.error());
  ASSERT_THAT(loaded->unresolved, SizeIs(1));
  EXPECT_EQ(loaded->unresolved[0].iri, "http://old/gone");
}

TEST(Imports, ABrokenCatalogueIsRefusedWithItsLine) {
  const Scratch scratch;
  scratch.write("team.ttl", "");
  scratch.write("catalog-v001.xml", "<catalog>\n<group>\n</catalog>\n");
  const auto loaded = load(std::vector{scratch.path().string()});
  ASSERT_FALSE(loaded);
  EXPECT_THAT(to_string(loaded.error()), HasSubstr("catalog-v001.xml:3: is no well-formed XML"));
}

std::vector<std::string> prefixes(const Loaded& loaded) {
  std::vector<std::string> found;
  for (const auto& prefix : loaded.source.prefixes())
    found.push_back(std::string(loaded.source.name(prefix.prefix)) + ": " +
                    std::string(loaded.source.name(prefix.iri)));
  return found;
}

TEST(Prefixes, ThatMeanSeveralIrisAreSettledTheSameInEveryOrder) {
  const Scratch scratch;
  const std::string a =
      scratch.write("a.ttl", "@prefix x: <http://z/> . @prefix y: <http://b/> . @prefix : <http://a/> .\n");
  const std::string b =
      scratch.write("b.ttl", "@prefix x: <http://z/> . @prefix y: <http://a/> . @prefix : <http://b/> .\n");
  const std::string c =
      scratch.write("c.owl", xml("<rdf:Description xmlns:x=\"http://a/\" xmlns:owl=\"http://fake/\"/>"));
  for (const auto& order : {std::vector{a, b, c}, std::vector{c, b, a}, std::vector{b, c, a}}) {
    const auto loaded = load(order);
    ASSERT_TRUE(loaded) << to_string(loaded.error());
    EXPECT_THAT(prefixes(*loaded), testing::IsSupersetOf({"x: http://z/", "y: http://a/",
                                                          "owl: http://www.w3.org/2002/07/owl#", "e: http://e/"}));
    EXPECT_THAT(prefixes(*loaded), testing::Not(testing::Contains(testing::StartsWith(":"))));
    ASSERT_THAT(loaded->conflicts, SizeIs(3));
    EXPECT_EQ(loaded->conflicts[0].prefix, "owl");
    EXPECT_THAT(loaded->conflicts[0].others, ElementsAre("http://fake/"));
    EXPECT_EQ(loaded->conflicts[1].prefix, "x");
    EXPECT_EQ(loaded->conflicts[1].chosen, "http://z/");
    EXPECT_EQ(loaded->conflicts[2].prefix, "y");
    EXPECT_EQ(loaded->conflicts[2].chosen, "http://a/");
  }
}

TEST(Labels, OfClassesAreKeptWithTheirLanguage) {
  const auto loaded = load_text("a.ttl", std::string(turtle_prefixes) +
                                             ":A a owl:Class ; rdfs:label \"Ball\"@en, \"Kugel\"@de ; "
                                             "<http://www.w3.org/2004/02/skos/core#prefLabel> \"ball\" .\n"
                                             ":A <https://geminga.example/core#messageType> \"b/msg/Ball\" .\n"
                                             ":B rdfs:subClassOf :A ; rdfs:label \"undeclared\" .\n"
                                             ":i a :A ; rdfs:label \"an individual\" .\n");
  ASSERT_TRUE(loaded) << to_string(loaded.error());
  std::vector<std::string> labels;
  for (const auto& label : loaded->source.labels())
    labels.push_back(std::string(loaded->source.name(label.entity)) + ' ' +
                     std::string(loaded->source.name(label.text)) + '@' +
                     std::string(loaded->source.name(label.language)));
  EXPECT_THAT(labels, testing::UnorderedElementsAre("http://e/A Ball@en", "http://e/A Kugel@de", "http://e/A ball@",
                                                    "http://e/A b/msg/Ball@", "http://e/B undeclared@"));
}

TEST(Conversions, AreReadWithTheCostsOfTheirAnnotations) {
  const auto loaded = load_text(
      "a.ttl", std::string(turtle_prefixes) +
                   "@prefix g: <https://geminga.example/core#> .\n"
                   ":A a owl:Class ; g:convertsTo :B , :C , _:b , \"D\" .\n:B a owl:Class . :C a owl:Class .\n"
                   "[] a owl:Axiom ; owl:annotatedSource :A ; owl:annotatedProperty g:convertsTo ;\n"
                   "   owl:annotatedTarget :C ; g:conversionCost 7 .\n"
                   "[] a owl:Axiom ; owl:annotatedSource :A ; owl:annotatedProperty rdfs:comment ;\n"
                   "   owl:annotatedTarget :B ; g:conversionCost 9 .\n_:c g:convertsTo :A .\n");
  ASSERT_TRUE(loaded) << to_string(loaded.error());
  EXPECT_FALSE(loaded->source.problem());
  EXPECT_THAT(conversions(loaded->source),
              testing::UnorderedElementsAre(testing::StartsWith("http://e/A > http://e/B 1,"),
                                            testing::StartsWith("http://e/A > http://e/C 7,")));
}

TEST(Conversions, ThatCannotBeOnesAreNamedWhereTheyStand) {
  const auto loaded =
      load_text("a.ttl", std::string(turtle_prefixes) +
                             "@prefix g: <https://geminga.example/core#> .\n"
                             ":A a owl:Class ; g:conversionCost 3 .\n"
                             ":A g:convertsTo \"B\" .\n"
                             ":A g:convertsTo [ a owl:Class ] .\n"
                             "[] g:convertsTo :A .\n"
                             "[] a owl:Axiom ; owl:annotatedSource :A ; owl:annotatedProperty g:convertsTo ;\n"
                             "   owl:annotatedTarget :B ; g:conversionCost 7 .\n");
  ASSERT_TRUE(loaded) << to_string(loaded.error());
  const auto lines = std::ranges::count(std::string_view(turtle_prefixes), '\n');
  std::vector<std::string> named;
  for (const auto& one : loaded->source.omissions())
    named.push_back(std::string(loaded->source.name(one.construct)) + " x" + std::to_string(one.count) + " line " +
                    std::to_string(one.line - lines));
  EXPECT_THAT(
      named, testing::UnorderedElementsAre("geminga:convertsTo with a literal: name a class x1 line 3",
                                           "geminga:convertsTo from or to what has no name x2 line 4",
                                           "geminga:conversionCost of no geminga:convertsTo that is stated x2 line 2"));
}

TEST(Conversions, TakeTheLowestOfTheirCosts) {
  const auto loaded =
      load_text("a.ttl", std::string(turtle_prefixes) +
                             "@prefix g: <https://geminga.example/core#> .\n"
                             ":A a owl:Class ; g:convertsTo :B . :B a owl:Class .\n"
                             "[] a owl:Axiom ; owl:annotatedSource :A ; owl:annotatedProperty g:convertsTo ;\n"
                             "   owl:annotatedTarget :B ; g:conversionCost 7 .\n"
                             "[] a owl:Axiom ; owl:annotatedSource :A ; owl:annotatedProperty g:convertsTo ;\n"
                             "   owl:annotatedTarget :B ; g:conversionCost 5 .\n");
  ASSERT_TRUE(loaded) << to_string(loaded.error());
  EXPECT_THAT(conversions(loaded->source), testing::ElementsAre(testing::StartsWith("http://e/A > http://e/B 5,")));
}

TEST(Conversions, OfNoCostAreNamedWhereItStands) {
  const auto loaded = load_text("a.ttl", std::string(turtle_prefixes) +
                                             "@prefix g: <https://geminga.example/core#> .\n"
                                             ":A a owl:Class ; g:convertsTo :B .\n:B a owl:Class .\n"
                                             "[] a owl:Axiom ; owl:annotatedSource :A ;\n"
                                             "   owl:annotatedProperty g:convertsTo ; owl:annotatedTarget :B ;\n"
                                             "   g:conversionCost 0 .\n");
  ASSERT_TRUE(loaded) << to_string(loaded.error());
  ASSERT_THAT(loaded->source.omissions(), SizeIs(1));
  const auto lines = std::ranges::count(std::string_view(turtle_prefixes), '\n');
  EXPECT_EQ(loaded->source.omissions()[0].line, lines + 6);
}

TEST(Load, ReadsIso88591WhereXmlSaysSo) {
  const std::string text =
      "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>\n<rdf:RDF "
      "xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\" "
      "xmlns:owl=\"http://www.w3.org/2002/07/owl#\" xmlns:rdfs=\"http://www.w3.org/2000/01/rdf-schema#\">"
      "<owl:Class rdf:about=\"http://e/A\"><rdfs:label>\xd6lstand</rdfs:label></owl:Class></rdf:RDF>";
  const auto loaded = load_text("a.owl", text);
  ASSERT_TRUE(loaded) << to_string(loaded.error());
  ASSERT_THAT(loaded->source.labels(), SizeIs(1));
  EXPECT_EQ(loaded->source.name(loaded->source.labels()[0].text), "Ölstand");
}

TEST(Load, ReadsAByteOrderMarkInEverySyntax) {
  const std::string mark = "\xef\xbb\xbf";
  const std::string triple = "<http://e/A> <http://www.w3.org/2000/01/rdf-schema#subClassOf> <http://e/B> .\n";
  const std::string element =
      "<rdf:Description rdf:about=\"http://e/A\"><rdfs:subClassOf rdf:resource=\"http://e/B\"/>"
      "</rdf:Description>\n";
  for (const auto& [name, text] : {std::pair{"a.ttl", triple},
                                   {"a.ttl", std::string(turtle_prefixes) + triple},
                                   {"a.nt", triple},
                                   {"a.owl", xml(element)},
                                   {"a.owl", triple}}) {
    const auto loaded = load_text(name, mark + text);
    ASSERT_TRUE(loaded) << name << to_string(loaded.error());
    EXPECT_THAT(functional(loaded->source), ElementsAre("SubClassOf(:A :B)")) << name;
  }
  EXPECT_EQ(refusal("a.owl", mark + "<?xml version='1.0' encoding='ISO-8859-1'?><e:A xmlns:e='http://e/'/>"),
            "a.owl:1: begins as UTF-8 and declares ISO-8859-1: correct its declaration");
}

TEST(Load, ReadsAnIdThatIsGivenTwiceOrIsNoNameOfXmlAsAName) {
  const std::string of_class = "<rdfs:subClassOf rdf:resource='http://e/C'/></owl:Class>\n";
  const auto loaded =
      load_text("a.owl", xml("<rdf:Description xmlns:owl='http://www.w3.org/2002/07/owl#' xml:base='http://e/x'>\n<e:p>"
                             "<owl:Class rdf:ID='A'>" +
                             of_class + "</e:p><e:p><owl:Class rdf:ID = \"1 b\">" + of_class +
                             "</e:p><e:p><owl:Class rdf:ID='A'>" + of_class + "</e:p></rdf:Description>"));
  ASSERT_TRUE(loaded) << to_string(loaded.error());
  const auto axioms = functional(loaded->source);
  EXPECT_THAT(axioms, testing::Contains("SubClassOf(:x#A :C)"));
  EXPECT_THAT(axioms, testing::Contains("SubClassOf(:x#1 b :C)"));
  ASSERT_THAT(loaded->source.remarks(), SizeIs(1));
  EXPECT_EQ(loaded->source.remarks()[0].line, 5U);
  const std::string statement = "<e:A rdf:about='http://e/a'><e:p rdf:ID='s' rdf:resource='http://e/B'/></e:A>\n";
  EXPECT_EQ(refusal("a.owl", xml(statement + statement)), "a.owl:4: Duplicated rdf:ID value 's'")
      << "a name of a statement";
}

TEST(Load, RemarksListsThatAreTooShort) {
  const auto loaded = load_text("a.ttl", std::string(turtle_prefixes) +
                                             ":A rdfs:subClassOf [ a owl:Class ; owl:unionOf () ] .\n"
                                             ":A rdfs:subClassOf [ a owl:Class ; owl:intersectionOf ( :B ) ] .\n"
                                             "[] a owl:AllDisjointClasses ; owl:members ( :A ) .");
  ASSERT_TRUE(loaded) << to_string(loaded.error());
  EXPECT_THAT(functional(loaded->source), ElementsAre("SubClassOf(:A owl:Nothing)", "SubClassOf(:A :B)"));
  std::vector<std::string> remarks;
  for (const owl::Ontology::Omission& remark : loaded->source.remarks())
    remarks.push_back(std::string(loaded->source.name(remark.construct)) + ", line " + std::to_string(remark.line));
  EXPECT_THAT(remarks,
              testing::UnorderedElementsAre("ObjectUnionOf of nothing, read as owl:Nothing, line 2",
                                            "ObjectIntersectionOf of one operand, read as that operand, line 3",
                                            "DisjointClasses of fewer than two operands, which says nothing, line 4"));
}

TEST(Load, LosesNothingBehindAQuotationMarkInAComment) {
  const std::string sub = "> <http://www.w3.org/2000/01/rdf-schema#subClassOf> <http://e/";
  const std::string triples =
      "<http://e/A" + sub + "B> . # a \" mark\n<http://e/B" + sub + "C> .\n# \"\n<http://e/C" + sub + "D> .\n";
  for (const char* name : {"a.nt", "a.ttl"}) {
    const auto loaded = load_text(name, triples);
    ASSERT_TRUE(loaded) << to_string(loaded.error());
    EXPECT_EQ(loaded->triples, 3U) << name;
    const auto more = load_text(name, "# it's\n<http://e/O'B" + sub + "C> .\n" + triples);
    ASSERT_TRUE(more) << to_string(more.error());
    EXPECT_EQ(more->triples, 4U) << name;
    EXPECT_EQ(refusal(name, triples + "<http://e/\"A" + sub + "B> .\n" + triples),
              std::string(name) + ":5: has an IRI with a quotation mark in it");
  }
}

TEST(Load, TakesNamesOfAllScriptsAlikeInEverySyntax) {
  const std::string word = "\u00c4\u7403\U0001f916";
  const std::string sub = "<http://www.w3.org/2000/01/rdf-schema#subClassOf>";
  const std::string written = "<http://e/" + word + "> " + sub + " <http://e/B> .\n";
  const std::string escaped = "<http://e/\\u00C4\\u7403\\U0001F916> " + sub + " <http://e/B> .\n";
  const std::string element = xml("<rdf:Description rdf:about='http://e/" + word +
                                  "'><rdfs:subClassOf rdf:resource='http://e/B'/></rdf:Description>\n");
  const std::string references =
      xml("<rdf:Description rdf:about='http://e/&#196;&#x7403;&#x1F916;'><rdfs:subClassOf "
          "rdf:resource='http://e/B'/></rdf:Description>\n");
  for (const auto& [name, text] : {std::pair{"a.nt", written},
                                   {"a.nt", escaped},
                                   {"a.ttl", written},
                                   {"a.ttl", escaped},
                                   {"a.owl", element},
                                   {"a.owl", references}}) {
    const auto loaded = load_text(name, text);
    ASSERT_TRUE(loaded) << name << to_string(loaded.error());
    EXPECT_THAT(functional(loaded->source), ElementsAre("SubClassOf(:" + word + " :B)")) << name << ' ' << text;
  }
}

TEST(Load, TakesLanguageTagsInLowerCaseInEverySyntax) {
  const std::string value = "DataPropertyAssertion(:p :a \"x\"@en-gb)";
  const std::string declared = ":p a owl:DatatypeProperty .\n";
  const auto turtle = load_text("a.ttl", std::string(turtle_prefixes) + declared + ":a :p \"x\"@en-GB .\n");
  const auto element = load_text(
      "a.owl", xml("<rdf:Description rdf:about='http://e/a'><e:p xml:lang='EN-gb'>x</e:p></rdf:Description>"
                   "<owl:DatatypeProperty xmlns:owl='http://www.w3.org/2002/07/owl#' rdf:about='http://e/p'/>"));
  const auto plain =
      load_text("a.ttl", std::string(turtle_prefixes) + declared +
                             ":a :p \"x@EN-GB\"^^<http://www.w3.org/1999/02/22-rdf-syntax-ns#PlainLiteral> .\n");
  ASSERT_TRUE(turtle && element && plain);
  EXPECT_THAT(functional(turtle->source), ElementsAre(value));
  EXPECT_THAT(functional(element->source), ElementsAre(value));
  EXPECT_THAT(functional(plain->source), ElementsAre(value));
}

TEST(Load, TakesRelativeIrisRelativeToTheFileNameAndNotToItsPlace) {
  const auto loaded = load_text("a.ttl", std::string(turtle_prefixes) + "<#A> rdfs:subClassOf <#B> .\n");
  ASSERT_TRUE(loaded) << to_string(loaded.error());
  EXPECT_THAT(functional(loaded->source), ElementsAre("SubClassOf(<file:///a.ttl#A> <file:///a.ttl#B>)"));
}

TEST(Load, IsAllOrNothing) {
  const Scratch scratch;
  const std::string good = scratch.write("good.ttl", std::string(turtle_prefixes) + ":A rdfs:subClassOf :B .\n");
  const std::string bad = scratch.write("bad.ttl", std::string(turtle_prefixes) + ":A rdfs:subClassOf\n.\n");
  const auto loaded = load(std::vector{good, bad});
  ASSERT_FALSE(loaded);
  EXPECT_THAT(to_string(loaded.error()), testing::StartsWith(bad + ":3: "));
  EXPECT_FALSE(loaded.error().is_unreadable);
}

/// Makes the same of every file, and notes what it is asked for.
class Recorder final : public OtherReader {
 public:
  std::vector<std::string> calls;

  void look_ahead(syntax::Syntax syntax, std::string_view bytes) override {
    calls.push_back("ahead " + std::string(to_string(syntax)) + ' ' + std::string(bytes));
  }
  std::expected<owl::Document, owl::ReadError> read(syntax::Syntax syntax, std::string_view bytes, owl::FileId file,
                                                    owl::Ontology& source, std::vector<owl::Annotation>&) override {
    calls.push_back("read " + std::string(to_string(syntax)) + ' ' + std::string(bytes));
    source.add(owl::AxiomKind::sub_class_of, {source.named_class("http://e/A"), source.named_class("http://e/B")}, file,
               7);
    return owl::Document{.ontology_iri = "http://e/a",
                         .version_iri = "http://e/a/1",
                         .imports = {{"http://e/b", 1}, {"http://e/d", 2}},
                         .prefixes = {{"other", "http://o/"}}};
  }
};

TEST(Load, ReadsWhatDependsOnAllOthersLastAndLooksAtAllOfItFirst) {
  const Scratch scratch;
  const std::vector files{scratch.write("a.omn", "Ontology: <http://e/a>"), scratch.write("b.omn", "Ontology: # b"),
                          scratch.write("c.ofn", "Ontology()")};
  Recorder reader;
  ASSERT_TRUE(load(files, {}, &reader));
  EXPECT_THAT(
      reader.calls,
      ElementsAre("ahead OWL Manchester syntax Ontology: <http://e/a>", "ahead OWL Manchester syntax Ontology: # b",
                  "read OWL functional syntax Ontology()", "read OWL Manchester syntax Ontology: <http://e/a>",
                  "read OWL Manchester syntax Ontology: # b"));
}

TEST(Load, GivesFilesInFunctionalSyntaxToTheirReader) {
  const Scratch scratch;
  const std::string functional_file = scratch.write("a.owl", "Ontology(<http://e/a>)");
  const std::string turtle = scratch.write("b.ttl", ontology("http://e/b", "; owl:imports <http://e/a>, <http://e/c>"));
  const auto refused = load(std::vector{functional_file});
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().text, HasSubstr("is in OWL functional syntax"));

  Recorder reader;
  const auto loaded = load(std::vector{functional_file, turtle}, {}, &reader);
  ASSERT_TRUE(loaded) << to_string(loaded.error());
  EXPECT_THAT(functional(loaded->source), ElementsAre("SubClassOf(:A :B)"));
  EXPECT_EQ(loaded->source.files()[0].ontology_iri, "http://e/a");
  EXPECT_EQ(loaded->source.files()[1].ontology_iri, "http://e/b");
  ASSERT_THAT(loaded->unresolved, SizeIs(2));
  EXPECT_EQ(loaded->unresolved[0].iri + ' ' + loaded->unresolved[1].iri, "http://e/d http://e/c");
  EXPECT_THAT(prefixes(*loaded), testing::Contains("other: http://o/"));
}

}  // namespace
}  // namespace geminga::rdf
