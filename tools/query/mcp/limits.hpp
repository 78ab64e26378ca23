// Limits of what a client of the Model Context Protocol may send, and of what it is sent.
#ifndef GEMINGA_QUERY_MCP_LIMITS_HPP
#define GEMINGA_QUERY_MCP_LIMITS_HPP

#include <cstddef>

namespace geminga::query::mcp {

/// Octets of one message without its line end. A longer one is thrown away and answered by an error.
inline constexpr std::size_t max_message_octets = std::size_t{256} * 1024;
/// Messages of one batch.
inline constexpr std::size_t max_batch_messages = 32;
/// Arguments of one call, and octets of all their names and values: a line of GCNP has 64 KiB.
inline constexpr std::size_t max_arguments = 64;
inline constexpr std::size_t max_argument_octets = std::size_t{16} * 1024;
/// Octets of one document. A greater one is replaced by advice to ask for less: an assistant cannot read more.
inline constexpr std::size_t max_document_octets = std::size_t{1024} * 1024;

}  // namespace geminga::query::mcp

#endif
