// The words of the functional-style syntax for kinds of terms and axioms.
#include "reasoning/owl/axiom.hpp"

#include <array>

namespace geminga::owl {
namespace {

constexpr std::array<std::string_view, term_kind_count> term_words = {
    "Class",
    "ObjectProperty",
    "DataProperty",
    "AnnotationProperty",
    "Datatype",
    "NamedIndividual",
    "AnonymousIndividual",
    "Literal",
    "LanguageTag",
    "ObjectInverseOf",
    "ObjectPropertyChain",
    "ObjectIntersectionOf",
    "ObjectUnionOf",
    "ObjectComplementOf",
    "ObjectOneOf",
    "ObjectSomeValuesFrom",
    "ObjectAllValuesFrom",
    "ObjectHasValue",
    "ObjectHasSelf",
    "ObjectMinCardinality",
    "ObjectMaxCardinality",
    "ObjectExactCardinality",
    "DataSomeValuesFrom",
    "DataAllValuesFrom",
    "DataHasValue",
    "DataMinCardinality",
    "DataMaxCardinality",
    "DataExactCardinality",
    "DataIntersectionOf",
    "DataUnionOf",
    "DataComplementOf",
    "DataOneOf",
    "DatatypeRestriction",
    "Facet",
    "Variable",
    "ClassAtom",
    "DataRangeAtom",
    "ObjectPropertyAtom",
    "DataPropertyAtom",
    "SameIndividualAtom",
    "DifferentIndividualsAtom",
    "BuiltInAtom",
    "Atoms",
};

constexpr std::array<std::string_view, axiom_kind_count> axiom_words = {
    "Declaration",
    "SubClassOf",
    "EquivalentClasses",
    "DisjointClasses",
    "DisjointUnion",
    "SubObjectPropertyOf",
    "EquivalentObjectProperties",
    "DisjointObjectProperties",
    "InverseObjectProperties",
    "ObjectPropertyDomain",
    "ObjectPropertyRange",
    "FunctionalObjectProperty",
    "InverseFunctionalObjectProperty",
    "ReflexiveObjectProperty",
    "IrreflexiveObjectProperty",
    "SymmetricObjectProperty",
    "AsymmetricObjectProperty",
    "TransitiveObjectProperty",
    "SubDataPropertyOf",
    "EquivalentDataProperties",
    "DisjointDataProperties",
    "DataPropertyDomain",
    "DataPropertyRange",
    "FunctionalDataProperty",
    "DatatypeDefinition",
    "HasKey",
    "SameIndividual",
    "DifferentIndividuals",
    "ClassAssertion",
    "ObjectPropertyAssertion",
    "NegativeObjectPropertyAssertion",
    "DataPropertyAssertion",
    "NegativeDataPropertyAssertion",
    "DLSafeRule",
};

}  // namespace

std::string_view to_string(TermKind kind) { return term_words[static_cast<std::size_t>(kind)]; }
std::string_view to_string(AxiomKind kind) { return axiom_words[static_cast<std::size_t>(kind)]; }

}  // namespace geminga::owl
