#include "sim/connections.hpp"

#include <utility>

#include "sim/client.hpp"
#include "sim/host.hpp"

namespace geminga::sim {

void Connections::open(env::StreamId stream, Client& client) { streams_.emplace(stream, Stream{.client = &client}); }

void Connections::drop() {
  for (const auto& [stream, one] : std::exchange(streams_, {})) one.client->connection_lost();
}

void Connections::resume() {
  for (const auto& [stream, one] : streams_) soon([this, id = stream] { hear(id); });
}

void Connections::soon(std::function<void()> what) {
  host_.world().after(base::Duration(0), [&host = host_, what = std::move(what), incarnation = host_.incarnation()] {
    if (incarnation == host.incarnation()) what();
  });
}

void Connections::from_client(env::StreamId stream, std::string bytes) {
  soon([this, stream, bytes = std::move(bytes)] {
    const auto found = streams_.find(stream);
    if (found == streams_.end()) return;
    found->second.unheard += bytes;
    hear(stream);
  });
}

void Connections::client_closed(env::StreamId stream) {
  soon([this, stream] {
    const auto found = streams_.find(stream);
    if (found == streams_.end()) return;
    found->second.has_hung_up = true;
    hear(stream);
  });
}

/// As a socket is read: in pieces, while the participant wants more, and the end last.
void Connections::hear(env::StreamId stream) {
  constexpr std::size_t piece = std::size_t{16} * 1024;
  const auto found = streams_.find(stream);
  if (found == streams_.end() || !found->second.is_wanted || host_.pause() != Host::Pause::none) return;
  Stream& one = found->second;
  if (!one.unheard.empty()) {
    const std::string bytes = one.unheard.substr(0, piece);
    one.unheard.erase(0, piece);
    host_.event([&](participant::Participant& participant) {
      participant.on_stream_bytes(stream, bytes);
      soon([this, stream] { hear(stream); });
    });
  } else if (one.has_hung_up) {
    streams_.erase(found);
    host_.event([&](participant::Participant& participant) { participant.on_stream_closed(stream); });
  }
}

void Connections::set_reading(env::StreamId stream, bool is_reading) {
  const auto found = streams_.find(stream);
  if (found == streams_.end()) return;
  found->second.is_reading = is_reading;
  flush();
}

void Connections::read(env::StreamId stream, std::size_t octets) {
  const auto found = streams_.find(stream);
  if (found == streams_.end()) return;
  std::string& unsent = found->second.unsent;
  give(stream, unsent.substr(0, octets));
  unsent.erase(0, octets);
}

/// As the real one does: what was written goes at the end of the event, and who has heard that it waits is told so.
void Connections::flush() {
  for (auto& [stream, one] : streams_) {
    if (!one.is_reading || one.unsent.empty()) continue;
    give(stream, std::exchange(one.unsent, {}));
    if (!std::exchange(one.is_behind, false)) continue;
    soon([this, id = stream] {
      if (!streams_.contains(id)) return;
      host_.event([id](participant::Participant& participant) { participant.on_stream_drained(id); });
    });
  }
}

void Connections::write(env::StreamId stream, std::string_view bytes) {
  const auto found = streams_.find(stream);
  if (found == streams_.end()) return;
  host_.world().trace(host_.name(), bytes);
  found->second.unsent += bytes;
}

/// Through the queue, so that what a client does about a line is an event of its own.
void Connections::give(env::StreamId stream, std::string bytes) {
  host_.world().after(base::Duration(0), [client = streams_.at(stream).client, stream, text = std::move(bytes)] {
    client->receive(stream, text);
  });
}

std::size_t Connections::unsent(env::StreamId stream) const {
  const auto found = streams_.find(stream);
  if (found == streams_.end()) return 0;
  if (!found->second.unsent.empty()) found->second.is_behind = true;
  return found->second.unsent.size();
}

void Connections::want(env::StreamId stream, bool is_wanted) {
  const auto found = streams_.find(stream);
  if (found == streams_.end()) return;
  found->second.is_wanted = is_wanted;
  soon([this, stream] { hear(stream); });
}

void Connections::close(env::StreamId stream) {
  const auto found = streams_.find(stream);
  if (found == streams_.end()) return;
  if (!found->second.unsent.empty()) give(stream, std::exchange(found->second.unsent, {}));
  host_.world().after(base::Duration(0), [client = found->second.client, stream] { client->closed_by_host(stream); });
  streams_.erase(found);
}

}  // namespace geminga::sim
