// The memory of contexts: blocks from the arena of the thread that asks, which go all at once.
//
// A closure makes many small vectors that grow. Each worker has an arena of its own, so that a block is taken without a
// lock; it may be used, grown and given back by another worker, as all arenas of a saturation live as long as its
// contexts. On SOMA this took a sixth from the instructions of a closure.
#ifndef GEMINGA_REASONING_DL_CONSEQUENCE_POOL_HPP
#define GEMINGA_REASONING_DL_CONSEQUENCE_POOL_HPP

#include <cstddef>
#include <utility>
#include <vector>

#include "base/arena.hpp"

namespace geminga::consequence {

/// Makes an arena that of this thread, as long as it lives.
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

/// Takes from the arena of the thread, which there must be. What is given back where there is none stays where it is:
/// its arena goes soon.
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
