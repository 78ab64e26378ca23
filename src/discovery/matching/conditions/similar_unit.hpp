// The unit that a text which is none may mean, for errors.
#ifndef GEMINGA_DISCOVERY_MATCHING_CONDITIONS_SIMILAR_UNIT_HPP
#define GEMINGA_DISCOVERY_MATCHING_CONDITIONS_SIMILAR_UNIT_HPP

#include <cstddef>
#include <string>
#include <string_view>

namespace geminga::matching {

/// The longest symbol whose letters are tried in both cases.
inline constexpr std::size_t max_tried_letters = 5;

/// The symbol (unit.hpp) that a text may mean which is no unit: it differs in the case of letters (`KM`), or is the
/// name of a unit written out (`metres`, `kilograms`). Empty where there is none.
[[nodiscard]] std::string similar_unit(std::string_view text);

/// Units of the table of WHERE.md, for an error text.
inline constexpr std::string_view known_units =
    "known are m, g, s, A, K, rad, deg, Hz, N, J, W, Pa, V, B, bit, %, degC, min, h and their like, as in km/h";

}  // namespace geminga::matching

#endif
