// Lists and sets in the memory of an Arena: sixteen and thirty-two bytes while empty, and nothing to destroy.
#ifndef GEMINGA_BASE_ARENA_CONTAINERS_HPP
#define GEMINGA_BASE_ARENA_CONTAINERS_HPP

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>

#include "base/arena.hpp"
#include "base/growing_set.hpp"

namespace geminga::base {

/// A list of trivially copyable items. Its destructor frees nothing: the arena does.
template <typename T>
class ArenaList {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  using value_type = T;
  void push_back(const T& item, Arena& arena) {
    const T copy = item;  // it may be an item of this list
    if (size_ == capacity_) grow(capacity_ * 2, arena);
    items_[size_++] = copy;
  }
  /// Removes the last item and returns it. Requires one.
  T pop_back() { return items_[--size_]; }
  /// Makes room for so many.
  void reserve(std::uint32_t count, Arena& arena) {
    if (count > capacity_) grow(std::bit_ceil(count), arena);
  }
  void clear(Arena& arena) {
    if (capacity_ != 0) arena.release(items_, capacity_ * sizeof(T));
    items_ = nullptr;
    size_ = capacity_ = 0;
  }
  [[nodiscard]] std::uint32_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] const T& operator[](std::size_t at) const { return items_[at]; }
  [[nodiscard]] const T* data() const { return items_; }
  [[nodiscard]] const T* begin() const { return items_; }
  [[nodiscard]] const T* end() const { return items_ + size_; }
  [[nodiscard]] T* begin() { return items_; }
  [[nodiscard]] T* end() { return items_ + size_; }

 private:
  void grow(std::uint32_t count, Arena& arena) {
    // The first block is a whole one of the arena's smallest size.
    const auto wanted =
        std::max({count, std::uint32_t{1}, static_cast<std::uint32_t>(Arena::min_block_bytes / sizeof(T))});
    T* larger = static_cast<T*>(arena.allocate(wanted * sizeof(T)));
    if (size_ != 0) std::memcpy(static_cast<void*>(larger), items_, size_ * sizeof(T));
    if (capacity_ != 0) arena.release(items_, capacity_ * sizeof(T));
    items_ = larger;
    capacity_ = wanted;
  }

  T* items_ = nullptr;
  std::uint32_t size_ = 0;
  std::uint32_t capacity_ = 0;
};

/// A set that keeps the order of insertion: a list, with a table of the keys when it is long. Keys have `std::uint64_t
/// hash_of_key(Key)`. The key with all bits set is not allowed.
template <typename Key>
class ArenaSet {
 public:
  /// Returns false if the key was in the set. Amortised O(1).
  bool insert(Key key, Arena& arena) {
    if (slots_ == nullptr) {
      if (std::find(items_.begin(), items_.end(), key) != items_.end()) return false;
      items_.push_back(key, arena);
      if (items_.size() > max_scanned) make_table(items_.size(), arena);
      return true;
    }
    const std::size_t slot = find(key);
    if (slots_[slot] == key) return false;
    slots_[slot] = key;
    items_.push_back(key, arena);
    if (items_.size() * 4ULL > slot_count() * 3) make_table(items_.size(), arena);
    return true;
  }
  /// Inserts keys that differ from each other. While there is no table, they are compared with those that were there
  /// and not with each other, and the table is made once.
  void insert_all(std::span<const Key> keys, Arena& arena) {
    if (slots_ != nullptr) {
      for (const Key key : keys) insert(key, arena);
      return;
    }
    const std::uint32_t known = items_.size();
    items_.reserve(known + static_cast<std::uint32_t>(keys.size()), arena);
    for (const Key key : keys) {
      const Key* end = items_.data() + known;
      if (std::find(items_.data(), end, key) == end) items_.push_back(key, arena);
    }
    if (items_.size() > max_scanned) make_table(items_.size(), arena);
  }
  [[nodiscard]] bool contains(Key key) const {
    if (slots_ == nullptr) return std::find(items_.begin(), items_.end(), key) != items_.end();
    return slots_[find(key)] == key;
  }
  [[nodiscard]] std::uint32_t size() const { return items_.size(); }
  [[nodiscard]] Key operator[](std::size_t at) const { return items_[at]; }
  [[nodiscard]] std::span<const Key> items() const { return {items_.begin(), items_.end()}; }
  /// Frees the table. Call when hardly anything will be looked up.
  void forget_table(Arena& arena) {
    if (slots_ != nullptr) arena.release(slots_, slot_count() * sizeof(Key));
    slots_ = nullptr;
    slot_bits_ = 0;
  }
  void clear(Arena& arena) {
    items_.clear(arena);
    if (slots_ != nullptr) arena.release(slots_, slot_count() * sizeof(Key));
    slots_ = nullptr;
    slot_bits_ = 0;
  }

 private:
  static constexpr std::uint32_t max_scanned = 16;

  [[nodiscard]] std::size_t slot_count() const { return std::size_t{1} << slot_bits_; }
  [[nodiscard]] static Key free_key() {
    Key key;
    std::memset(static_cast<void*>(&key), 0xff, sizeof key);
    return key;
  }
  [[nodiscard]] std::size_t find(Key key) const {
    const std::size_t mask = slot_count() - 1;
    const Key free = free_key();
    std::size_t slot = static_cast<std::size_t>(hash_of_key(key)) & mask;
    while (!(slots_[slot] == key) && !(slots_[slot] == free)) slot = (slot + 1) & mask;
    return slot;
  }
  /// Makes a table for so many and some more.
  void make_table(std::uint32_t count, Arena& arena) {
    if (slots_ != nullptr) arena.release(slots_, slot_count() * sizeof(Key));
    slot_bits_ = static_cast<std::uint32_t>(std::bit_width(count * 4ULL / 3));
    slots_ = static_cast<Key*>(arena.allocate(slot_count() * sizeof(Key)));
    std::memset(static_cast<void*>(slots_), 0xff, slot_count() * sizeof(Key));
    for (const Key key : items_) slots_[find(key)] = key;
  }

  ArenaList<Key> items_;
  Key* slots_ = nullptr;
  std::uint32_t slot_bits_ = 0;
};

}  // namespace geminga::base

#endif
