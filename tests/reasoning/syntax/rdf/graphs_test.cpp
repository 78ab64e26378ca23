// Files of TriG and N-Quads: what all their graphs say together, with the lines of the file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reasoning/syntax/rdf/functional.hpp"
#include "reasoning/syntax/rdf/reading.hpp"
#include "reasoning/syntax/rdf/scratch.hpp"

namespace geminga::rdf {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

/// The axioms of a file with their lines, then the remarks with theirs.
std::vector<std::string> told(const std::string& name, std::string_view content) {
  const auto loaded = load_text(name, content);
  if (!loaded) return {to_string(loaded.error())};
  std::vector<std::string> lines;
  const auto axioms = functional(loaded->source);
  for (std::size_t at = 0; at < axioms.size(); ++at)
    lines.push_back(std::to_string(loaded->source.axiom(at).line) + ": " + axioms[at]);
  for (const auto& note : loaded->source.remarks())
    lines.push_back("remark " + std::to_string(note.line) + ": " + std::string(loaded->source.name(note.construct)));
  return lines;
}

const std::string head = "@prefix : <http://e/> . @prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .\n";
const std::string sub = "<http://www.w3.org/2000/01/rdf-schema#subClassOf>";

std::string remark(int line) {
  return "remark " + std::to_string(line) + ": graphs of TriG or N-Quads, read as one graph";
}

TEST(Graphs, OfTrigAreReadAsOneWithTheLinesOfTheFile) {
  for (const char* name : {"a.trig", "a.ttl", "a.owl", "a.unknown"}) {
    EXPECT_THAT(
        told(name, head + ":A rdfs:subClassOf :B .\n"
                          ":g { :C rdfs:subClassOf\n :D }\n"
                          "GRAPH # why\n <http://e/{h}>\n{ :E rdfs:subClassOf :F . }:i{:G rdfs:subClassOf :H}:I "
                          "rdfs:subClassOf :J .\n"
                          "{}\n{ :K rdfs:subClassOf :L. # }\n}\n"),
        ElementsAre("2: SubClassOf(:A :B)", "4: SubClassOf(:C :D)", "7: SubClassOf(:E :F)", "7: SubClassOf(:G :H)",
                    "7: SubClassOf(:I :J)", "9: SubClassOf(:K :L)", remark(3)))
        << name;
  }
}

TEST(Graphs, MayHaveBlankNodesForNamesAndShareTheirOwn) {
  EXPECT_THAT(
      told("a.trig", head + "_:g { :A rdfs:subClassOf _:u }\ngraph _:g { _:u a owl:Class ; owl:unionOf (:B :C) }\n"
                            "[] { :D rdfs:subClassOf :E } [ ] {}\n"),
      testing::IsSupersetOf({"2: SubClassOf(:A ObjectUnionOf(:B :C))", "4: SubClassOf(:D :E)"}));
}

TEST(Graphs, MayEndBehindALiteralOrABracket) {
  for (const char* object : {"5", "5.0", "1e3", "true", "\"x\"@en", "\"x\"^^xsd:string", "[]", "()", ":b"}) {
    EXPECT_THAT(told("a.trig", head + ":g {:a :p " + object + "}:h {:A rdfs:subClassOf :B}"),
                testing::Contains("2: SubClassOf(:A :B)"))
        << object;
  }
}

TEST(Graphs, OfQuadsAreReadAsOne) {
  const std::string quads = "<http://e/A> " + sub + " <http://e/B> <http://e/g> .\n<http://e/C> " + sub +
                            " <http://e/D> _:g . # c\n<http://e/E> " + sub +
                            " <http://e/F> .\n<http://e/x> <http://e/p> " +
                            "\"5 .\"^^<http://www.w3.org/2001/XMLSchema#string> <http://e/g>.\n";
  for (const char* name : {"a.nq", "a.nt", "a.ttl", "a.unknown"}) {
    EXPECT_THAT(told(name, quads),
                testing::IsSupersetOf({std::string("1: SubClassOf(:A :B)"), std::string("2: SubClassOf(:C :D)"),
                                       std::string("3: SubClassOf(:E :F)"), remark(1)}))
        << name;
  }
  EXPECT_THAT(told("a.nq", quads + "# it's\n"), testing::Contains("2: SubClassOf(:C :D)")) << "raptor's Turtle reader";
}

TEST(Graphs, AFourthTermOfTurtleIsAFault) {
  EXPECT_THAT(told("a.ttl", head + "<http://e/A> " + sub + " <http://e/B> <http://e/C> .\n"),
              ElementsAre(StartsWith("a.ttl:2: ")));
  EXPECT_THAT(told("a.ttl", "<A> <p> <B> <C> .\n"), ElementsAre(StartsWith("a.ttl:1: ")));
  EXPECT_THAT(told("a.nq",
                   "<http://e/A> <http://e/p> <http://e/B> .\n<http://e/A> <http://e/p> <http://e/B> "
                   "<http://e/g> <http://e/h> .\n"),
              ElementsAre(StartsWith("a.nq:2: ")));
  EXPECT_THAT(told("a.nq", "<http://e/A> <http://e/p> <http://e/B> \"g\" .\n"), ElementsAre(StartsWith("a.nq:1: ")));
}

TEST(Graphs, ThatTrigHasNotAreRefusedWithTheirLine) {
  const std::string good = head + ":g {}\n";
  const auto has_none = HasSubstr(" has { ... } where TriG has none: Notation 3 is not read, convert it to Turtle");
  for (const char* bad : {"{ :A a :B } => { :A a :C } .", "{ :A a :B } :implies { :A a :C } .",
                          ":a :says { :A a :B } .", ":g { :h { :A a :B } }", "(1) { :A a :B }", "[ :p :q ] { :A a :B }",
                          "\"g\" { :A a :B }", "a { :A a :B }", ":g :h { :A a :B }", "GRAPH { :A a :B }",
                          "GRAPH GRAPH :g { :A a :B }", "{ :A a :B", ":A a :B }", "@prefix {}", ":g ; { :A a :B }"}) {
    EXPECT_THAT(told("a.trig", good + bad), ElementsAre(testing::AllOf(StartsWith("a.trig:3:"), has_none))) << bad;
  }
  for (const char* bad : {":g { :A a }", ":g { :A a [ }", ":g { :A a (:B }", "GRAPH :g :A a :B .", ":g { :A a :B ] }"})
    EXPECT_THAT(told("a.trig", good + bad + "\n"), ElementsAre(StartsWith("a.trig:3: "))) << bad;
  EXPECT_THAT(told("a.ttl", head + ":a :says { :A a :B } .\n"), ElementsAre(has_none)) << "without a graph before it";
  EXPECT_THAT(told("a.ttl", "body { color: red }\n"), ElementsAre(StartsWith("a.ttl:1: "))) << "no RDF at all";
}

}  // namespace
}  // namespace geminga::rdf
