// The triples of what was loaded: as they stand in files of triples, and made of axioms in OWL's own syntaxes.
#ifndef GEMINGA_ONTOLOGY_TRIPLES_HPP
#define GEMINGA_ONTOLOGY_TRIPLES_HPP

#include <expected>
#include <optional>
#include <string>

#include "reasoning/syntax/graph/graph.hpp"
#include "reasoning/syntax/rdf/load.hpp"

namespace geminga::ontology {

/// Fills a graph as one ontology: it has the name and the header of the first file that has one, and imports only what
/// no file answered. Why that failed, in one line.
[[nodiscard]] std::optional<std::string> add_asserted(const rdf::Loaded& loaded, graph::Graph& graph);

/// The prefixes of the files.
[[nodiscard]] graph::Prefixes prefixes_of(const owl::Ontology& source);

/// The name of the ontology that the files are together; empty: none has one.
[[nodiscard]] std::string ontology_name(const rdf::Loaded& loaded);

/// The format that is asked for by name, or else by the name of the output; Turtle on standard output. The error is a
/// line for the user.
[[nodiscard]] std::expected<graph::Format, std::string> chosen_format(const std::string& name, const std::string& out);
inline constexpr const char* format_names = "turtle, rdfxml or ntriples";
inline constexpr const char* format_choices = "turtle|rdfxml|ntriples";  ///< the same, as the type of a flag

}  // namespace geminga::ontology

#endif
