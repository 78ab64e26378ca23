#include "discovery/participant/clients/session.hpp"

#include <utility>

namespace geminga::participant {

Session::Session(env::StreamId stream, PeerId peer, std::string_view the_user, const ClientLimits& limits)
    : name("peer-" + std::to_string(static_cast<std::uint32_t>(peer))),
      user(the_user),
      gate(limits.statements_per_second, limits.flood_per_second),
      stream_(stream),
      peer_(peer) {}

std::string Session::take_outbox() { return std::exchange(outbox_, {}); }

}  // namespace geminga::participant
