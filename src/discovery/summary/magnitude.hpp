// Magnitudes: numbers of services to a factor of two, so that a summary seldom changes.
#ifndef GEMINGA_DISCOVERY_SUMMARY_MAGNITUDE_HPP
#define GEMINGA_DISCOVERY_SUMMARY_MAGNITUDE_HPP

#include <bit>
#include <cstdint>

namespace geminga::summary {

/// The bits of a number: 0, 1, 2 to 3, 4 to 7 ... have the magnitudes 0, 1, 2, 3 ...
[[nodiscard]] constexpr unsigned magnitude_of(std::uint32_t count) {
  return static_cast<unsigned>(std::bit_width(count));
}
/// The least number of a magnitude.
[[nodiscard]] constexpr std::uint64_t least_of(unsigned magnitude) {
  return magnitude == 0 ? 0 : std::uint64_t{1} << (magnitude - 1);
}
/// Whether a number is so far from the magnitude that was said that another one must be said. One less is not, so that
/// a number which moves around a power of two is said once.
[[nodiscard]] constexpr bool is_other(unsigned said, std::uint32_t count) {
  const unsigned is = magnitude_of(count);
  return is > said || is + 1 < said || (count == 0 && said != 0);
}

}  // namespace geminga::summary

#endif
