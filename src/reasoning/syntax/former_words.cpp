// Tables of words. Sources: DAML+OIL (March 2001) Reference Description; OWL Web Ontology Language 1.0 Reference,
// Working Draft 29 July 2002; OWL 1.1: Mapping to RDF Graphs, Member Submission 19 December 2006; OWL 2: Mapping to RDF
// Graphs, Working Draft 11 April 2008. The OWL API reads most of them so, too.
#include "reasoning/syntax/former_words.hpp"

#include <algorithm>
#include <array>
#include <span>

#include "reasoning/syntax/vocabulary.hpp"

namespace geminga::syntax {
namespace {

struct Renamed {
  std::string_view former;
  std::string_view space;  ///< of the word of OWL 2
  std::string_view name;
};

/// Words of OWL's own namespace in drafts.
constexpr std::array of_drafts{
    Renamed{"subObjectPropertyOf", rdfs_namespace, "subPropertyOf"},
    Renamed{"subDataPropertyOf", rdfs_namespace, "subPropertyOf"},
    Renamed{"objectPropertyDomain", rdfs_namespace, "domain"},
    Renamed{"dataPropertyDomain", rdfs_namespace, "domain"},
    Renamed{"objectPropertyRange", rdfs_namespace, "range"},
    Renamed{"dataPropertyRange", rdfs_namespace, "range"},
    Renamed{"equivalentObjectProperties", owl_namespace, "equivalentProperty"},
    Renamed{"equivalentDataProperties", owl_namespace, "equivalentProperty"},
    Renamed{"disjointObjectProperties", owl_namespace, "propertyDisjointWith"},
    Renamed{"disjointDataProperties", owl_namespace, "propertyDisjointWith"},
    Renamed{"inverseObjectPropertyExpression", owl_namespace, "inverseOf"},
    Renamed{"FunctionalObjectProperty", owl_namespace, "FunctionalProperty"},
    Renamed{"FunctionalDataProperty", owl_namespace, "FunctionalProperty"},
    Renamed{"InverseFunctionalObjectProperty", owl_namespace, "InverseFunctionalProperty"},
    Renamed{"NegativeObjectPropertyAssertion", owl_namespace, "NegativePropertyAssertion"},
    Renamed{"NegativeDataPropertyAssertion", owl_namespace, "NegativePropertyAssertion"},
    Renamed{"ObjectRestriction", owl_namespace, "Restriction"},
    Renamed{"DataRestriction", owl_namespace, "Restriction"},
    Renamed{"cardinalityType", owl_namespace, "onClass"},
    Renamed{"valuesFrom", owl_namespace, "onClass"},
    Renamed{"dataComplementOf", owl_namespace, "datatypeComplementOf"},
    Renamed{"subject", owl_namespace, "annotatedSource"},
    Renamed{"predicate", owl_namespace, "annotatedProperty"},
    Renamed{"object", owl_namespace, "annotatedTarget"},
    Renamed{"length", xsd_namespace, "length"},
    Renamed{"minLength", xsd_namespace, "minLength"},
    Renamed{"maxLength", xsd_namespace, "maxLength"},
    Renamed{"pattern", xsd_namespace, "pattern"},
    Renamed{"minInclusive", xsd_namespace, "minInclusive"},
    Renamed{"minExclusive", xsd_namespace, "minExclusive"},
    Renamed{"maxInclusive", xsd_namespace, "maxInclusive"},
    Renamed{"maxExclusive", xsd_namespace, "maxExclusive"},
    Renamed{"totalDigits", xsd_namespace, "totalDigits"},
    Renamed{"fractionDigits", xsd_namespace, "fractionDigits"},
    Renamed{"sameClassAs", owl_namespace, "equivalentClass"},
    Renamed{"samePropertyAs", owl_namespace, "equivalentProperty"},
    Renamed{"sameIndividualAs", owl_namespace, "sameAs"},
    Renamed{"differentIndividualFrom", owl_namespace, "differentFrom"},
};

/// Beside them, words of OWL 1.1's own namespaces. In OWL's namespace "antisymmetric" may be what mathematicians call
/// so; OWL 1.1's is asymmetric.
constexpr std::array of_owl11{
    Renamed{"AntisymmetricProperty", owl_namespace, "AsymmetricProperty"},
    Renamed{"Individual", owl_namespace, "NamedIndividual"},
    Renamed{"DataProperty", owl_namespace, "DatatypeProperty"},
    Renamed{"Datatype", rdfs_namespace, "Datatype"},
    Renamed{"declaredAs", rdf_namespace, "type"},
};

constexpr std::array of_daml{
    Renamed{"type", rdf_namespace, "type"},
    Renamed{"value", rdf_namespace, "value"},
    Renamed{"Property", rdf_namespace, "Property"},
    Renamed{"List", rdf_namespace, "List"},
    Renamed{"first", rdf_namespace, "first"},
    Renamed{"rest", rdf_namespace, "rest"},
    Renamed{"nil", rdf_namespace, "nil"},
    Renamed{"Literal", rdfs_namespace, "Literal"},
    Renamed{"Datatype", rdfs_namespace, "Datatype"},
    Renamed{"subClassOf", rdfs_namespace, "subClassOf"},
    Renamed{"subPropertyOf", rdfs_namespace, "subPropertyOf"},
    Renamed{"domain", rdfs_namespace, "domain"},
    Renamed{"range", rdfs_namespace, "range"},
    Renamed{"label", rdfs_namespace, "label"},
    Renamed{"comment", rdfs_namespace, "comment"},
    Renamed{"seeAlso", rdfs_namespace, "seeAlso"},
    Renamed{"isDefinedBy", rdfs_namespace, "isDefinedBy"},
    Renamed{"toClass", owl_namespace, "allValuesFrom"},
    Renamed{"hasClass", owl_namespace, "someValuesFrom"},
    Renamed{"hasClassQ", owl_namespace, "onClass"},
    Renamed{"cardinalityQ", owl_namespace, "qualifiedCardinality"},
    Renamed{"minCardinalityQ", owl_namespace, "minQualifiedCardinality"},
    Renamed{"maxCardinalityQ", owl_namespace, "maxQualifiedCardinality"},
    Renamed{"sameClassAs", owl_namespace, "equivalentClass"},
    Renamed{"samePropertyAs", owl_namespace, "equivalentProperty"},
    Renamed{"sameIndividualAs", owl_namespace, "sameAs"},
    Renamed{"differentIndividualFrom", owl_namespace, "differentFrom"},
    Renamed{"UniqueProperty", owl_namespace, "FunctionalProperty"},
    Renamed{"UnambiguousProperty", owl_namespace, "InverseFunctionalProperty"},
};

std::optional<std::string> renamed(std::string_view word, std::span<const Renamed> table) {
  const auto found = std::ranges::find(table, word, &Renamed::former);
  if (found == table.end()) return std::nullopt;
  return std::string(found->space).append(found->name);
}

std::string of_owl(std::string_view word) { return std::string(owl_namespace).append(word); }

}  // namespace

std::optional<std::string> word_of_owl2(std::string_view iri) {
  if (!iri.starts_with("http://www.")) return std::nullopt;  // asked of every name of a file
  if (iri.starts_with(owl_namespace)) return renamed(iri.substr(owl_namespace.size()), of_drafts);
  for (const std::string_view space : {"http://www.w3.org/2006/12/owl11#", "http://www.w3.org/2006/12/owl2#"}) {
    if (!iri.starts_with(space)) continue;
    const std::string_view word = iri.substr(space.size());
    if (auto draft = renamed(word, of_drafts)) return draft;
    return renamed(word, of_owl11).value_or(of_owl(word));
  }
  for (const std::string_view space :
       {"http://www.daml.org/2001/03/daml+oil#", "http://www.daml.org/2000/12/daml+oil#"}) {
    if (!iri.starts_with(space)) continue;
    const std::string_view word = iri.substr(space.size());
    return renamed(word, of_daml).value_or(of_owl(word));
  }
  if (iri == mistyped_nil) return std::string(rdf_namespace).append("nil");
  return std::nullopt;
}

}  // namespace geminga::syntax
