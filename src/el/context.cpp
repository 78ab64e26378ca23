// The blocks of the store: memory is touched only where a context is.
#include "el/context.hpp"

#include <new>

namespace geminga::el {
namespace {

constexpr std::align_val_t alignment{alignof(Context)};

}  // namespace

ContextStore::~ContextStore() {
  for (std::size_t number = 0; number < size(); ++number) at(number)->~Context();
  for (const auto& block : blocks_) ::operator delete(block.load(), alignment);
}

std::uint32_t ContextStore::add() {
  const std::uint32_t number = count_.fetch_add(1, std::memory_order_relaxed);
  const std::size_t block = block_of(number);
  Context* known = blocks_[block].load(std::memory_order_acquire);
  if (known == nullptr) {
    void* fresh = ::operator new((first_block << block) * sizeof(Context), alignment);
    // Of two threads that come here at once, one gives its memory back.
    if (!blocks_[block].compare_exchange_strong(known, static_cast<Context*>(fresh), std::memory_order_acq_rel)) {
      ::operator delete(fresh, alignment);
    }
  }
  ::new (at(number)) Context();
  return number;
}

}  // namespace geminga::el
