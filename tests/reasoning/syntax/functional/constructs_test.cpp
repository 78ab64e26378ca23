// The source holds every construct of the structural specification as it is written.
#include <gtest/gtest.h>

#include "reasoning/syntax/functional/grammar.hpp"
#include "reasoning/syntax/functional/reading.hpp"

namespace geminga::functional {
namespace {

struct Construct {
  std::string written;
  std::string held;  ///< empty: the same

  [[nodiscard]] std::string word() const { return written.substr(0, written.find('(')); }
};

void PrintTo(const Construct& construct, std::ostream* out) { *out << construct.written; }

const std::vector<Construct> axioms = {
    {"Declaration(Class(:A))", "Declaration(:A)"},
    {"Declaration(Datatype(:T))", "Declaration(:T)"},
    {"Declaration(ObjectProperty(:p))", "Declaration(:p)"},
    {"Declaration(DataProperty(:d))", "Declaration(:d)"},
    {"Declaration(AnnotationProperty(:n))", "Declaration(:n)"},
    {"Declaration(NamedIndividual(:i))", "Declaration(:i)"},
    {"SubClassOf(:A :B)", ""},
    {"EquivalentClasses(:A :B :C)", ""},
    {"DisjointClasses(:A :B :C)", ""},
    {"DisjointUnion(:A :B :C)", ""},
    {"SubObjectPropertyOf(:p :q)", ""},
    {"SubObjectPropertyOf(ObjectPropertyChain(:p :q) :r)", ""},
    {"SubObjectPropertyOf(ObjectInverseOf(:p) ObjectInverseOf(:q))", ""},
    {"EquivalentObjectProperties(:p :q :r)", ""},
    {"DisjointObjectProperties(:p :q)", ""},
    {"InverseObjectProperties(:p :q)", ""},
    {"ObjectPropertyDomain(:p :A)", ""},
    {"ObjectPropertyRange(:p :A)", ""},
    {"FunctionalObjectProperty(:p)", ""},
    {"InverseFunctionalObjectProperty(:p)", ""},
    {"ReflexiveObjectProperty(:p)", ""},
    {"IrreflexiveObjectProperty(:p)", ""},
    {"SymmetricObjectProperty(:p)", ""},
    {"AsymmetricObjectProperty(:p)", ""},
    {"TransitiveObjectProperty(ObjectInverseOf(:p))", ""},
    {"SubDataPropertyOf(:d :e)", ""},
    {"EquivalentDataProperties(:d :e)", ""},
    {"DisjointDataProperties(:d :e)", ""},
    {"DataPropertyDomain(:d :A)", ""},
    {"DataPropertyRange(:d xsd:int)", ""},
    {"FunctionalDataProperty(:d)", ""},
    {"DatatypeDefinition(:T xsd:int)", ""},
    {"HasKey(:A (:p ObjectInverseOf(:q)) (:d :e))", "HasKey(:A :p ObjectInverseOf(:q) :d :e)"},
    {"HasKey(:A () (:d))", "HasKey(:A :d)"},
    {"SameIndividual(:i :j _:x)", "SameIndividual(:i :j _:1)"},
    {"DifferentIndividuals(:i :j :k)", ""},
    {"ClassAssertion(:A :i)", ""},
    {"ObjectPropertyAssertion(ObjectInverseOf(:p) :i _:y)", "ObjectPropertyAssertion(ObjectInverseOf(:p) :i _:1)"},
    {"NegativeObjectPropertyAssertion(:p :i :j)", ""},
    {"DataPropertyAssertion(:d :i \"7\"^^xsd:int)", ""},
    {"NegativeDataPropertyAssertion(:d :i \"text\")", ""},
    {"AnnotationAssertion(:n :A \"text\")", "-"},
    {"AnnotationAssertion(:n _:x :B)", "-"},
    {"AnnotationAssertion(:n :A _:x)", "-"},
    {"SubAnnotationPropertyOf(:n :m)", "-"},
    {"AnnotationPropertyDomain(:n :A)", "-"},
    {"AnnotationPropertyRange(:n <http://e/A>)", "-"},
};

const std::vector<Construct> class_expressions = {
    {"ObjectIntersectionOf(:A :B :C)", ""},
    {"ObjectUnionOf(:A :B)", ""},
    {"ObjectComplementOf(:A)", ""},
    {"ObjectOneOf(:i _:x)", "ObjectOneOf(:i _:1)"},
    {"ObjectSomeValuesFrom(:p :A)", ""},
    {"ObjectAllValuesFrom(ObjectInverseOf(:p) :A)", ""},
    {"ObjectHasValue(:p :i)", ""},
    {"ObjectHasSelf(:p)", ""},
    {"ObjectMinCardinality(2 :p)", ""},
    {"ObjectMinCardinality(0 :p :A)", ""},
    {"ObjectMaxCardinality(4294967295 :p)", ""},
    {"ObjectMaxCardinality(007 :p :A)", "ObjectMaxCardinality(7 :p :A)"},
    {"ObjectExactCardinality(1 :p ObjectExactCardinality(2 :q :A))", ""},
    {"DataSomeValuesFrom(:d xsd:int)", ""},
    {"DataSomeValuesFrom(:d DataComplementOf(xsd:int))", ""},
    {"DataAllValuesFrom(:d xsd:int)", ""},
    {"DataHasValue(:d \"x\"@en)", ""},
    {"DataMinCardinality(2 :d)", ""},
    {"DataMaxCardinality(2 :d xsd:int)", ""},
    {"DataExactCardinality(2 :d)", ""},
};

const std::vector<Construct> data_ranges = {
    {"DataIntersectionOf(xsd:int :T)", ""},
    {"DataUnionOf(xsd:int xsd:string)", ""},
    {"DataComplementOf(xsd:int)", ""},
    {"DataOneOf(\"1\"^^xsd:int \"a\" \"b\"@en)", ""},
    {"DatatypeRestriction(xsd:int xsd:minInclusive \"1\"^^xsd:int xsd:maxExclusive \"9\"^^xsd:int)", ""},
};

class Axiom : public testing::TestWithParam<Construct> {};

TEST_P(Axiom, IsHeldAsItIsWritten) {
  const auto& [written, held] = GetParam();
  const Reading reading(ontology(written));
  ASSERT_EQ(reading.error, "");
  if (held == "-") {
    EXPECT_EQ(reading.axioms(), std::vector<std::string>{});
    EXPECT_EQ(reading.document.annotations, 1U);
    return;
  }
  EXPECT_EQ(reading.axioms(), std::vector{held.empty() ? written : held});
  EXPECT_EQ(reading.document.axioms, 1U);
  EXPECT_EQ(reading.document.annotations, 0U);
}

TEST_P(Axiom, IsTheSameWithAnnotations) {
  const std::string& written = GetParam().written;
  const std::string annotation =
      " Annotation(Annotation(:n _:x) rdfs:comment \"why ) \\\" (\"@en) Annotation(:n <http://e/A>) ";
  std::string annotated = written;
  annotated.insert(written.find('(') + 1, annotation);
  const Reading plain(ontology(written));
  const Reading reading(ontology(annotated));
  ASSERT_EQ(reading.error, "");
  EXPECT_EQ(reading.axioms(), plain.axioms());
  EXPECT_EQ(reading.document.annotations, plain.document.annotations + 3);
}

TEST_P(Axiom, IsRefusedWithoutItsLastOperand) {
  std::string cut = GetParam().written;
  const std::size_t end = cut.size() - 1;
  const std::size_t begin = cut.find_last_of(" (", end - 1);
  cut.erase(begin + 1, end - begin - 1);
  const Reading reading(ontology(cut));
  if (reading.error.empty()) {
    // Only lists may be shorter.
    EXPECT_TRUE(find_production(GetParam().word())->repeated != Operand::none) << cut;
  } else {
    EXPECT_EQ(reading.error.substr(0, 6), "t.ofn:") << cut;
  }
}

TEST_P(Axiom, IsRefusedWithOneOperandTooMany) {
  std::string longer = GetParam().written;
  longer.insert(longer.size() - 1, " \"x\"");
  const Reading reading(ontology(longer));
  EXPECT_EQ(reading.error.substr(0, 8), "t.ofn:2:") << longer;
}

INSTANTIATE_TEST_SUITE_P(Construct, Axiom, testing::ValuesIn(axioms),
                         [](const auto& given) { return given.param.word() + "_" + std::to_string(given.index); });

class Expression : public testing::TestWithParam<std::pair<Construct, std::string>> {};

TEST_P(Expression, IsHeldAsItIsWritten) {
  const auto& [construct, axiom] = GetParam();
  const Reading reading(ontology(axiom + construct.written + ')'));
  ASSERT_EQ(reading.error, "");
  EXPECT_EQ(reading.axioms(), std::vector{axiom + (construct.held.empty() ? construct.written : construct.held) + ')'});
}

TEST_P(Expression, IsRefusedInPlaceOfAProperty) {
  const Reading reading(ontology("ObjectPropertyDomain(" + GetParam().first.written + " :A)"));
  EXPECT_EQ(reading.error, "t.ofn:2: expected an object property, found " + GetParam().first.word());
}

std::vector<std::pair<Construct, std::string>> expressions() {
  std::vector<std::pair<Construct, std::string>> all;
  for (const Construct& construct : class_expressions) all.emplace_back(construct, "SubClassOf(:Z ");
  for (const Construct& construct : data_ranges) all.emplace_back(construct, "DataPropertyRange(:d ");
  return all;
}

INSTANTIATE_TEST_SUITE_P(Construct, Expression, testing::ValuesIn(expressions()), [](const auto& given) {
  return given.param.first.word() + "_" + std::to_string(given.index);
});

TEST(Grammar, HasEveryKindOfAxiomAndTermUnderItsWord) {
  for (std::uint8_t kind = 0; kind < owl::axiom_kind_count; ++kind) {
    const std::string_view word = owl::to_string(static_cast<owl::AxiomKind>(kind));
    const Production* production = find_production(word);
    ASSERT_NE(production, nullptr) << word;
    if (production->form != Form::axiom) continue;
    EXPECT_EQ(production->kind, kind) << word;
  }
  const auto first = static_cast<std::uint8_t>(owl::TermKind::object_inverse_of);
  for (std::uint8_t kind = first; kind < static_cast<std::uint8_t>(owl::TermKind::facet); ++kind) {
    const std::string_view word = owl::to_string(static_cast<owl::TermKind>(kind));
    const Production* production = find_production(word);
    ASSERT_NE(production, nullptr) << word;
    EXPECT_EQ(production->kind, kind) << word;
  }
  EXPECT_EQ(find_production("subClassOf"), nullptr);
  EXPECT_EQ(find_production(""), nullptr);
  EXPECT_EQ(find_production(std::string(1000, 'S')), nullptr);
}

TEST(Grammar, HasACaseForEveryWord) {
  std::string all;
  for (const auto* list : {&axioms, &class_expressions, &data_ranges}) {
    for (const Construct& construct : *list) all += construct.written + ' ';
  }
  for (const char* word :
       {"Class", "Datatype", "ObjectProperty", "DataProperty", "AnnotationProperty", "NamedIndividual"})
    EXPECT_NE(all.find("(" + std::string(word) + "("), std::string::npos) << word;
  for (std::uint8_t kind = 0; kind < static_cast<std::uint8_t>(owl::AxiomKind::dl_safe_rule); ++kind)
    EXPECT_NE(all.find(std::string(owl::to_string(static_cast<owl::AxiomKind>(kind))) + '('), std::string::npos);
  for (auto kind = static_cast<std::uint8_t>(owl::TermKind::object_inverse_of);
       kind < static_cast<std::uint8_t>(owl::TermKind::facet); ++kind)
    EXPECT_NE(all.find(std::string(owl::to_string(static_cast<owl::TermKind>(kind))) + '('), std::string::npos);
}

}  // namespace
}  // namespace geminga::functional
