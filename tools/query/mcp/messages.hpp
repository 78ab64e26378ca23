// The lines of the Model Context Protocol's transport over standard input.
#ifndef GEMINGA_QUERY_MCP_MESSAGES_HPP
#define GEMINGA_QUERY_MCP_MESSAGES_HPP

#include <istream>
#include <optional>
#include <string>

namespace geminga::query::mcp {

/// One line, without its end.
struct Line {
  std::string text;
  bool is_cut = false;  ///< it was over max_message_octets, and its rest was thrown away
};

/// The next line, also one that the end of the stream cuts; nothing at the end. Keeps no more than max_message_octets.
[[nodiscard]] std::optional<Line> read_line(std::istream& in);

}  // namespace geminga::query::mcp

#endif
