// The result of a reader of OWL's own syntaxes beside the axioms that it adds to the source, and its errors.
#ifndef GEMINGA_REASONING_OWL_DOCUMENT_HPP
#define GEMINGA_REASONING_OWL_DOCUMENT_HPP

#include <cstdint>
#include <string>
#include <vector>

namespace geminga::owl {

/// An ontology that the file imports. It is recorded and never fetched.
struct Import {
  std::string iri;
  std::uint32_t line = 0;
};

/// A prefix that the file declares. The prefixes that every file knows (owl, rdf, rdfs, xsd) are listed only if it
/// declares them.
struct DeclaredPrefix {
  std::string prefix;  ///< without the colon; empty: the default one
  std::string iri;
};

/// The parts of a file beside its axioms. Imports and prefixes stand in the order of the file, each once.
struct Document {
  std::string ontology_iri;  ///< empty: the ontology has no name
  std::string version_iri;
  std::vector<Import> imports;
  std::vector<DeclaredPrefix> prefixes;
  std::uint64_t axioms = 0;       ///< handed to the source, declarations included; not what is left out
  std::uint64_t annotations = 0;  ///< of whatever they stand at, and axioms about annotation properties
  std::uint64_t vacuous = 0;      ///< axioms that say nothing, like EquivalentClasses(:A)
};

/// A file that was refused. `text` is one line of UTF-8.
struct ReadError {
  std::string file;
  std::uint32_t line = 0;  ///< 0: the file as a whole
  std::string text;
};

/// "soma.owl:17: what is wrong", or "soma.owl: what is wrong" where there is no line.
[[nodiscard]] inline std::string to_string(const ReadError& error) {
  std::string text = error.file;
  if (error.line != 0) text += ':' + std::to_string(error.line);
  if (!text.empty()) text += ": ";
  return text + error.text;
}

}  // namespace geminga::owl

#endif
