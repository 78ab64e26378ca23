// The exit statuses of commands that talk to a daemon.
#ifndef GEMINGA_ONTOLOGY_COMMAND_CLIENT_EXIT_HPP
#define GEMINGA_ONTOLOGY_COMMAND_CLIENT_EXIT_HPP

#include "geminga/client.hpp"
#include "ontology/command/exit_status.hpp"

namespace geminga::ontology {

/// The exit status for an error of the client: what the daemon refuses is wrong usage, unless it is not ready.
[[nodiscard]] inline Exit exit_of_client(const ClientError& error) {
  switch (error.kind) {
    case ClientError::Kind::unreachable:
    case ClientError::Kind::closed:
      return Exit::unreachable;
    case ClientError::Kind::timed_out:
      return Exit::timed_out;
    case ClientError::Kind::refused:
      return error.code == ErrorCode::not_ready ? Exit::unreachable : Exit::usage;
    case ClientError::Kind::wrong_use:
      break;
  }
  return Exit::usage;
}

}  // namespace geminga::ontology

#endif
