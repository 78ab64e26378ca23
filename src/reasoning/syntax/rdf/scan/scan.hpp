// Looks a whole file through before Redland sees it, for what Redland reads wrongly or at too great a cost.
//
// Raptor cuts names at a NUL, logs and skips bad UTF-8, is quadratic in the nesting of RDF/XML and in long texts, and
// libxml2 expands entities without end. A scan is not a parser: what is no XML or Turtle at all is left to Redland.
#ifndef GEMINGA_REASONING_SYNTAX_RDF_SCAN_SCAN_HPP
#define GEMINGA_REASONING_SYNTAX_RDF_SCAN_SCAN_HPP

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "reasoning/syntax/limits.hpp"
#include "reasoning/syntax/syntax.hpp"

namespace geminga::rdf {

/// Why a file is refused before it is parsed.
struct ScanProblem {
  std::uint32_t line = 0;
  std::string text;
};

class Pieces;
class TurtleLines;

/// The first problem of a file, or nothing. Linear in the file. `lines` follows the statements of a Turtle file;
/// `pieces` learns where the file can be cut.
[[nodiscard]] std::optional<ScanProblem> scan(syntax::Syntax syntax, std::string_view bytes,
                                              const syntax::Limits& limits, TurtleLines& lines, Pieces& pieces);

/// NUL bytes and bad UTF-8.
[[nodiscard]] std::optional<ScanProblem> scan_text(std::string_view bytes, bool is_utf8);
/// Turtle and N-Triples: nesting, long texts and IRIs, escapes for NUL and surrogates.
[[nodiscard]] std::optional<ScanProblem> scan_turtle(std::string_view bytes, const syntax::Limits& limits,
                                                     TurtleLines& lines, Pieces& pieces);
/// RDF/XML: encoding, nesting, long texts and tags, and what its DOCTYPE declares.
[[nodiscard]] std::optional<ScanProblem> scan_xml(std::string_view bytes, const syntax::Limits& limits, Pieces& pieces);

/// The line, from 1, of a place in a text.
[[nodiscard]] std::uint32_t line_of(std::string_view bytes, std::size_t place);

}  // namespace geminga::rdf

#endif
