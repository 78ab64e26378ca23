// From files and folders to the axioms of one ontology, all or nothing.
#ifndef GEMINGA_REASONING_SYNTAX_RDF_LOAD_HPP
#define GEMINGA_REASONING_SYNTAX_RDF_LOAD_HPP

#include <cstdint>
#include <expected>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "reasoning/owl/annotation.hpp"
#include "reasoning/owl/document.hpp"
#include "reasoning/owl/source.hpp"
#include "reasoning/syntax/error.hpp"
#include "reasoning/syntax/files.hpp"
#include "reasoning/syntax/folders.hpp"
#include "reasoning/syntax/limits.hpp"
#include "reasoning/syntax/rdf/declared_prefixes.hpp"
#include "reasoning/syntax/rdf/scan/bases.hpp"
#include "reasoning/syntax/rdf/used_names.hpp"
#include "reasoning/syntax/syntax.hpp"

namespace geminga::rdf {

/// An owl:imports that none of the given files answers. It is never fetched.
struct UnresolvedImport {
  std::string iri;
  std::string file;
  std::uint32_t line = 0;
};

/// Reads files in syntaxes without triples into the source, with their ontology IRIs.
class OtherReader {
 public:
  virtual ~OtherReader() = default;
  /// A load begins, from its first file: what an earlier one has given is void.
  virtual void begin() {}
  /// Sees each file of a syntax in which files use each other's declarations, before the first of them is read.
  virtual void look_ahead(syntax::Syntax syntax, std::string_view bytes) = 0;
  /// Appends annotations to those that are there, if it keeps annotations.
  [[nodiscard]] virtual std::expected<owl::Document, owl::ReadError> read(
      syntax::Syntax syntax, std::string_view bytes, owl::FileId file, owl::Ontology& source,
      std::vector<owl::Annotation>& annotations) = 0;
};

/// The result of a load.
struct Loaded {
  owl::Ontology source;
  std::vector<syntax::Syntax> syntaxes;  ///< of the source's files
  syntax::Listing listing;               ///< the files of the arguments
  std::uint64_t triples = 0;
  std::vector<syntax::LoadError> refused;    ///< files of folders that were left out
  std::vector<UnresolvedImport> unresolved;  ///< in the order of reading, each IRI once; among source's left-outs
  std::vector<PrefixConflict> conflicts;     ///< sorted by prefix
  /// Of files without triples where their reader keeps them, and of triples where the limits say so.
  std::vector<owl::Annotation> annotations;
  std::vector<UsedName> unknown_words;          ///< of triples, in the order of reading (used_names.hpp)
  std::vector<UsedName> undeclared_predicates;  ///< likewise
};

/// A file that was unpacked if necessary, and scanned for what Redland must not read (scan.hpp).
struct TextFile {
  syntax::FileBytes bytes;
  syntax::Syntax syntax = syntax::Syntax::turtle;
  std::string base_iri;  ///< the base of its relative IRIs
  Bases bases;           ///< in the text some bases stand marked; IRIs that raptor resolves go through it
};

/// Reads the text of a file, for users of its triples who do not need its axioms.
[[nodiscard]] std::expected<TextFile, syntax::LoadError> read_text(const std::string& path,
                                                                   const syntax::FileLimits& limits = {});

/// Reads RDF/XML, Turtle and N-Triples files, packed by gzip or not, and every such file in the folders named and below
/// them (folders.hpp). Opens nothing else, whatever the files say. The first file that is broken, hostile or beyond a
/// limit refuses everything, with its line. The result does not depend on the order of triples; which error is reported
/// depends on the order of files. Up to `threads` threads parse a large file; the result does not depend on them. Files
/// in the syntaxes of OWL 2 go to `other`, and are refused without one. Where `left_out` is not null, a file of a
/// folder that is refused, and a catalogue, are left out and added there with their errors, up to syntax::max_left_out;
/// a file that is named itself refuses everything still. Each such file costs one more load.
[[nodiscard]] std::expected<Loaded, syntax::LoadError> load(std::span<const std::string> arguments,
                                                            const syntax::FileLimits& limits = {},
                                                            OtherReader* other = nullptr, unsigned threads = 1,
                                                            std::vector<syntax::LoadError>* left_out = nullptr);

}  // namespace geminga::rdf

#endif
