// From files and folders to the axioms of one ontology, all or nothing.
#ifndef GEMINGA_RDF_LOAD_HPP
#define GEMINGA_RDF_LOAD_HPP

#include <cstdint>
#include <expected>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "el/source.hpp"
#include "rdf/error.hpp"
#include "rdf/limits.hpp"
#include "rdf/used_names.hpp"

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

/// What a file in a syntax without triples says beside its axioms.
struct OtherDocument {
  struct Import {
    std::string iri;
    std::uint32_t line = 0;
  };
  std::string ontology_iri;
  std::string version_iri;
  std::vector<Import> imports;
  std::vector<std::pair<std::string, std::string>> prefixes;  ///< without the colon; the IRI
};

/// Reads the bytes of a file in OWL functional syntax into the source, its ontology IRI included.
using OtherReader = std::function<std::expected<OtherDocument, LoadError>(std::string_view bytes, el::FileId file,
                                                                          el::OntologySource& source)>;

/// Everything that was read.
struct Loaded {
  el::OntologySource source;
  std::uint64_t triples = 0;
  std::vector<UnresolvedImport> unresolved;     ///< in the order of reading, each IRI once; in source's left-outs, too
  std::vector<PrefixConflict> conflicts;        ///< sorted by prefix
  std::vector<UsedName> unknown_words;          ///< of triples, in the order of reading (used_names.hpp)
  std::vector<UsedName> undeclared_predicates;  ///< likewise
};

/// Reads RDF/XML, Turtle and N-Triples files, and every such file in the folders named. Opens nothing else, whatever
/// the files say. The first file that is broken, hostile or beyond a limit refuses everything, with its line. The
/// result does not depend on the order of triples; what is reported first depends on the order of files.
/// A large file is parsed by as many threads as are given; the result does not depend on them.
/// Files in OWL functional syntax go to `other`, and are refused where there is none.
[[nodiscard]] std::expected<Loaded, LoadError> load(std::span<const std::string> arguments, const Limits& limits = {},
                                                    const OtherReader& other = {}, unsigned threads = 1);

}  // namespace geminga::rdf

#endif
