// What every syntax has in common: no NUL, and UTF-8 unless XML says otherwise.
#include "reasoning/syntax/rdf/scan.hpp"

#include <algorithm>
#include <cstring>

#include "base/text.hpp"

namespace geminga::rdf {
namespace {

/// Octets of the UTF-8 character that begins with this byte, or 1 where none does.
std::size_t character_bytes(unsigned char lead) {
  if (lead >= 0xf0) return 4;
  if (lead >= 0xe0) return 3;
  return lead >= 0xc0 ? 2 : 1;
}

}  // namespace

std::uint32_t line_of(std::string_view bytes, std::size_t place) {
  const std::string_view before = bytes.substr(0, place);
  return 1 + static_cast<std::uint32_t>(std::ranges::count(before, '\n'));
}

std::optional<ScanProblem> scan_text(std::string_view bytes, bool is_utf8) {
  if (const std::size_t nul = bytes.find('\0'); nul != std::string_view::npos)
    return ScanProblem{line_of(bytes, nul), "holds a NUL byte"};
  if (!is_utf8) return std::nullopt;
  std::size_t place = 0;
  while (place < bytes.size()) {
    std::uint64_t word = 0;
    if (bytes.size() - place >= sizeof word) {  // eight characters of ASCII at a time
      std::memcpy(&word, bytes.data() + place, sizeof word);
      if ((word & 0x8080808080808080U) == 0) {
        place += sizeof word;
        continue;
      }
    }
    const auto lead = static_cast<unsigned char>(bytes[place]);
    const std::size_t count = lead < 0x80 ? 1 : character_bytes(lead);
    if (lead >= 0x80 && (count == 1 || !base::is_valid_utf8(bytes.substr(place, count))))
      return ScanProblem{line_of(bytes, place), "holds bytes that are no UTF-8: save it as UTF-8"};
    place += count;
  }
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
