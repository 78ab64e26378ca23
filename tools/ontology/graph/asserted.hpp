// The triples that loaded files assert: read from files of triples, made of the axioms in OWL's own syntaxes.
#ifndef GEMINGA_ONTOLOGY_GRAPH_ASSERTED_HPP
#define GEMINGA_ONTOLOGY_GRAPH_ASSERTED_HPP

#include <optional>
#include <string>
#include <string_view>

#include "reasoning/syntax/graph/graph.hpp"
#include "reasoning/syntax/rdf/load.hpp"

namespace geminga::ontology {

/// Fills a graph as one ontology: it has the name and the header of the first file that has one, and the imports that
/// no file answered. Returns why that failed, in one line.
[[nodiscard]] std::optional<std::string> add_asserted(const rdf::Loaded& loaded, graph::Graph& graph);

/// The prefixes of the files.
[[nodiscard]] graph::Prefixes prefixes_of(const owl::Ontology& source);
/// These, and those that short names have for namespaces without a prefix (owl::Prefixes).
[[nodiscard]] graph::Prefixes found_prefixes_of(const owl::Ontology& source);

/// The name of the ontology that the files are together; empty where no file has one.
[[nodiscard]] std::string ontology_name(const rdf::Loaded& loaded);

/// Whether a name is a word of RDF, RDFS, XSD or OWL, which has its kind by itself.
[[nodiscard]] bool is_of_w3c(std::string_view name);

}  // namespace geminga::ontology

#endif
