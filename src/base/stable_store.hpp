// Numbered things that never move, added and read by many threads at once.
#ifndef GEMINGA_BASE_STABLE_STORE_HPP
#define GEMINGA_BASE_STABLE_STORE_HPP

#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <new>
#include <type_traits>

namespace geminga::base {

/// Stores things in blocks of growing size, so memory is touched only where a thing is.
template <typename Thing>
class StableStore {
  static_assert(std::is_nothrow_default_constructible_v<Thing>);

 public:
  StableStore() = default;
  StableStore(const StableStore&) = delete;
  StableStore& operator=(const StableStore&) = delete;
  ~StableStore() {
    for (std::size_t number = 0; number < size(); ++number) at(number)->~Thing();
    for (const auto& block : blocks_) ::operator delete(block.load(), alignment);
  }

  /// Adds a thing and returns its number. The caller is alone with it until it tells other threads.
  std::uint32_t add() {
    // The block is there before the number is taken: if memory runs out, no number is without its thing.
    std::uint32_t number = count_.load(std::memory_order_relaxed);
    do {
      need_block(block_of(number));
    } while (!count_.compare_exchange_weak(number, number + 1, std::memory_order_relaxed));
    ::new (at(number)) Thing();
    return number;
  }
  [[nodiscard]] std::size_t size() const { return count_.load(std::memory_order_relaxed); }
  [[nodiscard]] Thing& operator[](std::size_t number) { return *at(number); }
  [[nodiscard]] const Thing& operator[](std::size_t number) const { return *at(number); }

  class Iterator {
   public:
    using value_type = Thing;
    using difference_type = std::ptrdiff_t;
    Iterator() = default;
    Iterator(const StableStore* store, std::size_t number) : store_(store), number_(number) {}
    const Thing& operator*() const { return (*store_)[number_]; }
    Iterator& operator++() {
      ++number_;
      return *this;
    }
    Iterator operator++(int) { return {store_, number_++}; }
    friend bool operator==(const Iterator&, const Iterator&) = default;

   private:
    const StableStore* store_ = nullptr;
    std::size_t number_ = 0;
  };
  [[nodiscard]] Iterator begin() const { return {this, 0}; }
  [[nodiscard]] Iterator end() const { return {this, size()}; }

 private:
  static constexpr std::align_val_t alignment{alignof(Thing)};
  // Block b holds first_block << b things: as many as all blocks before it, and first_block more.
  static constexpr std::size_t first_block = 64;
  static constexpr std::size_t first_block_bits = 6;
  [[nodiscard]] static std::size_t block_of(std::size_t number) {
    return static_cast<std::size_t>(std::bit_width((number >> first_block_bits) + 1)) - 1;
  }
  void need_block(std::size_t block) {
    Thing* known = blocks_[block].load(std::memory_order_acquire);
    if (known != nullptr) return;
    void* fresh = ::operator new((first_block << block) * sizeof(Thing), alignment);
    // Of two threads that come here at once, one gives its memory back.
    if (!blocks_[block].compare_exchange_strong(known, static_cast<Thing*>(fresh), std::memory_order_acq_rel)) {
      ::operator delete(fresh, alignment);
    }
  }
  [[nodiscard]] Thing* at(std::size_t number) const {
    const std::size_t block = block_of(number);
    return blocks_[block].load(std::memory_order_acquire) + (number + first_block - (first_block << block));
  }

  std::array<std::atomic<Thing*>, 27> blocks_{};
  std::atomic<std::uint32_t> count_ = 0;
};

}  // namespace geminga::base

#endif
