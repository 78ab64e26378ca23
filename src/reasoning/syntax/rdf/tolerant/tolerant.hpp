// Reads the triples of one file, also of a file that is not quite right.
#ifndef GEMINGA_REASONING_SYNTAX_RDF_TOLERANT_TOLERANT_HPP
#define GEMINGA_REASONING_SYNTAX_RDF_TOLERANT_TOLERANT_HPP

#include <expected>
#include <optional>
#include <string>

#include "reasoning/syntax/error.hpp"
#include "reasoning/syntax/limits.hpp"
#include "reasoning/syntax/rdf/triples/graph.hpp"
#include "reasoning/syntax/syntax.hpp"

namespace geminga::rdf {

/// The triples of one file.
struct Tolerated {
  syntax::Syntax syntax = syntax::Syntax::rdf_xml;
  Graph graph;  ///< of one file, not indexed; empty in a syntax without triples
  /// The place where reading ended before the end of the file. The triples before it are in the graph.
  std::optional<syntax::LoadError> broken_off;
};

/// Reads a file of a collection that nobody maintains, where load() would refuse it. RDF/XML that cannot be read as it
/// is is repaired (repair.hpp) and read again. A file that cannot be read even then counts up to the first error.
/// Refuses files that cannot be opened or that Redland must not read (scan.hpp). Opens no other file.
[[nodiscard]] std::expected<Tolerated, syntax::LoadError> read_tolerantly(const std::string& path,
                                                                          const syntax::FileLimits& limits = {});

}  // namespace geminga::rdf

#endif
