// Testimonies of witnesses that came in and were not read yet.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_WITNESSES_PENDING_TESTIMONY_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_WITNESSES_PENDING_TESTIMONY_HPP

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/time.hpp"
#include "discovery/announcement/heard_list.hpp"

namespace geminga::membership {

/// The testimonies of the last few presences as they came in, two bits for each place. Adding one copies it. All of
/// them are read together, 32 places at a time, so a testimony about a thousand participants costs no look at each of
/// them.
class PendingTestimony {
 public:
  static constexpr std::size_t capacity = 32;

  [[nodiscard]] bool is_full() const { return size_ == capacity; }
  void clear() { size_ = 0; }
  /// Sets the number of places; clears.
  void resize(std::size_t places);
  /// Adds a testimony about the places, and up to three more. Requires that there is room.
  void add(std::span<const std::uint8_t> octets, base::Instant at);

  /// Calls `take(place, within, at)` for each place with the testimonies that matter: for each share of the interval
  /// the latest one, unless a smaller share was said later.
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
  /// Calls `take(within, at)` with every testimony about one place.
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
  std::vector<std::uint64_t> words_;  ///< testimony by testimony, `blocks_` words each
  std::array<base::Instant, capacity> said_{};
};

}  // namespace geminga::membership

#endif
