// The IRIs of the vocabulary, in the order of Word.
#include "reasoning/syntax/vocabulary.hpp"

#include <array>
#include <cstddef>
#include <utility>

namespace geminga::syntax {
namespace {

#define RDF(name) "http://www.w3.org/1999/02/22-rdf-syntax-ns#" name
#define RDFS(name) "http://www.w3.org/2000/01/rdf-schema#" name
#define OWL(name) "http://www.w3.org/2002/07/owl#" name
#define SWRL(name) "http://www.w3.org/2003/11/swrl#" name

constexpr std::array<std::string_view, static_cast<std::size_t>(Word::count)> words{
    "",
    RDF("type"),
    RDF("first"),
    RDF("rest"),
    RDF("nil"),
    RDF("List"),
    RDF("Property"),
    RDF("PlainLiteral"),
    RDF("XMLLiteral"),
    RDF("langString"),
    RDF("subject"),
    RDF("predicate"),
    RDF("object"),
    RDFS("Class"),
    RDFS("Resource"),
    RDFS("Datatype"),
    RDFS("Literal"),
    RDFS("subClassOf"),
    RDFS("subPropertyOf"),
    RDFS("domain"),
    RDFS("range"),
    RDFS("label"),
    RDFS("comment"),
    RDFS("seeAlso"),
    RDFS("isDefinedBy"),
    "http://www.w3.org/2004/02/skos/core#prefLabel",
    OWL("Class"),
    OWL("Restriction"),
    OWL("SelfRestriction"),
    OWL("DataRange"),
    OWL("Ontology"),
    OWL("Axiom"),
    OWL("Annotation"),
    OWL("NamedIndividual"),
    OWL("Thing"),
    OWL("Nothing"),
    OWL("ObjectProperty"),
    OWL("DatatypeProperty"),
    OWL("AnnotationProperty"),
    OWL("OntologyProperty"),
    OWL("DeprecatedClass"),
    OWL("DeprecatedProperty"),
    OWL("FunctionalProperty"),
    OWL("InverseFunctionalProperty"),
    OWL("ReflexiveProperty"),
    OWL("IrreflexiveProperty"),
    OWL("SymmetricProperty"),
    OWL("AsymmetricProperty"),
    OWL("TransitiveProperty"),
    OWL("AllDisjointClasses"),
    OWL("AllDisjointProperties"),
    OWL("AllDifferent"),
    OWL("NegativePropertyAssertion"),
    OWL("topObjectProperty"),
    OWL("bottomObjectProperty"),
    OWL("topDataProperty"),
    OWL("bottomDataProperty"),
    OWL("real"),
    OWL("rational"),
    OWL("equivalentClass"),
    OWL("disjointWith"),
    OWL("disjointUnionOf"),
    OWL("equivalentProperty"),
    OWL("propertyDisjointWith"),
    OWL("inverseOf"),
    OWL("propertyChainAxiom"),
    OWL("propertyChain"),
    OWL("hasKey"),
    OWL("sameAs"),
    OWL("differentFrom"),
    OWL("intersectionOf"),
    OWL("unionOf"),
    OWL("complementOf"),
    OWL("oneOf"),
    OWL("datatypeComplementOf"),
    OWL("onProperty"),
    OWL("onProperties"),
    OWL("onClass"),
    OWL("onDataRange"),
    OWL("onDatatype"),
    OWL("withRestrictions"),
    OWL("someValuesFrom"),
    OWL("allValuesFrom"),
    OWL("hasValue"),
    OWL("hasSelf"),
    OWL("minCardinality"),
    OWL("maxCardinality"),
    OWL("cardinality"),
    OWL("minQualifiedCardinality"),
    OWL("maxQualifiedCardinality"),
    OWL("qualifiedCardinality"),
    OWL("members"),
    OWL("distinctMembers"),
    OWL("sourceIndividual"),
    OWL("assertionProperty"),
    OWL("targetIndividual"),
    OWL("targetValue"),
    OWL("annotatedSource"),
    OWL("annotatedProperty"),
    OWL("annotatedTarget"),
    OWL("imports"),
    OWL("versionIRI"),
    OWL("versionInfo"),
    OWL("priorVersion"),
    OWL("backwardCompatibleWith"),
    OWL("incompatibleWith"),
    OWL("deprecated"),
    SWRL("Imp"),
    SWRL("body"),
    SWRL("head"),
    SWRL("Variable"),
    SWRL("ClassAtom"),
    SWRL("DataRangeAtom"),
    SWRL("IndividualPropertyAtom"),
    SWRL("DatavaluedPropertyAtom"),
    SWRL("SameIndividualAtom"),
    SWRL("DifferentIndividualsAtom"),
    SWRL("BuiltinAtom"),
    SWRL("classPredicate"),
    SWRL("dataRange"),
    SWRL("propertyPredicate"),
    SWRL("argument1"),
    SWRL("argument2"),
    SWRL("builtin"),
    SWRL("arguments"),
};

#undef SWRL
#undef RDF
#undef RDFS
#undef OWL

constexpr std::array<std::pair<std::string_view, std::string_view>, 6> namespaces{{
    {"rdf:", rdf_namespace},
    {"rdfs:", rdfs_namespace},
    {"owl:", owl_namespace},
    {"xsd:", xsd_namespace},
    {"skos:", skos_namespace},
    {"swrl:", swrl_namespace},
}};

}  // namespace

std::string_view iri_of(Word word) { return words[static_cast<std::size_t>(word)]; }

std::string short_word(std::string_view iri) {
  for (const auto& [prefix, name] : namespaces) {
    if (iri.starts_with(name)) return std::string(prefix).append(iri.substr(name.size()));
  }
  return '<' + std::string(iri) + '>';
}

}  // namespace geminga::syntax
