// Reads the triples of one file by itself, and makes the most of a file that is not quite right.
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

/// What was read of one file.
struct Tolerated {
  syntax::Syntax syntax = syntax::Syntax::rdf_xml;
  Graph graph;  ///< of one file, not indexed; empty in a syntax without triples
  /// Where reading ended before the end of the file. What stands before is in the graph.
  std::optional<syntax::LoadError> broken_off;
};

/// For users of collections that nobody mends any more; load() refuses where this one tolerates. RDF/XML that cannot be
/// read as it is, is read as repair.hpp mends it; what cannot be read even so counts up to the first error. Refused is
/// what cannot be opened and what Redland must not see (scan.hpp). Opens nothing but the file.
[[nodiscard]] std::expected<Tolerated, syntax::LoadError> read_tolerantly(const std::string& path,
                                                                          const syntax::Limits& limits = {});

}  // namespace geminga::rdf

#endif
