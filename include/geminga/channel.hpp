// What flows through channels, and what a program is told about them (src/client/CHANNELS.md).
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

namespace geminga {

/// 64 random bits of one publisher or subscriber. They stay the same while its daemon comes and goes, and tell a
/// program that was restarted from the one before.
enum class Life : std::uint64_t {};
/// Of whoever states none.
inline constexpr Life no_life{};
/// Sixteen lower-case hexadecimal digits.
[[nodiscard]] std::string to_string(Life life);

/// Names a publisher or subscriber of one node. 0 is none.
using ChannelNumber = std::uint32_t;

/// One message as a subscriber receives it.
struct Message {
  Life life = no_life;         ///< of the publisher
  std::uint64_t sequence = 0;  ///< 1, 2, 3, ... of that life; 0 from a publisher without a life
  std::uint64_t missed = 0;    ///< messages between the one before and this one that did not come
  std::vector<std::byte> payload;
};

/// Turns the payload of one representation into that of another. What it throws drops the message.
using Conversion = std::function<std::vector<std::byte>(std::span<const std::byte>)>;
/// Conversions by `A>B`, the names as events write them.
using Conversions = std::map<std::string, Conversion, std::less<>>;

/// Why something could not be sent.
struct SendError {
  enum class Kind : std::uint8_t {
    too_large,  ///< over the limit of the protocol; `text` says what to do
    closed,     ///< the publisher was withdrawn or refused
  };
  Kind kind = Kind::closed;
  std::string text;
};

/// What a publisher has sent.
struct SendCount {
  std::uint64_t sent = 0;      ///< messages that it was given while it had a consumer
  std::uint64_t left_out = 0;  ///< copies that a consumer did not get since it does not keep up
  std::uint64_t dropped = 0;   ///< frames and connections from others that were not believed
};

/// What a subscriber has received.
struct ReceiveCount {
  std::uint64_t received = 0;  ///< messages that were delivered, or wait to be taken
  std::uint64_t missed = 0;    ///< that ought to have come between them
  std::uint64_t dropped = 0;   ///< datagrams and frames that were not believed, or could not be converted
};

/// The daemon was reached.
struct Connected {
  Welcome welcome;
};
/// The daemon is gone; it is looked for again, and what flows goes on meanwhile.
struct Disconnected {
  std::string reason;
};
/// The daemon has taken what the channel offers or asks for, for the first time or after a change.
struct Accepted {
  ChannelNumber channel = 0;
};
/// The daemon has refused it, and why. A channel that was never taken does nothing more; a refused change changes
/// nothing.
struct Refused {
  ChannelNumber channel = 0;
  Error error;
};
/// A provider of a subscriber was added, changed or is gone. A channel that goes on while daemons lose sight of each
/// other is not told.
struct ProviderChange {
  enum class What : std::uint8_t { added, modified, removed };
  ChannelNumber channel = 0;
  What what = What::added;
  Life life = no_life;
  ServiceEvent service;  ///< as the daemon told of it last
  std::string reason;    ///< of removed
};
/// The same of a consumer of a publisher; not for streams, whose provider is not told.
struct ConsumerChange {
  using What = ProviderChange::What;
  ChannelNumber channel = 0;
  What what = What::added;
  Life life = no_life;
  ConsumerEvent consumer;
  std::string reason;
};
/// Something that somebody should know: a conversion without a function, a request that the daemon took back, a
/// provider that no channel can be made to.
struct Problem {
  ChannelNumber channel = 0;
  std::string text;
};

using ChannelEvent = std::variant<Connected, Disconnected, Accepted, Refused, ProviderChange, ConsumerChange, Problem>;

/// "added", "modified" or "removed". Static storage.
[[nodiscard]] std::string_view to_string(ProviderChange::What what);

}  // namespace geminga

#endif
