// Units of measurement: what a number is a number of, as WHERE.md lists them.
#ifndef GEMINGA_DISCOVERY_MATCHING_UNIT_HPP
#define GEMINGA_DISCOVERY_MATCHING_UNIT_HPP

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "reasoning/vocabulary/units.hpp"

namespace geminga::matching {

/// The longest unit in symbols, in octets; a longer one is none.
inline constexpr std::size_t max_unit_octets = 32;
/// The longest name of a unit that an ontology declares, in octets, without angle brackets.
inline constexpr std::size_t max_unit_name = 512;

/// What can be compared with each other: the exponents of metre, kilogram, second, ampere, kelvin, candela, radian,
/// bit, one as a share of a whole, decibel and mole (BIPM, The International System of Units, 2.3.3, and what robots
/// need beside). A unit of an ontology whose kind nobody knows has no exponents and the number of its own kind: it is
/// not the base of a twelfth exponent, since nothing can be made of it but its multiples.
struct Dimension {
  std::array<std::int8_t, vocabulary::unit_base_count> exponents{};
  std::uint32_t alone = 0;  ///< not 0: the kind, by the ontology that the unit is from
  friend bool operator==(const Dimension&, const Dimension&) = default;
};

/// A value in this unit is `value * factor + offset` in the base units of its dimension.
struct Unit {
  double factor = 1;
  double offset = 0;  ///< 0 but for degrees Celsius and Fahrenheit
  Dimension dimension{};
};

/// The unit of `cm`, `m/s^2`, `kbit/s`, `°C`, or `unit:CentiM` (unit_name.hpp), else one that the ontology declares, by
/// symbol or by name; nothing where it is none. Allocates nothing. O(length), and O(log n) where only the ontology
/// knows it.
[[nodiscard]] std::optional<Unit> unit(std::string_view text, const vocabulary::Units& declared = {});

/// A number with its unit, in base units.
struct Quantity {
  double value = 0;
  Dimension dimension{};
};

/// The quantity of `3 m` or `350cm`: a number, blanks or none, a unit. Nothing where there is no unit. O(length).
[[nodiscard]] std::optional<Quantity> quantity(std::string_view text, const vocabulary::Units& declared = {});

/// As quantity(), of a difference: 5 °C are 5 K.
[[nodiscard]] std::optional<Quantity> difference(std::string_view text, const vocabulary::Units& declared = {});

/// Unordered where they are of different dimensions.
[[nodiscard]] std::partial_ordering compare(const Quantity& a, const Quantity& b);

}  // namespace geminga::matching

#endif
