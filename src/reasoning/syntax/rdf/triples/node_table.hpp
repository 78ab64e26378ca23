// Finds the numbers of nodes by content, for millions of nodes. A slot holds half of the hash beside the number, so
// that a search looks only at the node that it finds.
#ifndef GEMINGA_REASONING_SYNTAX_RDF_TRIPLES_NODE_TABLE_HPP
#define GEMINGA_REASONING_SYNTAX_RDF_TRIPLES_NODE_TABLE_HPP

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace geminga::rdf {

/// An open-addressing table of numbers of records that live elsewhere. It stores no keys: the caller compares.
/// Eight bytes a slot, at most 3/4 full, never shrinks. Numbers must be below 2^32 - 1.
class NodeTable {
 public:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  /// The number filed under `hash` for which `is_equal(number)` holds. If there is none, files `number` and returns
  /// none.
  template <typename IsEqual>
  std::uint32_t find_or_insert(std::uint64_t hash, std::uint32_t number, IsEqual&& is_equal) {
    if ((size_ + 1) * 4 > slots_.size() * 3) grow();
    const auto tag = static_cast<std::uint32_t>(hash >> 32U);
    std::size_t slot = place_of(tag);
    for (; slots_[slot].number != none; slot = (slot + 1) & mask()) {
      if (slots_[slot].tag == tag && is_equal(slots_[slot].number)) return slots_[slot].number;
    }
    slots_[slot] = {number, tag};
    ++size_;
    return none;
  }

  /// Fetches into the cache what a search for this hash looks at first.
  void prefetch(std::uint64_t hash) const {
    if (!slots_.empty()) __builtin_prefetch(&slots_[place_of(static_cast<std::uint32_t>(hash >> 32U))]);
  }
  /// The number that a search for this hash compares first, or none.
  [[nodiscard]] std::uint32_t first_candidate(std::uint64_t hash) const {
    if (slots_.empty()) return none;
    const auto tag = static_cast<std::uint32_t>(hash >> 32U);
    for (std::size_t slot = place_of(tag); slots_[slot].number != none; slot = (slot + 1) & mask()) {
      if (slots_[slot].tag == tag) return slots_[slot].number;
    }
    return none;
  }

 private:
  struct Slot {
    std::uint32_t number = none;
    std::uint32_t tag = 0;
  };

  [[nodiscard]] std::size_t mask() const { return slots_.size() - 1; }
  /// Uses the tag's own bits, so that growing needs only the slots.
  [[nodiscard]] std::size_t place_of(std::uint32_t tag) const { return tag & mask(); }

  void grow() {
    std::vector<Slot> old(slots_.empty() ? 1024 : slots_.size() * 2);
    old.swap(slots_);
    for (const Slot& filed : old) {
      if (filed.number == none) continue;
      std::size_t slot = place_of(filed.tag);
      while (slots_[slot].number != none) slot = (slot + 1) & mask();
      slots_[slot] = filed;
    }
  }

  std::vector<Slot> slots_;
  std::size_t size_ = 0;
};

}  // namespace geminga::rdf

#endif
