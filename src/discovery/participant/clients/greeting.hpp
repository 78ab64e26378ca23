// The answer to `sys hello`: who this participant is, and what it grants the peer.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_GREETING_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_GREETING_HPP

#include "discovery/gcnp/request.hpp"
#include "discovery/gcnp/statement.hpp"
#include "discovery/matching/editions.hpp"
#include "discovery/participant/clients/key_telling.hpp"
#include "discovery/participant/clients/session.hpp"
#include "discovery/participant/knowledge/self.hpp"

namespace geminga::participant {

class Greeting {
 public:
  /// Borrows all for its life.
  Greeting(const Self& self, const matching::Editions& editions, KeyTelling& keys)
      : self_(self), editions_(editions), keys_(keys) {}

  /// Requires that the session has the name and the room that the hello asks for. Notes whether it asks for keys.
  [[nodiscard]] gcnp::Statement answer(Session& session, const gcnp::Hello& hello);

 private:
  const Self& self_;
  const matching::Editions& editions_;
  KeyTelling& keys_;
};

}  // namespace geminga::participant

#endif
