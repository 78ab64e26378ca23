// Names in triples that may be mistakes: words that the reserved vocabularies do not have, and predicates that nothing
// declares, which the mapping takes for annotation properties.
#ifndef GEMINGA_REASONING_SYNTAX_RDF_USED_NAMES_HPP
#define GEMINGA_REASONING_SYNTAX_RDF_USED_NAMES_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "reasoning/syntax/rdf/triples/graph.hpp"

namespace geminga::rdf {

/// The most names of either kind that are noted. A file can invent any number.
inline constexpr std::size_t max_used_names = 1000;

/// A name and where it stands first.
struct UsedName {
  std::string iri;
  std::uint32_t file = 0;
  std::uint32_t line = 0;
};

/// Names in the namespaces of RDF, RDFS, OWL and XSD that are not in these vocabularies, in the order of reading.
[[nodiscard]] std::vector<UsedName> unknown_words(const Graph& graph);

/// Predicates outside these namespaces that have no rdf:type, in the order of reading. Requires an indexed graph.
[[nodiscard]] std::vector<UsedName> undeclared_predicates(const Graph& graph);

}  // namespace geminga::rdf

#endif
