// Messages, and the events by which a program is told about its channels (src/client/CHANNELS.md).
#ifndef GEMINGA_CHANNEL_HPP
#define GEMINGA_CHANNEL_HPP

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "geminga/client.hpp"
#include "geminga/event.hpp"
#include "geminga/life.hpp"

namespace geminga {

/// Names a publisher or subscriber of one node. 0 is none.
using ChannelNumber = std::uint32_t;

/// One message as a subscriber receives it.
struct Message {
  Life life = no_life;         ///< of the publisher
  std::uint64_t sequence = 0;  ///< 1, 2, 3, ... of that life; 0 from a publisher without a life
  std::uint64_t missed = 0;    ///< messages of this life that did not come between the one before and this one
  std::vector<std::byte> payload;
};

/// Turns the payload of one representation into that of another. If it throws, the message is dropped.
using Conversion = std::function<std::vector<std::byte>(std::span<const std::byte>)>;
/// Conversions by `A>B`, with the names that events use.
using Conversions = std::map<std::string, Conversion, std::less<>>;

/// The reason why a message could not be sent.
struct SendError {
  enum class Kind : std::uint8_t {
    too_large,  ///< over the limit of the protocol; `text` says what to do
    closed,     ///< the publisher was withdrawn or refused
  };
  Kind kind = Kind::closed;
  std::string text;
};

/// Counts of a publisher.
struct SendCount {
  std::uint64_t sent = 0;      ///< messages that the program sent while there was a consumer
  std::uint64_t left_out = 0;  ///< copies that were left out for a consumer that does not keep up
  std::uint64_t dropped = 0;   ///< frames and connections from others that were not believed
};

/// Counts of a subscriber.
struct ReceiveCount {
  std::uint64_t received = 0;  ///< messages that were taken or wait to be taken
  std::uint64_t missed = 0;    ///< messages that did not come between them, or were lost in a full inbox
  std::uint64_t dropped = 0;   ///< datagrams and frames that were not believed or could not be converted
};

/// The daemon was reached.
struct Connected {
  Welcome welcome;
};
/// The daemon is gone. The node looks for it again, and channels go on meanwhile.
struct Disconnected {
  std::string reason;
};
/// The daemon has accepted the request of a channel, for the first time or after a change.
struct Accepted {
  ChannelNumber channel = 0;
};
/// The daemon has refused a request or a change. A channel that was never accepted does nothing more; a refused change
/// changes nothing.
struct Refused {
  ChannelNumber channel = 0;
  Error error;
};
/// A provider of a subscriber was added, was modified or is gone. A channel that goes on while daemons lose sight of
/// each other causes no event.
struct ProviderChange {
  enum class What : std::uint8_t { added, modified, removed };
  ChannelNumber channel = 0;
  What what = What::added;
  Life life = no_life;
  ServiceEvent service;  ///< as the daemon told of it last
  std::string reason;    ///< of removed
};
/// A consumer of a publisher was added, was modified or is gone. Publishers of streams are not told of consumers.
struct ConsumerChange {
  using What = ProviderChange::What;
  ChannelNumber channel = 0;
  What what = What::added;
  Life life = no_life;
  ConsumerEvent consumer;
  std::string reason;
};
/// Something that a person should know: a conversion without a function, a request that the daemon took back, a
/// provider to which no channel can be made. Channel 0 is the node.
struct Problem {
  ChannelNumber channel = 0;
  std::string text;
};

using ChannelEvent = std::variant<Connected, Disconnected, Accepted, Refused, ProviderChange, ConsumerChange, Problem>;

/// "added", "modified" or "removed". Static storage.
[[nodiscard]] std::string_view to_string(ProviderChange::What what);

}  // namespace geminga

#endif
