// One conversation of the Model Context Protocol (modelcontextprotocol.io/specification/2025-11-25) with a client such
// as an assistant: JSON-RPC 2.0, one message a line.
#ifndef GEMINGA_QUERY_MCP_CONVERSATION_HPP
#define GEMINGA_QUERY_MCP_CONVERSATION_HPP

#include <boost/json/object.hpp>
#include <boost/json/value.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "query/mcp/messages.hpp"
#include "query/mcp/tools.hpp"

namespace geminga::query::mcp {

/// Answers initialization, pings, the list of tools and calls of them. Whatever comes, the conversation goes on, and
/// what cannot be answered gets an error of JSON-RPC. Not thread-safe.
class Conversation {
 public:
  /// `ask` is called within answer(), and once at most for each call of a tool.
  Conversation(Ask ask, std::string program_version)
      : ask_(std::move(ask)), program_version_(std::move(program_version)) {}

  /// The answer to a line, with its line end; empty where it has none: a notification, an answer, an empty line.
  [[nodiscard]] std::string answer(const Line& line);

 private:
  std::optional<boost::json::value> answer_to(const boost::json::value& message);
  std::optional<boost::json::value> answer_to_batch(const boost::json::array& batch);
  boost::json::object answer_to_request(const boost::json::value& id, std::string_view method,
                                        const boost::json::object& parameters);
  boost::json::object initialize(const boost::json::object& parameters);

  Ask ask_;
  std::string program_version_;
  std::string_view protocol_;  ///< the version that was agreed on; empty before
};

}  // namespace geminga::query::mcp

#endif
