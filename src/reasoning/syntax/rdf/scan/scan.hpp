// Looks through a whole file before Redland reads it, for what Redland reads wrongly or at too great a cost.
//
// RDF.md says what raptor and libxml2 do without it. A scan is not a parser: a file that is no XML or Turtle at all is
// left to Redland.
#ifndef GEMINGA_REASONING_SYNTAX_RDF_SCAN_SCAN_HPP
#define GEMINGA_REASONING_SYNTAX_RDF_SCAN_SCAN_HPP

#include <cstddef>
#include <cstdint>
#include <expected>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reasoning/syntax/limits.hpp"
#include "reasoning/syntax/rdf/scan/bases.hpp"
#include "reasoning/syntax/rdf/scan/graph_marks.hpp"
#include "reasoning/syntax/rdf/scan/pieces.hpp"
#include "reasoning/syntax/syntax.hpp"

namespace geminga::rdf {

/// The reason why a file is refused before it is parsed.
struct ScanProblem {
  std::uint32_t line = 0;
  std::string text;
};

/// A place that a parser would refuse the file for, as it is read instead.
struct Repair {
  Rewrite rewrite;
  std::string_view remark;  ///< one of a few texts; empty: nothing is to be said about it
};

/// How a file is to be parsed.
struct Layout {
  Pieces pieces;
  std::vector<std::uint32_t> lines{};  ///< of the triples of Turtle and N-Triples, in raptor's order
  bool needs_turtle = false;     ///< N-Triples that raptor's reader of it skips or refuses, and that of Turtle reads
  bool has_collections = false;  ///< rdf:parseType="Collection"
  std::vector<BaseText> base_texts{};    ///< the bases that the file names
  std::vector<Repair> repairs{};         ///< which do not overlap
  std::vector<GraphMark> graph_marks{};  ///< which raptor does not read
  Bases bases{};                         ///< those of the bases that stand marked in the text
};

/// The layout of a file, or its first problem. Linear in the file. Two threads look at a large file in RDF/XML, if so
/// many may be used.
[[nodiscard]] std::expected<Layout, ScanProblem> scan(syntax::Syntax syntax, std::string_view bytes,
                                                      const syntax::FileLimits& limits, unsigned threads = 1);

/// The first NUL byte or bad UTF-8.
[[nodiscard]] std::optional<ScanProblem> scan_text(std::string_view bytes, bool is_utf8);
/// Turtle, TriG, N-Triples and N-Quads: nesting, long texts and IRIs, escapes for NUL and surrogates.
[[nodiscard]] std::expected<Layout, ScanProblem> scan_turtle(std::string_view bytes, bool is_n_triples,
                                                             const syntax::FileLimits& limits);
/// RDF/XML: encoding, nesting, long texts and tags, and the declarations of its DOCTYPE.
[[nodiscard]] std::expected<Layout, ScanProblem> scan_xml(std::string_view bytes, const syntax::FileLimits& limits,
                                                          unsigned threads = 1);
/// The same for OWL/XML, whose reader has limits of its own, so that nothing is looked for behind its prologue unless
/// there is a DOCTYPE in it.
[[nodiscard]] std::expected<Layout, ScanProblem> scan_owl_xml(std::string_view bytes, const syntax::FileLimits& limits);

/// The place of `encoding="NAME"` in an XML declaration, and the name. Empty without one.
struct DeclaredEncoding {
  std::size_t begin = 0;
  std::size_t size = 0;
  std::string_view name;
};
[[nodiscard]] DeclaredEncoding declared_encoding(std::string_view xml);

/// The line, from 1, of a place in a text.
[[nodiscard]] std::uint32_t line_of(std::string_view bytes, std::size_t place);

}  // namespace geminga::rdf

#endif
