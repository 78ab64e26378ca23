// Numbers of records found by content: the hash table under names, terms and expressions.
#ifndef GEMINGA_EL_INTERNER_HPP
#define GEMINGA_EL_INTERNER_HPP

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace geminga::el {

/// An open-addressing table of numbers of records that live elsewhere. It stores no keys: the caller compares.
/// Four bytes a slot, at most 3/4 full, never shrinks. Numbers must be below 2^32 - 1.
class NumberTable {
 public:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  /// The number among those filed under `hash` for which `is_equal(number)` holds, or none.
  template <typename IsEqual>
  [[nodiscard]] std::uint32_t find(std::uint64_t hash, IsEqual&& is_equal) const {
    if (slots_.empty()) return none;
    for (std::size_t slot = static_cast<std::size_t>(hash) & mask();; slot = (slot + 1) & mask()) {
      if (slots_[slot] == none) return none;
      if (is_equal(slots_[slot])) return slots_[slot];
    }
  }

  /// Files a number that find() did not find. `hash_of(number)` gives the hash of any filed number, for growing.
  template <typename HashOf>
  void insert(std::uint64_t hash, std::uint32_t number, HashOf&& hash_of) {
    if ((size_ + 1) * 4 > slots_.size() * 3) {
      std::vector<std::uint32_t> old(slots_.empty() ? 16 : slots_.size() * 2, none);
      old.swap(slots_);
      for (const std::uint32_t filed : old) {
        if (filed != none) place(hash_of(filed), filed);
      }
    }
    place(hash, number);
    ++size_;
  }

  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  [[nodiscard]] std::size_t mask() const { return slots_.size() - 1; }
  void place(std::uint64_t hash, std::uint32_t number) {
    std::size_t slot = static_cast<std::size_t>(hash) & mask();
    while (slots_[slot] != none) slot = (slot + 1) & mask();
    slots_[slot] = number;
  }

  std::vector<std::uint32_t> slots_;
  std::size_t size_ = 0;
};

}  // namespace geminga::el

#endif
