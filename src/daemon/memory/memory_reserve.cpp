#include "daemon/memory/memory_reserve.hpp"

#include <atomic>
#include <cstdlib>
#include <new>
#include <utility>

namespace geminga::daemon {
namespace {

struct Piece {
  Piece* next = nullptr;
};

// A new-handler is a function without an object, and may be called on any thread: so the reserve is the process's.
std::atomic<Piece*> pieces = nullptr;  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables): see above
std::atomic<std::size_t> kept = 0;     // NOLINT(cppcoreguidelines-avoid-non-const-global-variables): see above
std::atomic<bool> was_short = false;   // NOLINT(cppcoreguidelines-avoid-non-const-global-variables): see above

/// Gives everything back; false: there was nothing.
bool release() {
  Piece* piece = pieces.exchange(nullptr);
  if (piece == nullptr) return false;
  kept = 0;
  while (piece != nullptr) {
    std::free(std::exchange(piece, piece->next));  // NOLINT(cppcoreguidelines-no-malloc): the allocator itself
  }
  return true;
}

void on_shortage() {
  was_short = true;
  if (!release()) throw std::bad_alloc();
}

}  // namespace

MemoryReserve::MemoryReserve() {
  refill();
  std::set_new_handler(&on_shortage);
}

MemoryReserve::~MemoryReserve() {
  std::set_new_handler(nullptr);
  release();
}

bool MemoryReserve::take_shortage() { return was_short.exchange(false); }

bool MemoryReserve::refill() {
  Piece* taken = pieces.exchange(nullptr);  // another thread may give them back at any time
  std::size_t size = taken == nullptr ? 0 : kept.load();
  while (size < reserved_bytes) {
    void* room = std::malloc(reserve_piece_bytes);  // NOLINT(cppcoreguidelines-no-malloc): null is no error here
    if (room == nullptr) break;
    taken = new (room) Piece{taken};
    size += reserve_piece_bytes;
  }
  kept = size;
  pieces = taken;
  return size >= least_reserved_bytes;
}

std::size_t MemoryReserve::size() { return kept; }

}  // namespace geminga::daemon
