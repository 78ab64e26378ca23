// The limits of sealing; src/discovery/sealing/SEALING.md argues them.
#ifndef GEMINGA_DISCOVERY_SEALING_LIMITS_HPP
#define GEMINGA_DISCOVERY_SEALING_LIMITS_HPP

#include <cstddef>
#include <cstdint>

#include "base/time.hpp"
#include "env/env.hpp"

namespace geminga::sealing {

/// Keys that one participant holds: the one in use, and those of a rotation that has not reached every host.
inline constexpr std::size_t max_keys = 8;
/// Octets of a key, and of the file that holds it.
inline constexpr std::size_t key_bytes = 32;
inline constexpr std::size_t max_key_file_bytes = 4096;

/// The octets of the envelope before the text and behind it.
inline constexpr std::size_t header_bytes = 16;
inline constexpr std::size_t tag_bytes = 16;
static_assert(header_bytes + tag_bytes == env::max_envelope_bytes);

/// Shorter announcements are not compressed, nor is one that gets smaller by less than min_saved_bytes.
inline constexpr std::size_t min_compressed_bytes = 96;
inline constexpr std::size_t min_saved_bytes = 8;

/// Sessions that are remembered. When there is no room for one more, the half that was silent for longest is forgotten.
inline constexpr std::size_t max_sessions = 4096;
/// Interfaces on which one session is heard.
inline constexpr std::size_t max_ways = 4;
/// Counters behind the highest one that can still be new.
inline constexpr std::uint32_t window_counters = 64;
/// The longest time for which a datagram may be overtaken by later ones. What comes later was kept back by somebody.
inline constexpr base::Duration overtaken_time = std::chrono::seconds(1);

/// Sessions that one datagram asks for a proof by name. For more it asks everybody.
inline constexpr std::size_t max_asked = 16;
/// Challenges of others that one datagram gives back, and those that wait to be given back.
inline constexpr std::size_t max_echoes = 64;
inline constexpr std::size_t max_waiting_echoes = 256;
/// How often a challenge is given back. At 30 % loss 97 % of those that asked hear one of the copies, and the others
/// ask again.
inline constexpr int echo_copies = 3;
/// The time in which a call to everybody is answered once. A session that is asked by name answers each time.
inline constexpr base::Duration call_spacing = std::chrono::seconds(1);
/// The time for which a beginning session calls everybody: its three claims, its first state and the quick copies of
/// it.
inline constexpr base::Duration calling_time = std::chrono::seconds(1);
/// A session without proof is asked for one until it was silent for so long.
inline constexpr base::Duration asking_time = std::chrono::seconds(1);

/// A participant that was heard sealed within this time is not believed without a seal.
inline constexpr base::Duration sealed_memory = std::chrono::seconds(30);

/// Datagrams of which it is remembered how they were sealed and what became of them.
inline constexpr std::size_t remembered_datagrams = 1000;
/// Source addresses of which it is remembered why a datagram of theirs was rejected.
inline constexpr std::size_t max_sources = 64;
/// The time between two lines of the log about one reason for rejecting.
inline constexpr base::Duration complaint_spacing = std::chrono::minutes(1);

}  // namespace geminga::sealing

#endif
