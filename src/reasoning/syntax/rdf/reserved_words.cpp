// RDF 1.1 Concepts and Schema; OWL 2 Mapping to RDF Graphs and its predecessor of 2004; XML Schema 1.1, part 2.
#include "reasoning/syntax/rdf/reserved_words.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "base/edit_distance.hpp"
#include "base/text.hpp"
#include "reasoning/syntax/vocabulary.hpp"

namespace geminga::rdf {
namespace {

constexpr std::string_view rdf_words =
    "type first rest nil List Property Statement subject predicate object value Bag Seq Alt PlainLiteral "
    "XMLLiteral HTML langString langRange JSON CompoundLiteral direction language dirLangString";
constexpr std::string_view rdfs_words =
    "Class Resource Datatype Literal subClassOf subPropertyOf domain range label comment seeAlso isDefinedBy "
    "member Container ContainerMembershipProperty";
constexpr std::string_view owl_words =
    "AllDifferent AllDisjointClasses AllDisjointProperties Annotation AnnotationProperty AsymmetricProperty "
    "Axiom Class DataRange DatatypeProperty DeprecatedClass DeprecatedProperty FunctionalProperty "
    "InverseFunctionalProperty IrreflexiveProperty NamedIndividual NegativePropertyAssertion Nothing "
    "ObjectProperty Ontology OntologyProperty ReflexiveProperty Restriction SymmetricProperty Thing "
    "TransitiveProperty allValuesFrom annotatedProperty annotatedSource annotatedTarget assertionProperty "
    "backwardCompatibleWith bottomDataProperty bottomObjectProperty cardinality complementOf "
    "datatypeComplementOf deprecated differentFrom disjointUnionOf disjointWith distinctMembers equivalentClass "
    "equivalentProperty hasKey hasSelf hasValue imports incompatibleWith intersectionOf inverseOf maxCardinality "
    "maxQualifiedCardinality members minCardinality minQualifiedCardinality onClass onDataRange onDatatype "
    "onProperties onProperty oneOf priorVersion propertyChainAxiom propertyDisjointWith qualifiedCardinality "
    "rational real sameAs someValuesFrom sourceIndividual targetIndividual targetValue topDataProperty "
    "topObjectProperty unionOf versionIRI versionInfo withRestrictions";
constexpr std::string_view xsd_words =
    "anyType anySimpleType anyAtomicType string boolean decimal float double duration dateTime time date "
    "gYearMonth gYear gMonthDay gDay gMonth hexBinary base64Binary anyURI QName NOTATION normalizedString token "
    "language NMTOKEN NMTOKENS Name NCName ID IDREF IDREFS ENTITY ENTITIES integer nonPositiveInteger "
    "negativeInteger long int short byte nonNegativeInteger unsignedLong unsignedInt unsignedShort unsignedByte "
    "positiveInteger yearMonthDuration dayTimeDuration dateTimeStamp length minLength maxLength pattern "
    "enumeration whiteSpace maxInclusive maxExclusive minExclusive minInclusive totalDigits fractionDigits "
    "assertions explicitTimezone";

struct Vocabulary {
  std::string_view prefix;
  std::string_view iri;
  std::string_view words;  ///< separated by blanks
};
constexpr std::array<Vocabulary, 4> vocabularies{{{"rdf", syntax::rdf_namespace, rdf_words},
                                                  {"rdfs", syntax::rdfs_namespace, rdfs_words},
                                                  {"owl", syntax::owl_namespace, owl_words},
                                                  {"xsd", syntax::xsd_namespace, xsd_words}}};

const Vocabulary* vocabulary_of(std::string_view iri) {
  const auto found =
      std::ranges::find_if(vocabularies, [&](const Vocabulary& vocabulary) { return iri.starts_with(vocabulary.iri); });
  return found == vocabularies.end() ? nullptr : &*found;
}

/// Calls `take` with each word, until it returns true.
template <typename Take>
bool any_word(std::string_view words, Take&& take) {
  while (!words.empty()) {
    const std::size_t end = std::min(words.find(' '), words.size());
    if (take(words.substr(0, end))) return true;
    words.remove_prefix(std::min(end + 1, words.size()));
  }
  return false;
}

}  // namespace

bool is_reserved(std::string_view iri) { return vocabulary_of(iri) != nullptr; }

bool is_reserved_word(std::string_view iri) {
  const Vocabulary* vocabulary = vocabulary_of(iri);
  if (vocabulary == nullptr) return false;
  const std::string_view local = iri.substr(vocabulary->iri.size());
  // rdf:_1, rdf:_2 and so on are the members of containers.
  if (vocabulary->prefix == "rdf" && local.starts_with('_') && base::parse_number<std::uint64_t>(local.substr(1)))
    return true;
  return local.empty() || any_word(vocabulary->words, [&](std::string_view word) { return word == local; });
}

std::vector<std::string> similar_words(std::string_view iri) {
  constexpr std::size_t max_words = 3;
  const Vocabulary* own = vocabulary_of(iri);
  if (own == nullptr) return {};
  const std::string_view local = iri.substr(own->iri.size());
  const std::size_t limit = base::tolerated_slips(local);
  std::vector<std::pair<std::size_t, std::string>> found;
  for (const Vocabulary& vocabulary : vocabularies) {
    any_word(vocabulary.words, [&](std::string_view word) {
      const std::size_t distance = base::edit_distance(local, word, limit);
      // A word of another vocabulary counts as one more letter: owl:subClassOf, rdfs:Restriction.
      if (distance <= limit)
        found.emplace_back(distance + (&vocabulary == own ? 0 : 1),
                           std::string(vocabulary.prefix) + ':' + std::string(word));
      return false;
    });
  }
  std::ranges::sort(found);
  std::vector<std::string> words;
  for (auto& [distance, word] : found) {
    if (words.size() == max_words || distance > found.front().first + 1) break;
    words.push_back(std::move(word));
  }
  return words;
}

}  // namespace geminga::rdf
