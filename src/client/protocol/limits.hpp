// Limits of channels, and the times that they keep (src/client/CHANNELS.md).
#ifndef GEMINGA_CLIENT_PROTOCOL_LIMITS_HPP
#define GEMINGA_CLIENT_PROTOCOL_LIMITS_HPP

#include <chrono>
#include <cstddef>
#include <cstdint>

namespace geminga::client {

/// Octets of one message over UDP, and over TCP.
inline constexpr std::size_t max_datagram_payload = 65'000;
inline constexpr std::size_t max_stream_payload = 16 * 1024 * 1024;
/// Octets of frames that may wait for one TCP consumer; one message may always wait.
inline constexpr std::size_t max_waiting_for_consumer = 4 * 1024 * 1024;
/// Frames that may wait for one TCP consumer, since each costs more than its octets where they are few.
inline constexpr std::size_t max_frames_for_consumer = 16'384;
/// Octets of frames that may wait for all TCP consumers of one publisher, each frame counted once.
inline constexpr std::size_t max_waiting_for_consumers = 64 * 1024 * 1024;
/// Listeners of one `otm/stream` over UDP.
inline constexpr std::size_t max_listeners = 1024;
/// TCP connections of one publisher that have not become a consumer's, and those that have.
inline constexpr std::size_t max_strangers = 64;
inline constexpr std::size_t max_tcp_consumers = 256;
/// Providers over TCP of one subscriber.
inline constexpr std::size_t max_tcp_providers = 256;
/// Floors and fulls with which one publisher answers datagrams: at once, and in a second.
inline constexpr std::size_t max_answers = 512;

/// Lives of which a subscriber knows keys before it is told of their provider.
inline constexpr std::size_t max_waiting_keys = 1024;

/// Without a key: the largest step of a sequence, the silence after which another one is believed, and the runs of
/// delivered sequences of one life that are remembered.
inline constexpr std::uint64_t max_sequence_step = 65'536;
inline constexpr std::chrono::seconds sequence_silence{2};
inline constexpr std::size_t max_delivered_ranges = 256;
/// The time within which the daemon has to confirm an end that anybody could have forged.
inline constexpr std::chrono::seconds end_patience{10};
/// The time after which a consumer connects again to a provider that has ended but is still matched.
inline constexpr std::chrono::seconds again_patience{10};

/// The first and the longest wait for an answer to a hello before it has been accepted, except that from then on it is
/// said again each second.
inline constexpr std::chrono::milliseconds first_hello_wait{20};
inline constexpr std::chrono::milliseconds last_hello_wait{640};
/// The time in which a publisher makes the same cookies.
inline constexpr std::chrono::seconds cookie_interval{8};

/// The time between two hellos of a listener, and the time without one after which it is forgotten.
inline constexpr std::chrono::seconds hello_interval{1};
inline constexpr std::chrono::seconds listener_patience{3};
/// The time that a connection has to become a consumer's; and a provider's place, to become a connection.
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
