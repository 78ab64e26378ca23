// Rules of SWRL in Manchester syntax, as the OWL API writes them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reasoning/syntax/frames/reading.hpp"

namespace geminga::frames {
namespace {

using testing::ElementsAre;
using testing::StartsWith;

TEST(FrameRules, HaveAtomsOfEachKind) {
  EXPECT_THAT(
      said("ObjectProperty: p\nDataProperty: d\nDatatype: t\n"
           "Rule: A(?x), (A and not B)(?x), p(?x, :i), inverse p(?x, ?<http://e/v>), d(?x, ?v), t(?v), integer[> "
           "3](?v),\n"
           "  SameAs(?x, ?y), DifferentFrom(?x, _:b) -> B(?x)"),
      ElementsAre("DLSafeRule(Atoms(ClassAtom(:A ?<urn:swrl:var#x>) "
                  "ClassAtom(ObjectIntersectionOf(:A ObjectComplementOf(:B)) ?<urn:swrl:var#x>) "
                  "ObjectPropertyAtom(:p ?<urn:swrl:var#x> :i) "
                  "ObjectPropertyAtom(ObjectInverseOf(:p) ?<urn:swrl:var#x> ?:v) "
                  "DataPropertyAtom(:d ?<urn:swrl:var#x> ?<urn:swrl:var#v>) DataRangeAtom(:t ?<urn:swrl:var#v>) "
                  "DataRangeAtom(DatatypeRestriction(xsd:integer xsd:minExclusive \"3\"^^xsd:integer) "
                  "?<urn:swrl:var#v>) SameIndividualAtom(?<urn:swrl:var#x> ?<urn:swrl:var#y>) "
                  "DifferentIndividualsAtom(?<urn:swrl:var#x> _:1)) Atoms(ClassAtom(:B ?<urn:swrl:var#x>)))"));
}

TEST(FrameRules, TakeNamesThatAreDeclaredNowhereForBuiltIns) {
  EXPECT_THAT(said("Rule: <http://www.w3.org/2003/11/swrlb#lessThan>(?a, 5), q(?a, ?b), r(), s(?a, ?b, \"c\") -> "),
              ElementsAre("DLSafeRule(Atoms(BuiltInAtom(<http://www.w3.org/2003/11/swrlb#lessThan> ?<urn:swrl:var#a> "
                          "\"5\"^^xsd:integer) BuiltInAtom(:q ?<urn:swrl:var#a> ?<urn:swrl:var#b>) BuiltInAtom(:r) "
                          "BuiltInAtom(:s ?<urn:swrl:var#a> ?<urn:swrl:var#b> \"c\")) Atoms())"));
}

TEST(FrameRules, InOtherWordsAreLeftOutByName) {
  for (const std::string rule :
       {"A(?x) => B(?x)", "A ?x -> B(?x)", "A(?) -> B(?x)", "-> ->", "A(?x)", "A(?x -> B(?x)", "n:A(?x) -> B(?x)"})
    EXPECT_THAT(said("Class: A SubClassOf: B\nRule: " + rule + "\nClass: B SubClassOf: C"),
                ElementsAre("SubClassOf(:A :B)", "SubClassOf(:B :C)", "left out: swrl:Imp, 1, line 3"))
        << rule;
}

TEST(FrameRules, WithATextThatNeverEndsAreAnError) {
  EXPECT_THAT(said("Rule: A(\"x -> B(?x)\nClass: B"), ElementsAre(StartsWith("t.omn:2: a text")));
}

}  // namespace
}  // namespace geminga::frames
