// All syntaxes: no NUL, and UTF-8 unless XML says otherwise.
#include "reasoning/syntax/rdf/scan/scan.hpp"

#include <algorithm>
#include <utility>

#include "base/utf8.hpp"

namespace geminga::rdf {

std::uint32_t line_of(std::string_view bytes, std::size_t place) {
  // Counted in blocks of a fixed size, a sum in one octet each: the compiler makes vectors of them.
  constexpr std::size_t block = 128;
  std::string_view before = bytes.substr(0, place);
  std::size_t lines = 1;
  for (; before.size() >= block; before.remove_prefix(block)) {
    std::uint8_t ends = 0;
    for (std::size_t at = 0; at < block; ++at) ends = static_cast<std::uint8_t>(ends + (before[at] == '\n' ? 1 : 0));
    lines += ends;
  }
  return static_cast<std::uint32_t>(lines + static_cast<std::size_t>(std::ranges::count(before, '\n')));
}

std::optional<ScanProblem> scan_text(std::string_view bytes, bool is_utf8) {
  if (const std::size_t nul = bytes.find('\0'); nul != std::string_view::npos)
    return ScanProblem{line_of(bytes, nul), "holds a NUL byte"};
  if (!is_utf8) return std::nullopt;
  if (const auto place = base::find_invalid_utf8(bytes))
    return ScanProblem{line_of(bytes, *place), "holds bytes that are no UTF-8: save it as UTF-8"};
  return std::nullopt;
}

std::expected<Layout, ScanProblem> scan(syntax::Syntax syntax, std::string_view bytes, const syntax::FileLimits& limits,
                                        unsigned threads) {
  if (syntax == syntax::Syntax::owl_xml) return scan_owl_xml(bytes, limits);
  if (is_xml(syntax)) return scan_xml(bytes, limits, threads);
  if (!has_triples(syntax)) return Layout{Pieces(limits.piece_bytes)};  // its reader looks for itself
  if (auto problem = scan_text(bytes, true)) return std::unexpected(std::move(*problem));
  return scan_turtle(bytes, syntax == syntax::Syntax::n_triples, limits);
}

}  // namespace geminga::rdf
