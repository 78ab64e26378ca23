// Units as QUDT 2.1 declares them: a multiplier, an offset, a dimension vector, and the kinds of quantity.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/text.hpp"
#include "reasoning/owl/unit_facts.hpp"

namespace geminga::owl {
namespace {

constexpr std::string_view kind_namespace = "http://qudt.org/vocab/quantitykind/";

// Places of the base units that QUDT's vector does not tell apart.
constexpr std::size_t place_of_radian = 6;
constexpr std::size_t place_of_bit = 7;
constexpr std::size_t place_of_share = 8;

/// The letters of a dimension vector in their order, with the place of the base unit; QUDT's D says that all others
/// are 0.
constexpr std::pair<char, std::size_t> vector_letters[] = {{'A', 10}, {'E', 3}, {'L', 0}, {'I', 5},
                                                           {'M', 1},  {'H', 4}, {'T', 2}};

/// The part of a dimension that a kind of quantity gives and the vector does not.
enum class Said : std::uint8_t { nothing, angle, information, share, number, odd };

constexpr std::pair<std::string_view, Said> qudt_kinds[] = {
    {"Angle", Said::angle},
    {"PlaneAngle", Said::angle},
    {"AngularVelocity", Said::angle},
    {"AngularFrequency", Said::angle},
    {"AngularAcceleration", Said::angle},
    {"InformationEntropy", Said::information},
    {"InformationContent", Said::information},
    {"DatasetOfBits", Said::information},
    {"DataRate", Said::information},
    {"ByteRate", Said::information},
    {"InformationFlowRate", Said::information},
    {"LinearBitDensity", Said::information},
    {"AreaBitDensity", Said::information},
    {"VolumetricBitDensity", Said::information},
    {"DimensionlessRatio", Said::share},
    {"MassFraction", Said::share},
    {"MassRatio", Said::share},
    {"AmountOfSubstanceFraction", Said::share},
    {"VolumeFraction", Said::share},
    {"SolidAngle", Said::number},
    {"Frequency", Said::number},
};

/// Parts of names of kinds that have to do with angles or information in a way that is not known here.
constexpr std::string_view odd_parts[] = {"Angular", "Angle", "Rotation", "Torsion",
                                          "Bit",     "Byte",  "Data",     "Information"};

/// Factors of names of units that the vector passes over.
constexpr std::string_view odd_factors[] = {"RAD",  "DEG",     "ARCMIN", "ARCSEC", "REV",   "GON", "GRAD", "BIT",
                                            "BYTE", "PERCENT", "PPM",    "PPB",    "DeciB", "NP",  "B",    "PERMILLE"};

Said said_by(std::string_view kind) {
  if (!kind.starts_with(kind_namespace)) return Said::nothing;
  const std::string_view name = kind.substr(kind_namespace.size());
  const auto* const found = std::ranges::find(qudt_kinds, name, &std::pair<std::string_view, Said>::first);
  if (found != std::end(qudt_kinds)) return found->second;
  return std::ranges::any_of(odd_parts, [&](std::string_view part) { return name.contains(part); }) ? Said::odd
                                                                                                    : Said::nothing;
}

/// Whether a factor of the name is one that the vector passes over: `RAD` in `N-M-PER-RAD`.
bool has_odd_factor(std::string_view iri) {
  if (!iri.starts_with(qudt_unit_namespace)) return false;
  std::string_view rest = iri.substr(qudt_unit_namespace.size());
  while (!rest.empty()) {
    std::string_view factor = rest.substr(0, rest.find('-'));
    rest.remove_prefix(std::min(rest.size(), factor.size() + 1));
    while (!factor.empty() && factor.back() >= '0' && factor.back() <= '9') factor.remove_suffix(1);
    for (const std::string_view odd : odd_factors) {
      const bool is_prefixed = odd.size() >= 3 && factor.size() > odd.size() && factor.ends_with(odd) &&
                               factor[factor.size() - odd.size() - 1] >= 'a' &&
                               factor[factor.size() - odd.size() - 1] <= 'z';
      if (factor == odd || is_prefixed) return true;
    }
  }
  return false;
}

/// The exponents of `.../A0E0L1I0M0H0T-1D0`.
std::optional<UnitDimension> dimension_of(std::string_view iri) {
  std::string_view rest = iri.substr(iri.find_last_of("/#") + 1);
  UnitDimension dimension{};
  for (const auto& [letter, place] : vector_letters) {
    if (!rest.starts_with(letter)) return std::nullopt;
    rest.remove_prefix(1);
    const std::size_t end = std::min(rest.find_first_not_of("-0123456789"), rest.size());
    const auto exponent = base::parse_number<std::int32_t>(rest.substr(0, end));
    if (!exponent || *exponent < -max_unit_exponent || *exponent > max_unit_exponent) return std::nullopt;
    dimension.at(place) = static_cast<std::int8_t>(*exponent);
    rest.remove_prefix(end);
  }
  const bool has_none = dimension == UnitDimension{};
  return rest == (has_none ? "D1" : "D0") ? std::optional(dimension) : std::nullopt;
}

/// The number under one word, or else under its other one.
std::expected<std::optional<double>, std::string_view> either(const UnitSubject& subject, UnitWord word,
                                                              UnitWord other) {
  return subject.has(word) ? unit_number(subject, word) : unit_number(subject, other);
}

/// Whether something is counted: QUDT's NUM is a ratio, too.
bool is_count(std::string_view kind) {
  return kind.starts_with(kind_namespace) &&
         (kind.ends_with("/Count") || kind.ends_with("/Population") || kind.ends_with("Number"));
}

/// The part that all kinds of a unit give; odd if they do not agree.
Said said_of(const UnitSubject& subject) {
  Said said = Said::nothing;
  for (const UnitFact& fact : subject.all(UnitWord::qudt_kind)) {
    const Said one = said_by(fact.value);
    if (one == Said::nothing || one == said) continue;
    // A kind that is known decides against names that only sound like it.
    if (one == Said::odd) {
      if (said == Said::nothing) said = Said::odd;
    } else {
      said = said == Said::nothing || said == Said::odd ? one : Said::odd;
      if (said == Said::odd) return said;
    }
  }
  const bool is_counted =
      std::ranges::any_of(subject.all(UnitWord::qudt_kind), [](const UnitFact& fact) { return is_count(fact.value); });
  const bool is_odd = (said == Said::nothing && has_odd_factor(subject.iri)) || (said == Said::share && is_counted);
  return is_odd ? Said::odd : said;
}

}  // namespace

bool is_qudt_unit(const UnitSubject& subject) {
  if (subject.has(UnitWord::qudt_multiplier) || subject.has(UnitWord::qudt_multiplier_sn)) return true;
  return std::ranges::any_of(subject.all(UnitWord::type),
                             [](const UnitFact& fact) { return !fact.value.starts_with(om_namespace); });
}

UnitReading qudt_measure(const UnitSubject& subject) {
  const auto multiplier = either(subject, UnitWord::qudt_multiplier, UnitWord::qudt_multiplier_sn);
  if (!multiplier) return std::unexpected(multiplier.error());
  if (!*multiplier) return std::unexpected("a unit without qudt:conversionMultiplier");
  const auto offset = either(subject, UnitWord::qudt_offset, UnitWord::qudt_offset_sn);
  if (!offset) return std::unexpected(offset.error());
  const auto vectors = subject.all(UnitWord::qudt_dimension);
  if (vectors.size() > 1) return std::unexpected("a unit of which two different things are said");
  const auto dimension = vectors.empty() ? std::nullopt : dimension_of(vectors.front().value);
  if (!dimension) return std::unexpected("a unit without a qudt:hasDimensionVector that can be read");
  UnitMeasure measure{**multiplier, offset->value_or(0) * **multiplier, *dimension, {}};
  switch (said_of(subject)) {
    case Said::angle:
      measure.dimension[place_of_radian] = 1;
      break;
    case Said::information:
      measure.dimension[place_of_bit] = 1;
      measure.factor /= std::numbers::ln2;
      break;
    case Said::share:
      if (*dimension == UnitDimension{}) measure.dimension[place_of_share] = 1;
      break;
    case Said::number:
      break;
    case Said::nothing:
      if (*dimension == UnitDimension{}) measure.alone = subject.iri;
      break;
    case Said::odd:
      measure.dimension = {};
      measure.alone = subject.iri;
      break;
  }
  return sound(measure);
}

}  // namespace geminga::owl
