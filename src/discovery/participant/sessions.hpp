// How clients come, how their bytes come in and go out, and how they go.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_SESSIONS_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_SESSIONS_HPP

#include <optional>
#include <string_view>

#include "discovery/participant/core.hpp"

namespace geminga::participant {

/// A client has connected. Where there is room for no more, a silent one gives way, or the new one is closed.
void open_session(Core& core, env::StreamId stream, std::string_view user);
/// Bytes of a client: they are kept for its turn. One that does not begin as GCNP does is closed.
void hear_session(Core& core, env::StreamId stream, std::string_view bytes);
/// The client is gone.
void lose_session(Core& core, env::StreamId stream);

/// Closes those that are to be closed, and those that lag and have read nothing for too long.
void close_due_sessions(Core& core);
/// Hands to Env what the peers are told, and asks it to go on reading those that nothing waits of.
void write_sessions(Core& core);
/// Closes all with this error, if there is one.
void close_all_sessions(Core& core, const std::optional<Error>& error);
/// When the next one is to be closed because it reads nothing.
[[nodiscard]] base::Instant session_deadline(const Core& core);

}  // namespace geminga::participant

#endif
