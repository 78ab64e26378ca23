// From files and folders to the axioms of one ontology, all or nothing.
#ifndef GEMINGA_RDF_LOAD_HPP
#define GEMINGA_RDF_LOAD_HPP

#include <cstdint>
#include <expected>
#include <span>
#include <string>
#include <vector>

#include "el/source.hpp"
#include "rdf/error.hpp"
#include "rdf/limits.hpp"

namespace geminga::rdf {

/// An owl:imports that none of the given files answers. It is never fetched.
struct UnresolvedImport {
  std::string iri;
  std::string file;
  std::uint32_t line = 0;
};

/// A prefix that files declare for different IRIs; the other IRIs have no short names.
struct PrefixConflict {
  std::string prefix;
  std::string chosen;
  std::vector<std::string> others;  ///< sorted
};

/// Everything that was read.
struct Loaded {
  el::OntologySource source;
  std::uint64_t triples = 0;
  std::vector<UnresolvedImport> unresolved;  ///< in the order of reading, each IRI once; in source's left-outs, too
  std::vector<PrefixConflict> conflicts;     ///< sorted by prefix
};

/// Reads RDF/XML, Turtle and N-Triples files, and every such file in the folders named. Opens nothing else, whatever
/// the files say. The first file that is broken, hostile or beyond a limit refuses everything, with its line. The
/// result does not depend on the order of triples; what is reported first depends on the order of files.
[[nodiscard]] std::expected<Loaded, LoadError> load(std::span<const std::string> arguments, const Limits& limits = {});

}  // namespace geminga::rdf

#endif
