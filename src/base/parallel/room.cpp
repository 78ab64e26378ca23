#include "base/parallel/room.hpp"

#include <sys/mman.h>

namespace geminga::parallel {

bool has_room_for(std::size_t threads) {
  constexpr std::size_t a_thread = std::size_t{256} << 20;
  void* room = mmap(nullptr, threads * a_thread, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (room == MAP_FAILED) return false;
  munmap(room, threads * a_thread);
  return true;
}

}  // namespace geminga::parallel
