// All syntaxes: no NUL, and UTF-8 unless XML says otherwise.
#include "reasoning/syntax/rdf/scan/scan.hpp"

#include <algorithm>
#include <utility>

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

std::expected<Layout, ScanProblem> scan(syntax::Syntax syntax, std::string_view bytes,
                                        const syntax::FileLimits& limits) {
  if (syntax == syntax::Syntax::owl_xml) return scan_owl_xml(bytes, limits);
  if (is_xml(syntax)) return scan_xml(bytes, limits);
  if (!has_triples(syntax)) return Layout{Pieces(limits.piece_bytes)};  // its reader looks for itself
  if (auto problem = scan_text(bytes, true)) return std::unexpected(std::move(*problem));
  return scan_turtle(bytes, syntax == syntax::Syntax::n_triples, limits);
}

}  // namespace geminga::rdf
