#include "query/mcp/messages.hpp"

#include "query/mcp/limits.hpp"

namespace geminga::query::mcp {

std::optional<Line> read_line(std::istream& in) {
  Line line;
  bool has_octets = false;
  for (char octet = 0; in.get(octet);) {
    if (octet == '\n') return line;
    has_octets = true;
    if (line.text.size() < max_message_octets) {
      line.text += octet;
    } else {
      line.is_cut = true;
    }
  }
  return has_octets ? std::optional(line) : std::nullopt;
}

}  // namespace geminga::query::mcp
