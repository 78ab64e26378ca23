// A set that keeps the order of insertion: a list with an index that is built only when it pays.
#ifndef GEMINGA_BASE_GROWING_SET_HPP
#define GEMINGA_BASE_GROWING_SET_HPP

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace geminga::base {

/// Fibonacci hashing: the high bits of the product are well mixed.
[[nodiscard]] inline std::uint64_t hash_of_key(std::uint32_t key) { return (key * 0x9e3779b97f4a7c15ULL) >> 32; }

/// Members are small keys with `std::uint64_t hash_of_key(Key)`. Up to 12 members the list is scanned.
template <typename Key>
class GrowingSet {
 public:
  /// Returns false if the key was in the set. Amortised O(1).
  bool insert(Key key) {
    if (contains(key)) return false;
    items_.push_back(key);
    if (items_.size() > max_scanned) {
      if (items_.size() * 2 > slots_.size()) {
        rebuild();
      } else {
        place(static_cast<std::uint32_t>(items_.size()));
      }
    }
    return true;
  }

  [[nodiscard]] bool contains(Key key) const {
    if (slots_.empty()) return std::find(items_.begin(), items_.end(), key) != items_.end();
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t slot = static_cast<std::size_t>(hash_of_key(key)) & mask;; slot = (slot + 1) & mask) {
      if (slots_[slot] == 0) return false;
      if (items_[slots_[slot] - 1] == key) return true;
    }
  }

  [[nodiscard]] std::size_t size() const { return items_.size(); }
  [[nodiscard]] Key operator[](std::size_t index) const { return items_[index]; }
  [[nodiscard]] const std::vector<Key>& items() const { return items_; }

 private:
  static constexpr std::size_t max_scanned = 12;

  void place(std::uint32_t position) {
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = static_cast<std::size_t>(hash_of_key(items_[position - 1])) & mask;
    while (slots_[slot] != 0) slot = (slot + 1) & mask;
    slots_[slot] = position;
  }
  void rebuild() {
    slots_.assign(std::max<std::size_t>(32, slots_.size() * 2), 0);
    for (std::uint32_t position = 1; position <= items_.size(); ++position) place(position);
  }

  std::vector<Key> items_;
  std::vector<std::uint32_t> slots_;  ///< positions from 1; 0: free
};

}  // namespace geminga::base

#endif
