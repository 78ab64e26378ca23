// The words of QUDT and OM that units are declared in.
#include <algorithm>
#include <utility>

#include "reasoning/owl/unit.hpp"

namespace geminga::owl {
namespace {

constexpr std::string_view qudt_schema = "http://qudt.org/schema/qudt/";

constexpr std::pair<std::string_view, UnitWord> qudt_words[] = {
    {"conversionMultiplier", UnitWord::qudt_multiplier},
    {"conversionMultiplierSN", UnitWord::qudt_multiplier_sn},
    {"conversionOffset", UnitWord::qudt_offset},
    {"conversionOffsetSN", UnitWord::qudt_offset_sn},
    {"hasDimensionVector", UnitWord::qudt_dimension},
    {"hasQuantityKind", UnitWord::qudt_kind},
    {"symbol", UnitWord::qudt_symbol},
    {"ucumCode", UnitWord::qudt_ucum},
};

constexpr std::pair<std::string_view, UnitWord> om_words[] = {
    {"hasUnit", UnitWord::om_unit},
    {"hasPrefix", UnitWord::om_prefix},
    {"hasFactor", UnitWord::om_factor},
    {"hasNumerator", UnitWord::om_numerator},
    {"hasTerm1", UnitWord::om_term1},
    {"hasDenominator", UnitWord::om_denominator},
    {"hasTerm2", UnitWord::om_term2},
    {"hasBase", UnitWord::om_base},
    {"hasExponent", UnitWord::om_exponent},
    {"symbol", UnitWord::om_symbol},
    {"alternativeSymbol", UnitWord::om_other_symbol},
};

constexpr std::string_view qudt_classes[] = {"Unit", "DerivedUnit", "CountingUnit", "DimensionlessUnit",
                                             "LogarithmicUnit"};

constexpr std::string_view om_classes[] = {"Unit",         "SingularUnit",       "PrefixedUnit",       "UnitMultiple",
                                           "UnitDivision", "UnitMultiplication", "UnitExponentiation", "CompoundUnit"};

template <typename Words>
UnitWord word_in(const Words& words, std::string_view name) {
  const auto* const found = std::ranges::find(words, name, &std::pair<std::string_view, UnitWord>::first);
  return found == std::end(words) ? UnitWord::none : found->second;
}

template <typename Names>
bool is_among(const Names& names, std::string_view name) {
  return std::ranges::find(names, name) != std::end(names);
}

}  // namespace

UnitWord unit_word(std::string_view property_iri) {
  if (property_iri.starts_with(qudt_schema)) return word_in(qudt_words, property_iri.substr(qudt_schema.size()));
  if (property_iri.starts_with(om_namespace)) return word_in(om_words, property_iri.substr(om_namespace.size()));
  return UnitWord::none;
}

bool is_unit_class(std::string_view iri) {
  if (iri.starts_with(qudt_schema)) return is_among(qudt_classes, iri.substr(qudt_schema.size()));
  return iri.starts_with(om_namespace) && is_among(om_classes, iri.substr(om_namespace.size()));
}

}  // namespace geminga::owl
