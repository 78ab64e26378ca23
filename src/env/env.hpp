// The one door between a participant and the world: clock, timer, randomness, datagrams and streams.
#ifndef GEMINGA_ENV_ENV_HPP
#define GEMINGA_ENV_ENV_HPP

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/log.hpp"
#include "base/time.hpp"

namespace geminga::env {

/// The largest datagram, of those sent and of those received. With its headers it fills one frame of every link that
/// IPv6 runs on (RFC 8200 section 5: 1280 octets).
inline constexpr std::size_t max_datagram_bytes = 1232;
/// What sealing may add to a text: an announcement leaves so much of a datagram free, sealed or not.
inline constexpr std::size_t max_envelope_bytes = 32;

/// The number of a network interface, the kernel's but for twins; never reused while a participant lives.
enum class InterfaceIndex : std::uint32_t {};

/// A network interface that announcements go out on.
struct Interface {
  InterfaceIndex index{};
  std::string name;
  /// Numeric addresses that are valid there, IPv4 before IPv6, without scope. May be empty while it comes up.
  std::vector<std::string> addresses;
  bool is_loopback = false;
  /// Where this is the IPv6 side of an interface that speaks IPv4, too (its *twin*): that one. What is said there is
  /// said here only as far as somebody needs it.
  std::optional<InterfaceIndex> twin_of{};
  friend bool operator==(const Interface&, const Interface&) = default;
};

/// Names one connected GCNP client; never reused while a participant lives.
enum class StreamId : std::uint64_t {};

/// What a participant may ask of the world. None of these blocks, fails or calls back into the participant: what
/// happens in the world reaches the participant by its on_...() functions, one event at a time, on one thread.
class Env {
 public:
  virtual ~Env() = default;

  /// Monotonic now; constant within one event.
  [[nodiscard]] virtual base::Instant now() const = 0;
  /// The participant's one timer: on_timer() comes at `instant` or soon after it. A later call replaces an earlier one;
  /// base::never stops it. An instant in the past comes at once, but not within this call.
  virtual void wake_at(base::Instant instant) = 0;
  /// 64 unpredictable bits on a robot, seeded ones in the simulator. For identifiers and jitter.
  [[nodiscard]] virtual std::uint64_t random_bits() = 0;

  /// The interfaces in use, ordered by index. A change is told by on_interfaces_changed().
  [[nodiscard]] virtual const std::vector<Interface>& interfaces() const = 0;
  /// Multicasts one datagram on one interface. What cannot be sent is lost, like anything on the air.
  virtual void send(InterfaceIndex interface, std::span<const std::byte> datagram) = 0;

  /// Within the event of a datagram: whether it came to us alone from somebody whom nobody has named (--peer). All
  /// others hear us anyway.
  [[nodiscard]] virtual bool is_sender_unnamed() const { return false; }
  /// Then: he is sent copies of what goes out for this long, or, where that is 0, of one datagram which is not much
  /// larger than his. For all others it does nothing.
  virtual void answer_sender(base::Duration time) { (void)time; }

  /// Queues bytes to a client. Who writes looks at unsent(): a client for which far too much waits is closed by the
  /// world, and on_stream_closed() says so.
  virtual void write(StreamId stream, std::string_view bytes) = 0;
  /// Octets that were written to a client and have not gone on their way: nothing goes before the end of an event.
  /// Wherever this gave more than 0, on_stream_drained() comes when all of them have gone. 0 for a client that is gone.
  [[nodiscard]] virtual std::size_t unsent(StreamId stream) const = 0;
  /// Whether more of what a client says is wanted, as it is from the start. What it says meanwhile waits with the
  /// system, which holds the client back.
  virtual void want(StreamId stream, bool is_wanted) = 0;
  /// Closes a client after what is queued has been written; on_stream_closed() is not called for it.
  virtual void close(StreamId stream) = 0;

  /// Where the daemon's own words go.
  [[nodiscard]] virtual base::LogSink& log() = 0;
};

}  // namespace geminga::env

#endif
