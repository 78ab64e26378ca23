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
#include "env/route_kind.hpp"

namespace geminga::env {

/// The largest datagram that is sent or received. With its headers it fills one frame of every link that IPv6 runs on
/// (RFC 8200 section 5: 1280 octets).
inline constexpr std::size_t max_datagram_bytes = 1232;
/// The octets that sealing may add. An announcement leaves them free, sealed or not.
inline constexpr std::size_t max_envelope_bytes = 32;

/// The number of a network interface: the kernel's, except on the IPv6 side of a dual-stack interface. Never reused
/// while a participant lives.
enum class InterfaceIndex : std::uint32_t {};

/// A network interface that announcements go out on.
struct Interface {
  InterfaceIndex index{};
  std::string name;
  /// Numeric addresses that are valid there, IPv4 before IPv6, without scope. May be empty while the interface comes
  /// up.
  std::vector<std::string> addresses;
  /// Numeric addresses that others are told of instead, as behind a translation of addresses; empty: those above.
  std::vector<std::string> announced{};
  bool is_loopback = false;
  /// Set on the IPv6 side of a dual-stack interface: the number of its IPv4 side. What is said on the IPv4 side is said
  /// here only as far as somebody needs it.
  std::optional<InterfaceIndex> ipv6_side_of{};
  /// The way to one host alone that is named by --peer, as a link of its own; only where the participant is a relay.
  /// Elsewhere such a host gets copies of what is multicast on an interface.
  bool is_named_peer = false;
  friend bool operator==(const Interface&, const Interface&) = default;
};

/// The name of one connected GCNP client; never reused while a participant lives.
enum class StreamId : std::uint64_t {};

/// The services of the world to a participant. No function blocks, fails or calls back into the participant. Events of
/// the world reach the participant by its on_...() functions, one at a time, on one thread.
class Env {
 public:
  virtual ~Env() = default;

  /// The monotonic time; constant within one event.
  [[nodiscard]] virtual base::Instant now() const = 0;
  /// Sets the participant's one timer: on_timer() comes at `instant` or soon after it. A later call replaces an earlier
  /// one; base::never stops the timer. An instant in the past comes at once, but not within this call.
  virtual void wake_at(base::Instant instant) = 0;
  /// 64 random bits, for identifiers and jitter: unpredictable on a robot, seeded in the simulator.
  [[nodiscard]] virtual std::uint64_t random_bits() = 0;

  /// The interfaces in use, ordered by index. A change is told by on_interfaces_changed().
  [[nodiscard]] virtual const std::vector<Interface>& interfaces() const = 0;
  /// The names of usable interfaces beyond the limit.
  [[nodiscard]] virtual std::vector<std::string> ignored_interfaces() const { return {}; }
  /// The instant at which the last datagram came in on this interface, our own looped-back ones included; before the
  /// first one, the instant at which the interface was opened. Nothing where the system does not tell.
  [[nodiscard]] virtual std::optional<base::Instant> last_heard(InterfaceIndex interface) const {
    (void)interface;
    return std::nullopt;
  }
  /// The route that datagrams and streams to this numeric address would take at this moment. on_routes_changed() tells
  /// when the answer for an address may have changed.
  [[nodiscard]] virtual RouteKind route(std::string_view address) {
    (void)address;
    return RouteKind::unknown;
  }
  /// Multicasts one datagram on one interface. What cannot be sent is lost, like anything on the air.
  virtual void send(InterfaceIndex interface, std::span<const std::byte> datagram) = 0;

  /// Sends one datagram to this address alone, from this interface, to the port of announcements. Does nothing where
  /// the world cannot.
  virtual void send_alone(InterfaceIndex interface, std::string_view address, std::span<const std::byte> datagram) {
    (void)interface, (void)address, (void)datagram;
  }

  /// Whether the datagram of this event came to us alone from a host that is named by --peer.
  [[nodiscard]] virtual bool is_sender_named() const { return false; }
  /// Whether the datagram of this event came to us alone from a host that nobody has named (--peer). All other hosts
  /// hear us anyway.
  [[nodiscard]] virtual bool is_sender_unnamed() const { return false; }
  /// Sends that host copies of what goes out for this long; if `time` is 0, of one datagram that is not much larger
  /// than its own. Does nothing for all other hosts.
  virtual void answer_sender(base::Duration time) { (void)time; }

  /// Queues bytes to a client. The caller bounds what waits by unsent(): a client for which far too much waits is
  /// closed by the world, and on_stream_closed() tells it.
  virtual void write(StreamId stream, std::string_view bytes) = 0;
  /// Octets that were written to a client and are still queued; nothing is sent before the end of an event. After a
  /// result above 0, on_stream_drained() comes when all of them are sent. 0 for a client that is gone.
  [[nodiscard]] virtual std::size_t unsent(StreamId stream) const = 0;
  /// Sets whether more input of a client is wanted, as it is from the start. Input that comes meanwhile waits with the
  /// system, which holds the client back.
  virtual void want(StreamId stream, bool is_wanted) = 0;
  /// Closes a client after its queue has been written; on_stream_closed() is not called for it.
  virtual void close(StreamId stream) = 0;

  /// The log of the daemon.
  [[nodiscard]] virtual base::LogSink& log() = 0;
};

}  // namespace geminga::env

#endif
