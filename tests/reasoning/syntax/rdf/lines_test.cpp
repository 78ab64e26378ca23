// Axioms of Turtle files stand on the lines of their objects, however their statement is laid out.
#include <gtest/gtest.h>

#include "reasoning/syntax/rdf/functional.hpp"
#include "reasoning/syntax/rdf/reading.hpp"

namespace geminga::rdf {
namespace {

std::vector<std::string> axioms_with_lines(std::string_view text) {
  const auto loaded = load_text("a.ttl", std::string(turtle_prefixes) + std::string(text));
  if (!loaded) return {to_string(loaded.error())};
  std::vector<std::string> axioms = functional(loaded->source);
  std::size_t place = 0;
  for (std::size_t index = 0; index < loaded->source.axiom_count(); ++index) {
    const owl::Axiom axiom = loaded->source.axiom(index);
    if (axiom.kind != owl::AxiomKind::declaration) axioms[place++].insert(0, std::to_string(axiom.line) + ": ");
  }
  return axioms;
}

using Lines = std::vector<std::string>;

TEST(TurtleLines, AreThoseOfTheObjects) {
  EXPECT_EQ(axioms_with_lines(":A a owl:Class ;\n"
                              "  rdfs:label \"\"\"a\nlong \\\"\"\" label\"\"\"@en , 'b'^^<http://e/t>, 3.5, true ;\n"
                              "  rdfs:subClassOf :B , # not this ; one .\n"
                              "    :C ;\n"
                              "  ;\n"
                              "  rdfs:subClassOf :D.\n"
                              ":E rdfs:subClassOf :F .:G rdfs:subClassOf\n:H.\n"),
            (Lines{"5: SubClassOf(:A :B)", "6: SubClassOf(:A :C)", "8: SubClassOf(:A :D)", "9: SubClassOf(:E :F)",
                   "10: SubClassOf(:G :H)"}));
}

TEST(TurtleLines, FollowBracketsAndLists) {
  EXPECT_EQ(axioms_with_lines(":p a owl:ObjectProperty .\n"
                              ":A rdfs:subClassOf\n"
                              "  [ a owl:Restriction ;\n"
                              "    owl:onProperty :p ;\n"
                              "    owl:someValuesFrom [ owl:intersectionOf ( :B\n"
                              "      [ owl:unionOf (:C :D) ] ) ] ] ,\n"
                              "  :E ;\n"
                              "  owl:disjointWith :F .\n"
                              "[] a owl:AllDisjointClasses ;\n"
                              "  owl:members ( :A :B\n :C ) .\n"
                              "[ a\n owl:AllDifferent ; owl:members (:i :j) ] .\n"
                              ":x owl:sameAs :y .\n"),
            (Lines{"4: SubClassOf(:A ObjectSomeValuesFrom(:p ObjectIntersectionOf(:B ObjectUnionOf(:C :D))))",
                   "8: SubClassOf(:A :E)", "9: DisjointClasses(:A :F)", "10: DisjointClasses(:A :B :C)",
                   "14: DifferentIndividuals(:i :j)", "15: SameIndividual(:x :y)"}));
}

TEST(TurtleLines, AreNotLedAstrayByDirectivesEscapesAndEmptyThings) {
  EXPECT_EQ(axioms_with_lines("PREFIX x: <http://e/>\n"
                              "@base <http://e/base> .\n"
                              "BASE <http://e/>\n"
                              "x:A rdfs:subClassOf x:B .\n"
                              "x:a\\.b rdfs:subClassOf x:c\\;d .\n"
                              "<A> rdfs:seeAlso () , [] , ( [] ) ;\n"
                              "  rdfs:subClassOf <C> .\n"),
            (Lines{"5: SubClassOf(:A :B)", "6: SubClassOf(:a.b :c;d)", "8: SubClassOf(:A :C)"}));
}

}  // namespace
}  // namespace geminga::rdf
