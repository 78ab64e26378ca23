// What witnesses have said of late and nobody has asked for yet.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_PENDING_WORDS_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_PENDING_WORDS_HPP

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/time.hpp"
#include "discovery/announcement/heard_list.hpp"

namespace geminga::membership {

/// The words of the last few presences as they came in, two bits for each place. To take one in is to copy it; all of
/// them together are then read once, 32 places at a time, so a word about a thousand costs no look at each of them.
class PendingWords {
 public:
  static constexpr std::size_t capacity = 32;

  [[nodiscard]] bool is_full() const { return size_ == capacity; }
  void clear() { size_ = 0; }
  /// So many places from now on; clears.
  void resize(std::size_t places);
  /// What somebody said at an instant, of as many places or of up to three more. Requires that there is room.
  void add(std::span<const std::uint8_t> octets, base::Instant at);

  /// Calls `take(place, within, at)` for each place with what matters of all that was said of it: for each share of the
  /// interval the last time at which it was said, unless a lesser share was said after that.
  template <typename Take>
  void read(const Take& take) const {
    using announcement::HeardWithin;
    for (std::size_t block = 0; block < blocks_; ++block) {
      std::uint64_t quarters = 0;
      std::uint64_t halves = 0;
      std::uint64_t wholes = 0;
      for (std::size_t word = size_; word-- > 0;) {
        const std::uint64_t bits = words_[word * blocks_ + block];
        const std::uint64_t low = bits & low_bits;
        const std::uint64_t high = (bits >> 1) & low_bits;
        const std::uint64_t quarter = low & high & ~quarters;
        quarters |= quarter;
        const std::uint64_t half = high & ~low & ~halves & ~quarters;
        halves |= half;
        const std::uint64_t whole = low & ~high & ~wholes & ~halves & ~quarters;
        wholes |= whole;
        for_each_place(quarter, block, [&](std::size_t place) { take(place, HeardWithin::quarter, said_[word]); });
        for_each_place(half, block, [&](std::size_t place) { take(place, HeardWithin::half, said_[word]); });
        for_each_place(whole, block, [&](std::size_t place) { take(place, HeardWithin::interval, said_[word]); });
      }
    }
  }
  /// The same of one place, with every word.
  template <typename Take>
  void read_one(std::size_t place, const Take& take) const {
    for (std::size_t word = 0; word < size_; ++word) {
      const std::uint64_t bits = words_[word * blocks_ + place / places_per_block];
      const auto within = static_cast<announcement::HeardWithin>((bits >> (place % places_per_block * 2)) & 3);
      if (within != announcement::HeardWithin::longer) take(within, said_[word]);
    }
  }

 private:
  static constexpr std::size_t places_per_block = 32;
  static constexpr std::uint64_t low_bits = 0x5555'5555'5555'5555;

  template <typename Visit>
  static void for_each_place(std::uint64_t bits, std::size_t block, const Visit& visit) {
    for (; bits != 0; bits &= bits - 1) {
      visit(block * places_per_block + static_cast<std::size_t>(std::countr_zero(bits)) / 2);
    }
  }

  std::size_t blocks_ = 0;
  std::size_t size_ = 0;
  std::vector<std::uint64_t> words_;  ///< one after the other, `blocks_` each
  std::array<base::Instant, capacity> said_{};
};

}  // namespace geminga::membership

#endif
