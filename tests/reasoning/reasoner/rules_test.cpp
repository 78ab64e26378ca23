// Rules of SWRL: what follows for named individuals, and what is not known.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>
#include <string>
#include <string_view>
#include <vector>

#include "reasoning/reasoner/reasoner.hpp"
#include "reasoning/syntax/functional/read.hpp"

namespace geminga::reasoner {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

/// An ontology in the functional-style syntax, in which x, y, z and v, w are variables of rules written ?x.
owl::Ontology ontology(std::string_view axioms) {
  std::string text =
      "Prefix(:=<http://e/>)Prefix(b:=<http://www.w3.org/2003/11/swrlb#>)Prefix(xsd:=<http://www.w3.org/2001/"
      "XMLSchema#>)Prefix(owl:=<http://www.w3.org/2002/07/owl#>)Ontology(\n";
  for (std::size_t at = 0; at < axioms.size(); ++at) {
    if (axioms[at] == '?') {
      text += "Variable(:" + std::string(1, axioms[++at]) + ')';
    } else {
      text += axioms[at];
    }
  }
  owl::Ontology source;
  const auto read = functional::read(text + ')', source.add_file("a.ofn"), source, {.wrong_axioms = 0});
  EXPECT_TRUE(read) << (read ? "" : to_string(read.error()));
  return source;
}

/// The answer to the last axiom, as a conclusion of those before it: "yes", "no", or why it is not known.
std::string last_follows(std::string_view axioms) {
  const owl::Ontology source = ontology(axioms);
  std::vector<std::uint32_t> premise(source.axiom_count() - 1);
  std::iota(premise.begin(), premise.end(), 0U);
  const std::vector<std::uint32_t> conclusion{static_cast<std::uint32_t>(premise.size())};
  const Answer answer = entails_each(source, premise, conclusion).front();
  return answer.verdict == Verdict::yes ? "yes" : answer.verdict == Verdict::no ? "no" : answer.reason;
}

std::string consistent(std::string_view axioms) {
  const Answer answer = is_consistent(ontology(axioms));
  return answer.verdict == Verdict::yes ? "yes" : answer.verdict == Verdict::no ? "no" : answer.reason;
}

const std::string uncle =
    "DLSafeRule(Body(ObjectPropertyAtom(:parent ?x ?y) ObjectPropertyAtom(:brother ?y ?z)) "
    "Head(ObjectPropertyAtom(:uncle ?x ?z)))";

TEST(Rules, JoinFactsOfNamedIndividuals) {
  const std::string facts = "ObjectPropertyAssertion(:parent :a :b)ObjectPropertyAssertion(:brother :b :c)";
  EXPECT_EQ(last_follows(uncle + facts + "ObjectPropertyAssertion(:uncle :a :c)"), "yes");
  EXPECT_EQ(last_follows(uncle + facts + "ObjectPropertyAssertion(:uncle :b :c)"), "no");
}

TEST(Rules, AreNotAboutIndividualsWithoutAName) {
  EXPECT_EQ(last_follows(uncle + "ObjectPropertyAssertion(:parent :a _:b)ObjectPropertyAssertion(:brother _:b :c)"
                                 "ObjectPropertyAssertion(:uncle :a :c)"),
            "no");
  EXPECT_EQ(last_follows(uncle + "ClassAssertion(ObjectSomeValuesFrom(:parent ObjectHasValue(:brother :c)) :a)"
                                 "ObjectPropertyAssertion(:uncle :a :c)"),
            "no");
  EXPECT_EQ(last_follows(uncle + "ClassAssertion(ObjectSomeValuesFrom(:parent ObjectIntersectionOf(ObjectOneOf(:b) "
                                 "ObjectHasValue(:brother :c))) :a)ObjectPropertyAssertion(:uncle :a :c)"),
            "yes");
  EXPECT_EQ(last_follows("DLSafeRule(Body(ClassAtom(:A ?x)) Head(ClassAtom(:B ?x)))SubClassOf(:A :B)"), "no");
  EXPECT_EQ(last_follows("DLSafeRule(Body(ClassAtom(:A ?x)) Head(ClassAtom(:B ?x)))ClassAssertion(:A :a)"
                         "SubClassOf(:A :B)"),
            "no");
}

TEST(Rules, ReachClassesThroughNominals) {
  EXPECT_EQ(last_follows("DLSafeRule(Body(ClassAtom(:A ?x)) Head(ClassAtom(:B ?x)))ClassAssertion(:A :a)"
                         "SubClassOf(:Q ObjectOneOf(:a))SubClassOf(:Q :B)"),
            "yes");
  const owl::Ontology source = ontology(
      "DLSafeRule(Body(ClassAtom(:A ?x)) Head(ClassAtom(:B ?x)))ClassAssertion(:A :a)SubClassOf(:Q ObjectOneOf(:a))");
  const auto classified = classify(source);
  ASSERT_TRUE(classified);
  EXPECT_THAT(classified->gaps, IsEmpty());
  EXPECT_THAT(classified->unused, IsEmpty());
}

TEST(Rules, HoldOfWhatFollowsAndWhatIsEqual) {
  EXPECT_EQ(last_follows("SubClassOf(:A0 ObjectUnionOf(:A :C))DisjointClasses(:A0 :C)ClassAssertion(:A0 :a)"
                         "DLSafeRule(Body(ClassAtom(:A ?x)) Head(ClassAtom(:B ?x)))ClassAssertion(:B :a)"),
            "yes");
  EXPECT_EQ(last_follows(uncle + "ObjectPropertyAssertion(:parent :a :b)ObjectPropertyAssertion(:brother :d :c)"
                                 "SameIndividual(:b :d)ObjectPropertyAssertion(:uncle :a :c)"),
            "yes");
  EXPECT_EQ(last_follows(uncle + "ObjectPropertyAssertion(:parent :a :b)ObjectPropertyAssertion(:brother :d :c)"
                                 "FunctionalObjectProperty(:parent)ObjectPropertyAssertion(:parent :a :d)"
                                 "ObjectPropertyAssertion(:uncle :a :c)"),
            "yes");
}

TEST(Rules, HoldInEachCaseOfAnAlternative) {
  EXPECT_EQ(
      last_follows("ClassAssertion(ObjectUnionOf(:A :C) :a)DLSafeRule(Body(ClassAtom(:A ?x)) Head(ClassAtom(:B ?x)))"
                   "DLSafeRule(Body(ClassAtom(:C ?x)) Head(ClassAtom(:B ?x)))ClassAssertion(:B :a)"),
      "yes");
  EXPECT_EQ(
      last_follows("ClassAssertion(ObjectUnionOf(:A :C) :a)DLSafeRule(Body(ClassAtom(:A ?x)) Head(ClassAtom(:B ?x)))"
                   "ClassAssertion(:B :a)"),
      "no");
}

TEST(Rules, HaveClassExpressionsOnBothSides) {
  EXPECT_EQ(last_follows("DLSafeRule(Body(ClassAtom(ObjectSomeValuesFrom(:p :A) ?x)) Head(ClassAtom("
                         "ObjectAllValuesFrom(:q :B) ?x)))ClassAssertion(ObjectSomeValuesFrom(:p :A) :a)"
                         "ObjectPropertyAssertion(:q :a :b)ClassAssertion(:B :b)"),
            "yes");
  EXPECT_EQ(consistent("DLSafeRule(Body(ClassAtom(ObjectComplementOf(:A) ?x)) Head())ClassAssertion(ObjectComplementOf("
                       ":A) :a)"),
            "no");
}

TEST(Rules, FollowPathsOfPropertiesThatAreNotSimple) {
  const std::string rule =
      "DLSafeRule(Body(ObjectPropertyAtom(:part ?x ?y)) Head(ObjectPropertyAtom(:linked ?y ?x)))"
      "TransitiveObjectProperty(:part)ObjectPropertyAssertion(:part :a :b)";
  EXPECT_EQ(last_follows(rule + "ObjectPropertyAssertion(:part :b :c)ObjectPropertyAssertion(:linked :c :a)"), "yes");
  EXPECT_EQ(last_follows(rule + "ClassAssertion(ObjectSomeValuesFrom(:part ObjectHasValue(:part :c)) :b)"
                                "ObjectPropertyAssertion(:linked :c :a)"),
            "yes");
  EXPECT_EQ(last_follows(rule + "ObjectPropertyAssertion(:part :c :b)ObjectPropertyAssertion(:linked :c :a)"), "no");
}

TEST(Rules, SayWhichIndividualsAreOneOrTwo) {
  const std::string same = "DLSafeRule(Body(ObjectPropertyAtom(:p ?x ?y)) Head(SameIndividualAtom(?x ?y)))";
  EXPECT_EQ(last_follows(same + "ObjectPropertyAssertion(:p :a :b)ClassAssertion(:A :a)ClassAssertion(:A :b)"), "yes");
  EXPECT_EQ(consistent(same + "ObjectPropertyAssertion(:p :a :b)DifferentIndividuals(:a :b)"), "no");
  const std::string differ = "DLSafeRule(Body(ObjectPropertyAtom(:p ?x ?y)) Head(DifferentIndividualsAtom(?x ?y)))";
  EXPECT_EQ(last_follows(differ + "ObjectPropertyAssertion(:p :a :b)DifferentIndividuals(:a :b)"), "yes");
  EXPECT_EQ(consistent(differ + "ObjectPropertyAssertion(:p :a :a)"), "no");
  EXPECT_EQ(last_follows("DLSafeRule(Body(SameIndividualAtom(?x :a)) Head(ClassAtom(:B ?x)))SameIndividual(:a :b)"
                         "ClassAssertion(:B :b)"),
            "yes");
}

TEST(Rules, TakeIndividualsForOneUnlessTheyDiffer) {
  const std::string rule =
      "DLSafeRule(Body(ClassAtom(:A ?x) ClassAtom(:A ?y) DifferentIndividualsAtom(?x ?y)) Head(ClassAtom(:B ?x)))"
      "ClassAssertion(:A :a)ClassAssertion(:A :b)";
  EXPECT_EQ(last_follows(rule + "ClassAssertion(:B :a)"), "no");
  EXPECT_EQ(last_follows(rule + "DifferentIndividuals(:a :b)ClassAssertion(:B :a)"), "yes");
  EXPECT_EQ(last_follows(rule + "ClassAssertion(ObjectComplementOf(:B) :a)SameIndividual(:a :b)"), "yes");
}

TEST(Rules, CompareAndMakeValues) {
  const std::string rule =
      "DLSafeRule(Body(DataPropertyAtom(:d ?x ?v) BuiltInAtom(b:greaterThan ?v \"5\"^^xsd:integer) BuiltInAtom(b:add "
      "?w "
      "?v \"0.5\"^^xsd:decimal)) Head(DataPropertyAtom(:e ?x ?w)))DataPropertyAssertion(:d :a \"6\"^^xsd:int)";
  EXPECT_EQ(last_follows(rule + "DataPropertyAssertion(:e :a \"6.5\"^^xsd:decimal)"), "yes");
  EXPECT_EQ(last_follows(rule + "DataPropertyAssertion(:e :a \"6\"^^xsd:decimal)"), "no");
  EXPECT_EQ(consistent(rule + "DataPropertyRange(:e xsd:integer)"), "no");
}

TEST(Rules, JoinValues) {
  const std::string rule =
      "DLSafeRule(Body(DataPropertyAtom(:d ?x ?v) DataPropertyAtom(:e ?y ?v)) Head(ObjectPropertyAtom(:p ?x ?y)))"
      "DataPropertyAssertion(:d :a \"1\"^^xsd:integer)";
  EXPECT_EQ(last_follows(rule + "DataPropertyAssertion(:e :b \"1.0\"^^xsd:decimal)ObjectPropertyAssertion(:p :a :b)"),
            "yes");
  EXPECT_EQ(last_follows(rule + "DataPropertyAssertion(:e :b \"1\"^^xsd:double)ObjectPropertyAssertion(:p :a :b)"),
            "no");
}

TEST(Rules, CompareByValueWhatFactsBind) {
  const std::string facts =
      "DataPropertyAssertion(:d :a \"1\"^^xsd:integer)DataPropertyAssertion(:e :a \"1\"^^xsd:double)";
  EXPECT_EQ(
      last_follows("DLSafeRule(Body(DataPropertyAtom(:d ?x ?v) DataPropertyAtom(:e ?x ?w) BuiltInAtom(b:equal ?v ?w)) "
                   "Head(ClassAtom(:A ?x)))" +
                   facts + "ClassAssertion(:A :a)"),
      "yes");
  EXPECT_EQ(last_follows("DLSafeRule(Body(DataPropertyAtom(:d ?x ?v) DataPropertyAtom(:e ?y ?w) "
                         "BuiltInAtom(b:multiply ?w ?v ?v)) Head(ObjectPropertyAtom(:r ?x ?y)))" +
                         facts + "ObjectPropertyAssertion(:r :a :a)"),
            "yes");
}

TEST(Rules, KnowAValueThatIsTheOnlyOne) {
  const std::string rule =
      "DLSafeRule(Body(DataPropertyAtom(:d ?x ?v) BuiltInAtom(b:greaterThan ?v \"5\"^^xsd:integer)) Head(ClassAtom(:B "
      "?x)))";
  EXPECT_EQ(
      last_follows(rule + "ClassAssertion(DataSomeValuesFrom(:d DataOneOf(\"6\"^^xsd:int)) :a)ClassAssertion(:B :a)"),
      "yes");
  EXPECT_EQ(last_follows(rule + "ClassAssertion(DataSomeValuesFrom(:d xsd:integer) :a)ClassAssertion(:B :a)"), "no");
  EXPECT_EQ(last_follows(rule + "ClassAssertion(DataSomeValuesFrom(:d DataOneOf(\"6\"^^xsd:int \"7\"^^xsd:int)) :a)"
                                "ClassAssertion(:B :a)"),
            "values in a swrl:Imp that are not known (a.ofn:2)");
}

TEST(Rules, HaveRangesAndConstants) {
  EXPECT_EQ(
      last_follows("DLSafeRule(Body(DataPropertyAtom(:d ?x ?v) DataRangeAtom(xsd:byte ?v)) Head(ClassAtom(:B ?x)))"
                   "DataPropertyAssertion(:d :a \"127\"^^xsd:int)ClassAssertion(:B :a)"),
      "yes");
  EXPECT_EQ(
      last_follows("DLSafeRule(Body(DataPropertyAtom(:d ?x ?v) DataRangeAtom(xsd:byte ?v)) Head(ClassAtom(:B ?x)))"
                   "DataPropertyAssertion(:d :a \"128\"^^xsd:int)ClassAssertion(:B :a)"),
      "no");
  EXPECT_EQ(last_follows(
                "DLSafeRule(Body(DataPropertyAtom(:d ?x \"true\"^^xsd:boolean)) Head(DataPropertyAtom(:e ?x \"on\")))"
                "DataPropertyAssertion(:d :a \"1\"^^xsd:boolean)DataPropertyAssertion(:e :a \"on\")"),
            "yes");
  EXPECT_EQ(consistent("DLSafeRule(Body(DataPropertyAtom(:d ?x ?v)) Head(BuiltInAtom(b:lessThan ?v \"5\"^^xsd:int)))"
                       "DataPropertyAssertion(:d :a \"5\"^^xsd:int)"),
            "no");
}

TEST(Rules, OfWhichSomethingIsNotKnownAreNamedWhereTheyMayMatter) {
  const std::string rule =
      "DLSafeRule(Body(ClassAtom(:A ?x) BuiltInAtom(<http://e/unheard> ?x)) Head(ClassAtom(:B ?x)))";
  const std::string unknown =
      "DLSafeRule(Body(DataPropertyAtom(:d ?x ?v) BuiltInAtom(<http://e/unheard> ?v)) Head(ClassAtom(:B ?x)))";
  EXPECT_EQ(consistent(unknown + "ClassAssertion(:A :a)"), "yes");
  EXPECT_EQ(last_follows(unknown + "ClassAssertion(:A :a)ClassAssertion(:B :a)"), "no");
  EXPECT_EQ(last_follows(unknown + "DataPropertyAssertion(:d :a \"5\")ClassAssertion(:B :a)"),
            "a built-in of a swrl:Imp that is not known (a.ofn:2)");
  EXPECT_EQ(last_follows(unknown + "DataPropertyAssertion(:d :a \"5\")ClassAssertion(:B :a)ClassAssertion(:C :a)"),
            "no");
  EXPECT_THAT(consistent(rule + "ClassAssertion(:A :a)"), HasSubstr("individual and for a value"));
  EXPECT_EQ(last_follows("DLSafeRule(Body(ClassAtom(:A ?x)) Head(ObjectPropertyAtom(:p ?x ?y)))ClassAssertion(:A :a)"
                         "ClassAssertion(:B :a)"),
            "a swrl:Variable of a head that the body does not bind (a.ofn:2)");
  EXPECT_EQ(last_follows("DLSafeRule(Body(ClassAtom(:A ?x) BuiltInAtom(b:lessThan ?v ?w)) Head(ClassAtom(:B ?x)))"
                         "ClassAssertion(:A :a)ClassAssertion(:B :a)"),
            "a swrl:Variable of a value that nothing binds (a.ofn:2)");
}

TEST(Rules, LeaveNothingOpenWhereAModelKeepsThemWhateverTheirUnknownPartsSay) {
  const std::string premise =
      "DLSafeRule(Body(DataPropertyAtom(:d ?x ?v) BuiltInAtom(<http://e/unheard> ?v)) Head(ClassAtom(:B ?x)))"
      "DataPropertyAssertion(:d :a \"5\")";
  const std::string unheard = "a built-in of a swrl:Imp that is not known (a.ofn:2)";
  EXPECT_EQ(consistent(premise), "yes");
  EXPECT_EQ(last_follows(premise + "ClassAssertion(:C :a)"), "no");
  EXPECT_EQ(last_follows(premise + "SubClassOf(:B :C)ClassAssertion(:C :a)"), unheard);
  EXPECT_EQ(consistent(premise + "ClassAssertion(ObjectComplementOf(:B) :a)"), unheard);
  // With nominals, the facts of such a model do not follow.
  EXPECT_EQ(consistent(premise + "SubClassOf(:N ObjectOneOf(:a))"), "yes");
  EXPECT_EQ(last_follows(premise + "SubClassOf(:N ObjectOneOf(:a))SubClassOf(:N :B)"), unheard);
  EXPECT_EQ(last_follows(premise + "SubClassOf(:N ObjectOneOf(:a))SubClassOf(:N :C)"), "no");
  // Nothing says which individual a variable of the head is, and an empty head is false.
  EXPECT_NE(consistent("DLSafeRule(Body(ClassAtom(:A ?x)) Head(ObjectPropertyAtom(:p ?x ?y)))ClassAssertion(:A :a)"),
            "yes");
  EXPECT_EQ(consistent("DLSafeRule(Body(DataPropertyAtom(:d ?x ?v) BuiltInAtom(<http://e/unheard> ?v)) Head())"
                       "DataPropertyAssertion(:d :a \"5\")"),
            unheard);
}

TEST(Rules, AsConclusionsFollowWhereTheyAreStated) {
  EXPECT_EQ(last_follows(uncle + uncle), "yes");
  EXPECT_EQ(last_follows("ClassAssertion(:A :a)" + uncle), "rules follow only where they are stated");
}

TEST(Rules, ThatGoOnForEverReachALimit) {
  const std::string next =
      "DLSafeRule(Body(DataPropertyAtom(:d ?x ?v) BuiltInAtom(b:add ?w ?v \"1\"^^xsd:integer)) "
      "Head(DataPropertyAtom(:d ?x "
      "?w)))DataPropertyAssertion(:d :a \"0\"^^xsd:integer)";
  EXPECT_THAT(consistent(next), HasSubstr("more than"));
}

TEST(Rules, HaveAtMost256Atoms) {
  const auto rule = [](std::size_t atoms) {
    std::string text = "DLSafeRule(Body(";
    for (std::size_t at = 1; at < atoms; ++at) text += "ClassAtom(:A" + std::to_string(at) + " Variable(:x)) ";
    return text + ") Head(ClassAtom(:B Variable(:x))))ClassAssertion(:A :a)ClassAssertion(:B :a)";
  };
  EXPECT_EQ(last_follows(rule(255)), "no");
  EXPECT_EQ(last_follows(rule(256)), "no");
  EXPECT_THAT(last_follows(rule(257)), HasSubstr("more than 256 atoms"));
}

}  // namespace
}  // namespace geminga::reasoner
