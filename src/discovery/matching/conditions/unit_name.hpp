// Names of units in the ontology QUDT: `unit:KiloM-PER-HR` is km/h.
#ifndef GEMINGA_DISCOVERY_MATCHING_CONDITIONS_UNIT_NAME_HPP
#define GEMINGA_DISCOVERY_MATCHING_CONDITIONS_UNIT_NAME_HPP

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace geminga::matching {

/// The longest name behind its prefix or namespace, in octets; a longer text is no name.
inline constexpr std::size_t max_unit_name_octets = 32;

/// A symbol with its octets in place, without an allocation.
class UnitSymbol {
 public:
  [[nodiscard]] std::string_view text() const { return {octets_.data(), size_}; }
  void append(std::string_view piece) {
    for (const char octet : piece) octets_.at(size_++) = octet;
  }

 private:
  /// Room for every name: a factor of one letter has a symbol of three octets at most, and a sign before it.
  std::array<char, 4 * max_unit_name_octets> octets_{};
  std::size_t size_ = 0;
};

/// The rest of a text behind `unit:` or `http://qudt.org/vocab/unit/`; nothing where it begins with neither.
[[nodiscard]] std::optional<std::string_view> qudt_name(std::string_view text);

/// The symbol (unit.hpp) of a unit that QUDT names; nothing where a part of the name is unknown. QUDT names a unit by
/// its factors, each perhaps with a prefix in full and an exponent: `KiloGM-M2`. Factors behind `PER` are divisors.
/// (QUDT, https://www.qudt.org/doc/DOC_VOCAB-UNITS.html)
[[nodiscard]] std::optional<UnitSymbol> symbol_of_name(std::string_view name);

}  // namespace geminga::matching

#endif
