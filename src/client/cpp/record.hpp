// One line of an answer as a record.
#ifndef GEMINGA_CLIENT_CPP_RECORD_HPP
#define GEMINGA_CLIENT_CPP_RECORD_HPP

#include "discovery/gcnp/statement.hpp"
#include "geminga/client.hpp"

namespace geminga::client {

/// The record of a line `N msg KIND key=value...`: attributes of a service or request apart from its fields.
[[nodiscard]] Record record_of(const gcnp::Statement& message);

}  // namespace geminga::client

#endif
