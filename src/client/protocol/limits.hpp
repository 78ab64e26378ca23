// Limits of channels, and the times that they keep (src/client/CHANNELS.md).
#ifndef GEMINGA_CLIENT_PROTOCOL_LIMITS_HPP
#define GEMINGA_CLIENT_PROTOCOL_LIMITS_HPP

#include <chrono>
#include <cstddef>

namespace geminga::client {

/// Octets of one message over UDP, and over TCP.
inline constexpr std::size_t max_datagram_payload = 65'000;
inline constexpr std::size_t max_stream_payload = 16 * 1024 * 1024;
/// Octets of frames that may wait for one TCP consumer; one message may always wait.
inline constexpr std::size_t max_waiting_for_consumer = 4 * 1024 * 1024;
/// Listeners of one `otm/stream` over UDP.
inline constexpr std::size_t max_listeners = 64;
/// TCP connections of one publisher that have not become a consumer's, and those that have.
inline constexpr std::size_t max_strangers = 16;
inline constexpr std::size_t max_tcp_consumers = 256;

/// The time between two hellos of a listener, and the time without one after which it is forgotten.
inline constexpr std::chrono::seconds hello_interval{1};
inline constexpr std::chrono::seconds listener_patience{3};
/// The time that a connection has to become a consumer's.
inline constexpr std::chrono::seconds stranger_patience{5};
/// The time that a subscriber waits for more of a withdrawn publisher, and the time that a publisher waits at its end
/// for a consumer that takes nothing.
inline constexpr std::chrono::seconds drain_patience{2};
inline constexpr std::chrono::seconds leaving_patience{5};
/// The time between two looks at the interfaces of a multicast group.
inline constexpr std::chrono::seconds interfaces_interval{2};
/// The time that a channel over UDP goes on after the daemons have lost sight of its other end.
inline constexpr std::chrono::seconds orphan_patience{10};
/// The time that a daemon that is back has to confirm a channel.
inline constexpr std::chrono::seconds settle_patience{10};

/// Lives of which a subscriber remembers the last sequence.
inline constexpr std::size_t max_remembered_lives = 1024;

/// Early frames of one subscriber, the octets of their payloads, and the time that each is kept.
inline constexpr std::size_t max_early_frames = 64;
inline constexpr std::size_t max_early_octets = 256 * 1024;
inline constexpr std::chrono::seconds early_patience{1};

/// Messages of one subscriber that wait to be taken, and the octets of their payloads; one may always wait. At either
/// limit connections are not read, and of datagrams the eldest is lost.
inline constexpr std::size_t max_waiting_messages = 1024;
inline constexpr std::size_t max_waiting_octets = 16 * 1024 * 1024;
/// Events that wait to be taken; for one more the eldest is thrown away.
inline constexpr std::size_t max_waiting_events = 4096;

}  // namespace geminga::client

#endif
