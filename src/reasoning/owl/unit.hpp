// Units of measurement that an ontology declares in the words of QUDT 2.1 or OM 2.0. They mean nothing to the reasoner
// (src/discovery/matching/UNITS.md).
#ifndef GEMINGA_REASONING_OWL_UNIT_HPP
#define GEMINGA_REASONING_OWL_UNIT_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reasoning/owl/left_out.hpp"

namespace geminga::owl {

class Ontology;

/// The most statements about units of one ontology; of one that has more no unit is read.
inline constexpr std::size_t max_unit_statements = std::size_t{1} << 18;
/// The most units of one ontology; of one that has more none is read.
inline constexpr std::size_t max_units = 16'384;
/// The longest IRI of a unit and the longest value that is said of one, in octets.
inline constexpr std::size_t max_unit_text_octets = 512;
/// The longest symbol, in octets; a longer one names nothing.
inline constexpr std::size_t max_unit_symbol_octets = 32;
/// Of the base units, in magnitude.
inline constexpr int max_unit_exponent = 16;

/// The exponents of metre, kilogram, second, ampere, kelvin, candela, radian, bit, one as a share of a whole, decibel
/// and mole.
inline constexpr std::size_t unit_base_count = 11;
using UnitDimension = std::array<std::int8_t, unit_base_count>;

/// A word in which QUDT or OM describes a unit, a prefix, or a part of a unit.
enum class UnitWord : std::uint8_t {
  none,
  too_long,  ///< something that is longer than max_unit_text_octets
  type,      ///< that it is a unit
  qudt_multiplier,
  qudt_multiplier_sn,
  qudt_offset,
  qudt_offset_sn,
  qudt_dimension,
  qudt_kind,
  qudt_symbol,
  qudt_ucum,
  om_unit,
  om_prefix,
  om_factor,
  om_numerator,
  om_denominator,
  om_term1,
  om_term2,
  om_base,
  om_exponent,
  om_symbol,
  om_other_symbol,
};

inline constexpr std::string_view qudt_unit_namespace = "http://qudt.org/vocab/unit/";
inline constexpr std::string_view om_namespace = "http://www.ontology-of-units-of-measure.org/resource/om-2/";
inline constexpr std::string_view rdf_type = "http://www.w3.org/1999/02/22-rdf-syntax-ns#type";

/// The word that a property stands for; none if it does not describe units. For rdf:type see is_unit_class().
[[nodiscard]] UnitWord unit_word(std::string_view property_iri);
/// Whether instances of this class of QUDT or OM are units.
[[nodiscard]] bool is_unit_class(std::string_view iri);

/// A value in this unit is `value * factor + offset` in the base units of its dimension.
struct DeclaredUnit {
  std::string iri;
  double factor = 1;
  double offset = 0;
  UnitDimension dimension{};
  /// For a unit of unknown kind: the position of the unit of which it is a multiple. It can be compared with multiples
  /// of that unit only, and its dimension is empty.
  std::optional<std::uint32_t> alone;
  std::string symbol;  ///< that it is usually written by; empty: none that can be
};

/// A name of a unit: its IRI or a symbol.
struct UnitName {
  std::string text;
  std::uint32_t unit = 0;
};

struct DeclaredUnits {
  std::vector<DeclaredUnit> units;  ///< by IRI
  /// Ascending by octets, each once. A symbol that two units have that differ is none.
  std::vector<UnitName> names;
  std::vector<LeftOut> left_out;  ///< by reason; `first` names the unit, too
};

/// The units that an ontology declares, whatever the order in which it was read. O(n log n).
[[nodiscard]] DeclaredUnits units_of(const Ontology& source);

}  // namespace geminga::owl

#endif
