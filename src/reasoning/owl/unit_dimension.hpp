// The base units of which every unit of measurement is made, and the exponents that a unit has of them.
#ifndef GEMINGA_REASONING_OWL_UNIT_DIMENSION_HPP
#define GEMINGA_REASONING_OWL_UNIT_DIMENSION_HPP

#include <array>
#include <cstddef>
#include <cstdint>

namespace geminga::owl {

/// The exponents of metre, kilogram, second, ampere, kelvin, candela, radian, bit, one as a share of a whole, decibel
/// and mole.
inline constexpr std::size_t unit_base_count = 11;
using UnitDimension = std::array<std::int8_t, unit_base_count>;

}  // namespace geminga::owl

#endif
