// The memory of contexts: blocks from the arena of the thread that asks. They are freed all at once.
//
// A closure makes many small vectors that grow. Each worker has an arena of its own, so that a block is taken without a
// lock. Another worker may use, grow and give back the block, because all arenas of a saturation live as long as its
// contexts.
#ifndef GEMINGA_REASONING_DL_CONSEQUENCE_POOL_HPP
#define GEMINGA_REASONING_DL_CONSEQUENCE_POOL_HPP

#include <cstddef>
#include <utility>
#include <vector>

#include "base/arena.hpp"

namespace geminga::consequence {

/// Makes an arena the one of this thread for the object's life.
class ArenaUse {
 public:
  explicit ArenaUse(base::Arena& arena) : before_(std::exchange(current(), &arena)) {}
  ArenaUse(const ArenaUse&) = delete;
  ArenaUse& operator=(const ArenaUse&) = delete;
  ~ArenaUse() { current() = before_; }

  [[nodiscard]] static base::Arena*& current() {
    static thread_local base::Arena* arena = nullptr;
    return arena;
  }

 private:
  base::Arena* before_;
};

/// Takes memory from the thread's arena, which must be set. Memory that is given back without one is left to its arena,
/// which is freed soon.
template <typename Item>
struct PoolAllocator {
  using value_type = Item;
  PoolAllocator() = default;
  template <typename Other>
  PoolAllocator(const PoolAllocator<Other>& /*other*/) {}

  [[nodiscard]] Item* allocate(std::size_t count) {
    return static_cast<Item*>(ArenaUse::current()->allocate(count * sizeof(Item)));
  }
  void deallocate(Item* block, std::size_t count) {
    if (base::Arena* const arena = ArenaUse::current(); arena != nullptr)
      arena->release(static_cast<void*>(block), count * sizeof(Item));
  }
  friend bool operator==(const PoolAllocator&, const PoolAllocator&) { return true; }
};

template <typename Item>
using Pooled = std::vector<Item, PoolAllocator<Item>>;

}  // namespace geminga::consequence

#endif
