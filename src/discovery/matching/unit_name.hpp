// Units by the names that the ontology QUDT publishes them under: `unit:KiloM-PER-HR` is km/h.
#ifndef GEMINGA_DISCOVERY_MATCHING_UNIT_NAME_HPP
#define GEMINGA_DISCOVERY_MATCHING_UNIT_NAME_HPP

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace geminga::matching {

/// The longest name behind its prefix or namespace, in octets; a longer one is none.
inline constexpr std::size_t max_unit_name_octets = 32;

/// A short text in place.
class UnitSymbol {
 public:
  [[nodiscard]] std::string_view text() const { return {octets_.data(), size_}; }
  void append(std::string_view piece) {
    for (const char octet : piece) octets_.at(size_++) = octet;
  }

 private:
  /// Each octet of a name makes no more than two: a factor of one letter has a symbol of three at most, and a sign.
  std::array<char, 4 * max_unit_name_octets> octets_{};
  std::size_t size_ = 0;
};

/// What follows `unit:` or `http://qudt.org/vocab/unit/`; nothing where the text begins with neither.
[[nodiscard]] std::optional<std::string_view> qudt_name(std::string_view text);

/// The same unit in symbols (unit.hpp); nothing where a part of the name is unknown. QUDT names a unit by its factors,
/// each perhaps with a prefix in full and an exponent: `KiloGM-M2`, those behind `PER` being divisors. (QUDT,
/// https://www.qudt.org/doc/DOC_VOCAB-UNITS.html)
[[nodiscard]] std::optional<UnitSymbol> symbol_of_name(std::string_view name);

}  // namespace geminga::matching

#endif
