// How much a channel takes from others (src/client/CHANNELS.md, Frames and Life).
#ifndef GEMINGA_CLIENT_PROTOCOL_LIMITS_HPP
#define GEMINGA_CLIENT_PROTOCOL_LIMITS_HPP

#include <chrono>
#include <cstddef>

namespace geminga::client {

/// The payload of one message in a datagram, and in a frame over TCP.
inline constexpr std::size_t max_datagram_payload = 65'000;
inline constexpr std::size_t max_stream_payload = 16 * 1024 * 1024;
/// What waits for one TCP consumer, in octets of frames; one message may always wait.
inline constexpr std::size_t max_waiting_for_consumer = 4 * 1024 * 1024;
/// Listeners of one `otm/stream` over UDP.
inline constexpr std::size_t max_listeners = 64;
/// TCP connections of one publisher that are nobody's yet, and consumers that are somebody's.
inline constexpr std::size_t max_strangers = 16;
inline constexpr std::size_t max_tcp_consumers = 256;

/// How often a listener says hello, and after how long without one it is forgotten.
inline constexpr std::chrono::seconds hello_interval{1};
inline constexpr std::chrono::seconds listener_patience{3};
/// How long a connection may be nobody's.
inline constexpr std::chrono::seconds stranger_patience{5};
/// How long a consumer waits for more of a withdrawn publisher, and a publisher for a consumer that takes nothing of
/// what waits for it at the end.
inline constexpr std::chrono::seconds drain_patience{2};
inline constexpr std::chrono::seconds leaving_patience{5};
/// How often is looked which interfaces multicasts go through.
inline constexpr std::chrono::seconds interfaces_interval{2};
/// How long a channel over UDP outlives the daemons' sight of its other end.
inline constexpr std::chrono::seconds orphan_patience{10};
/// How long a daemon that came back has to confirm what was there before.
inline constexpr std::chrono::seconds settle_patience{10};

/// Lives of which a subscriber knows what it heard last.
inline constexpr std::size_t max_remembered_lives = 1024;

/// Frames over UDP of one subscriber that are of nobody whom it knows yet, their payload, and how long they are kept.
inline constexpr std::size_t max_early_frames = 64;
inline constexpr std::size_t max_early_octets = 256 * 1024;
inline constexpr std::chrono::seconds early_patience{1};

/// Messages of one subscriber that wait to be taken: beyond either nothing more is read from its sockets, so that the
/// network holds the providers back (TCP) or drops (UDP). One message may always wait.
inline constexpr std::size_t max_waiting_messages = 1024;
inline constexpr std::size_t max_waiting_octets = 16 * 1024 * 1024;
/// Events that wait to be taken: where one more comes, the eldest goes.
inline constexpr std::size_t max_waiting_events = 4096;

}  // namespace geminga::client

#endif
