// Units of measurement and quantities, as in WHERE.md.
#ifndef GEMINGA_DISCOVERY_MATCHING_CONDITIONS_UNIT_HPP
#define GEMINGA_DISCOVERY_MATCHING_CONDITIONS_UNIT_HPP

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "reasoning/vocabulary/units.hpp"

namespace geminga::matching {

/// The longest unit in symbols, in octets; a longer text is no unit.
inline constexpr std::size_t max_unit_octets = 32;
/// The longest name of a unit that an ontology declares, in octets, without angle brackets.
inline constexpr std::size_t max_unit_name = 512;

/// The dimension of a unit; only quantities of one dimension can be compared. The exponents are those of metre,
/// kilogram, second, ampere, kelvin, candela, radian, bit, share of a whole, decibel and mole (BIPM, The International
/// System of Units, 2.3.3, with additions that robots need). A unit of an ontology whose kind is unknown has no
/// exponents and a number of its own kind: it compares with its multiples only, and cannot be a factor.
struct Dimension {
  std::array<std::int8_t, vocabulary::unit_base_count> exponents{};
  std::uint32_t alone = 0;  ///< the number of an unknown kind, in the ontology that declares the unit; 0: it is known
  friend bool operator==(const Dimension&, const Dimension&) = default;
};

/// A unit: a value in it is `value * factor + offset` in the base units of its dimension.
struct Unit {
  double factor = 1;
  double offset = 0;  ///< 0 but for degrees Celsius and Fahrenheit
  Dimension dimension{};
};

/// The unit that a text such as `cm`, `m/s^2`, `kbit/s`, `°C` or `unit:CentiM` (unit_name.hpp) names, else one that the
/// ontology declares by this symbol or name; nothing where the text is no unit. Allocates nothing. O(length), and
/// O(log n) where only the ontology knows it.
[[nodiscard]] std::optional<Unit> unit(std::string_view text, const vocabulary::Units& declared = {});

/// A number with its unit, in base units.
struct Quantity {
  double value = 0;
  Dimension dimension{};
};

/// The quantity of `3 m` or `350cm`: a number, blanks or none, a unit. Nothing where there is no unit. O(length).
[[nodiscard]] std::optional<Quantity> quantity(std::string_view text, const vocabulary::Units& declared = {});

/// The quantity of a difference: 5 °C are 5 K.
[[nodiscard]] std::optional<Quantity> difference(std::string_view text, const vocabulary::Units& declared = {});

/// Compares two quantities; unordered where their dimensions differ.
[[nodiscard]] std::partial_ordering compare(const Quantity& a, const Quantity& b);

}  // namespace geminga::matching

#endif
