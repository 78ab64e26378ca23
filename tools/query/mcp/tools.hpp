// The daemon's questions as tools of the Model Context Protocol.
#ifndef GEMINGA_QUERY_MCP_TOOLS_HPP
#define GEMINGA_QUERY_MCP_TOOLS_HPP

#include <boost/json/array.hpp>
#include <boost/json/object.hpp>
#include <expected>
#include <functional>
#include <string>

#include "answers/questions.hpp"
#include "geminga/client.hpp"

namespace geminga::query::mcp {

/// Asks the daemon `query KIND key=value...`.
using Ask = std::function<Result<Answer, ClientError>(const std::string& kind, const answers::Parameters& parameters)>;

/// One tool for each kind of question, with the JSON schema of its arguments (2025-11-25, server/tools).
[[nodiscard]] boost::json::array tools();

/// The result of a call: the document of geminga-query --json as text. An answer that there is none, arguments
/// that cannot be used and a document over max_document_octets are results with `isError`, so that an assistant can
/// mend its question.
[[nodiscard]] boost::json::object call(const answers::Kind& kind, const boost::json::object& arguments, const Ask& ask);

}  // namespace geminga::query::mcp

#endif
