// A table that finds the numbers of records by content: the hash table under names, terms and expressions.
#ifndef GEMINGA_BASE_INTERNER_HPP
#define GEMINGA_BASE_INTERNER_HPP

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace geminga::base {

/// An open-addressing table of numbers of records that live elsewhere. It stores only the upper half of each hash: a
/// record is compared only if that agrees, and none is read to grow. Eight bytes a slot, at most 3/4 full, never
/// shrinks. Numbers must be below 2^32 - 1.
class NumberTable {
 public:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  /// The number filed under `hash` for which `is_equal(number)` holds, or none.
  template <typename IsEqual>
  [[nodiscard]] std::uint32_t find(std::uint64_t hash, IsEqual&& is_equal) const {
    if (slots_.empty()) return none;
    const std::uint32_t half = upper(hash);
    for (std::size_t at = half & mask();; at = (at + 1) & mask()) {
      const Slot& slot = slots_[at];
      if (slot.number == none) return none;
      if (slot.hash == half && is_equal(slot.number)) return slot.number;
    }
  }

  /// Files a number that find() did not find.
  void insert(std::uint64_t hash, std::uint32_t number) {
    if ((size_ + 1) * 4 > slots_.size() * 3) {
      std::vector<Slot> old(slots_.empty() ? 16 : slots_.size() * 2);
      old.swap(slots_);
      for (const Slot& filed : old) {
        if (filed.number != none) place(filed);
      }
    }
    place({upper(hash), number});
    ++size_;
  }

 private:
  struct Slot {
    std::uint32_t hash = 0;
    std::uint32_t number = none;
  };

  [[nodiscard]] static std::uint32_t upper(std::uint64_t hash) { return static_cast<std::uint32_t>(hash >> 32); }
  [[nodiscard]] std::size_t mask() const { return slots_.size() - 1; }
  void place(const Slot& filed) {
    std::size_t at = filed.hash & mask();
    while (slots_[at].number != none) at = (at + 1) & mask();
    slots_[at] = filed;
  }

  std::vector<Slot> slots_;
  std::size_t size_ = 0;
};

/// Adds one more number to a hash. Each step is a bijection of the hash so far.
[[nodiscard]] inline std::uint64_t mixed(std::uint64_t hash, std::uint64_t number) {
  hash = (hash ^ number) * 0x9e3779b97f4a7c15ULL;
  return hash ^ hash >> 32;
}

}  // namespace geminga::base

#endif
