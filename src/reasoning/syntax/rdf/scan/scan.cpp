// What every syntax has in common: no NUL, and UTF-8 unless XML says otherwise.
#include "reasoning/syntax/rdf/scan/scan.hpp"

#include <algorithm>

#include "base/utf8.hpp"

namespace geminga::rdf {
std::uint32_t line_of(std::string_view bytes, std::size_t place) {
  const std::string_view before = bytes.substr(0, place);
  return 1 + static_cast<std::uint32_t>(std::ranges::count(before, '\n'));
}

std::optional<ScanProblem> scan_text(std::string_view bytes, bool is_utf8) {
  if (const std::size_t nul = bytes.find('\0'); nul != std::string_view::npos)
    return ScanProblem{line_of(bytes, nul), "holds a NUL byte"};
  if (!is_utf8) return std::nullopt;
  if (const auto place = base::find_invalid_utf8(bytes))
    return ScanProblem{line_of(bytes, *place), "holds bytes that are no UTF-8: save it as UTF-8"};
  return std::nullopt;
}

std::optional<ScanProblem> scan(syntax::Syntax syntax, std::string_view bytes, const syntax::Limits& limits,
                                TurtleLines& lines, Pieces& pieces) {
  if (is_xml(syntax)) return scan_xml(bytes, limits, pieces);
  if (!has_triples(syntax)) return std::nullopt;  // its reader looks for itself
  if (auto problem = scan_text(bytes, true)) return problem;
  return scan_turtle(bytes, limits, lines, pieces);
}

}  // namespace geminga::rdf
