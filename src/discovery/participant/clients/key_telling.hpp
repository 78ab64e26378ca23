// Key telling: the keys of channels, to the sessions that asked for them (src/client/CHANNELS.md, "Sealed channels").
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_KEY_TELLING_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_KEY_TELLING_HPP

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>

#include "discovery/gcnp/channel_keyring.hpp"
#include "discovery/participant/clients/sessions.hpp"
#include "discovery/participant/knowledge/work.hpp"
#include "geminga/life.hpp"
#include "geminga/service.hpp"

namespace geminga::participant {

/// Gives the keys of the channel with this life. The ring is empty while this participant has no key.
using KeysOf = std::function<gcnp::ChannelKeyring(Life)>;

/// Writes the keys of a channel into the session that owns the statement, and nowhere else.
class KeyTelling {
 public:
  /// Borrows sessions and work for its life.
  KeyTelling(KeysOf keys_of, Sessions& sessions, WorkMeter& work)
      : keys_of_(std::move(keys_of)), sessions_(sessions), work_(work) {}

  /// Notes whether the session asks for keys. Requests that it has already are told of anew. True: there are keys.
  bool ask(Session& session, bool asks);
  /// Tells the keys of the channel that a service states, if the session asked for keys and has not been told them.
  /// `request` is the publication itself, or the subscription that is about to be told of it.
  void tell(Session& session, std::uint32_t request, const Attributes& attributes);
  /// The word of the mode in which this host seals.
  [[nodiscard]] std::string mode() const { return keys_of_(no_life).mode; }
  /// Has the mode told at once and all keys anew, in the turns of the sessions: the keys or the mode have changed.
  void change();

 private:
  static void begin_anew(Session& session);

  KeysOf keys_of_;
  Sessions& sessions_;
  WorkMeter& work_;
};

}  // namespace geminga::participant

#endif
