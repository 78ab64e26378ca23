// Memory that the daemon keeps back, so that it can go on when there is no other left.
#ifndef GEMINGA_DAEMON_MEMORY_MEMORY_RESERVE_HPP
#define GEMINGA_DAEMON_MEMORY_MEMORY_RESERVE_HPP

#include <cstddef>

namespace geminga::daemon {

/// The octets that are kept back, in pieces which any later allocation can use. More than one event allocates: a turn
/// is a bounded amount of work, and a client's octets are bounded.
inline constexpr std::size_t reserved_bytes = std::size_t{4} * 1024 * 1024;
inline constexpr std::size_t reserve_piece_bytes = std::size_t{64} * 1024;
/// The reserve is whole enough for another shortage when it has so much.
inline constexpr std::size_t least_reserved_bytes = reserved_bytes / 2;

/// Gives the reserve back to the allocator when operator new finds no memory (std::set_new_handler): the event under
/// way ends as if there had been enough, so nothing is left half done and nobody has to catch std::bad_alloc. After the
/// event its owner makes room, and takes the reserve anew. Only where one event needs more than the reserve has,
/// std::bad_alloc is thrown. One object a process.
class MemoryReserve {
 public:
  MemoryReserve();
  ~MemoryReserve();
  MemoryReserve(const MemoryReserve&) = delete;
  MemoryReserve& operator=(const MemoryReserve&) = delete;

  /// Whether memory was short since the last call.
  [[nodiscard]] static bool take_shortage();
  /// Takes what is missing of the reserve. Whether it has least_reserved_bytes.
  bool refill();
  /// The octets that are kept back at present.
  [[nodiscard]] static std::size_t size();
};

}  // namespace geminga::daemon

#endif
