// Limits of a file of triples. RDF.md says what each protects from.
#ifndef GEMINGA_REASONING_SYNTAX_LIMITS_HPP
#define GEMINGA_REASONING_SYNTAX_LIMITS_HPP

#include <cstddef>

namespace geminga::syntax {

/// A file that exceeds one of these is refused, with the limit and the line, before or while Redland reads it.
struct FileLimits {
  std::size_t files = 10'000;
  /// The entries of a folder and all folders below it, whatever they are.
  std::size_t folder_entries = 100'000;
  /// Levels of folders below the one that is named.
  std::size_t folder_levels = 64;
  std::size_t file_bytes = std::size_t{1} << 30;
  /// How many times its size a packed file may unpack to, or to `inflated_free_bytes` if that is more; never to more
  /// than file_bytes. Ontologies grow 5 to 60 times, a bomb 1000 times: 1 MB may take 64 MB.
  std::size_t inflated_growth = 64;
  std::size_t inflated_free_bytes = std::size_t{16} << 20;
  /// Not a limit: in a file larger than this, a text that is too long is found before the rest of the file is in
  /// memory.
  std::size_t watched_bytes = std::size_t{8} << 20;
  /// Not a limit: the size of the pieces in which several threads read a large file. Smaller files are read whole.
  std::size_t piece_bytes = std::size_t{2} << 20;
  /// Not a limit: the annotations of triples are kept, comments as well.
  bool keeps_annotations = false;
  /// Not a limit: bounds and literals of another numeric datatype are read as numbers (owl::Ontology).
  bool is_lenient = false;
  std::size_t triples = 100'000'000;  ///< of all files together
  /// Of one text: raptor's N-Triples reader is quadratic in it.
  std::size_t literal_bytes = std::size_t{1} << 20;
  std::size_t iri_bytes = 8192;
  /// White space and comments of Turtle and N-Triples in a row: raptor's Turtle reader keeps what is before the next
  /// statement, its N-Triples reader is quadratic in a line.
  std::size_t blank_bytes = std::size_t{1} << 20;
  /// Of XML elements or Turtle brackets: raptor's RDF/XML reader is quadratic in it.
  std::size_t nesting = 512;
  /// Of one Turtle statement: raptor keeps it as a whole.
  std::size_t statement_triples = 200'000;
  /// Of one file: different pairs of a prefix and its IRI; in Turtle all declarations, which raptor searches from the
  /// first on.
  std::size_t prefixes = 10'000;
  /// The graphs of a file of TriG, of which each takes two marks until they are blotted out.
  std::size_t graphs = 1'000'000;
  /// Different pairs of a prefix and its IRI of all files together. Published files have ten, and most have the same.
  std::size_t all_prefixes = 50'000;
  /// Not a limit: how many imports that no file answers are left out under names of their own; others are counted.
  std::size_t named_imports = 1000;
  /// Of one XML element: libxml2 compares each with each.
  std::size_t attributes = 1024;
  /// Places of one XML file that are not as RDF/XML has it, and are read as something else.
  std::size_t repairs = 1'000'000;
  /// Of one XML tag.
  std::size_t tag_bytes = std::size_t{1} << 22;
  /// Internal entities of one DOCTYPE.
  std::size_t entities = 4096;
  /// Octets that one internal entity expands to.
  std::size_t entity_bytes = std::size_t{1} << 16;
  /// Octets that all references to internal entities expand to: this, and `entity_growth` times the size of the file.
  std::size_t expansion_bytes = std::size_t{1} << 20;
  std::size_t entity_growth = 16;
};

}  // namespace geminga::syntax

#endif
