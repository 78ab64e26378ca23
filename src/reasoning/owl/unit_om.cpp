// Units as OM 2.0 declares them: by other units, down to those that are known here.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "reasoning/owl/unit_facts.hpp"

namespace geminga::owl {
namespace {

struct KnownUnit {
  std::string_view name;
  UnitMeasure measure;
};

/// The units of which all others are made. They need no declaration, and statements about them are ignored, because OM
/// defines kilogram and gram by each other.
constexpr KnownUnit om_bases[] = {
    {"metre", {1, 0, {1}, {}}},
    {"kilogram", {1, 0, {0, 1}, {}}},
    {"second-Time", {1, 0, {0, 0, 1}, {}}},
    {"ampere", {1, 0, {0, 0, 0, 1}, {}}},
    {"kelvin", {1, 0, {0, 0, 0, 0, 1}, {}}},
    {"candela", {1, 0, {0, 0, 0, 0, 0, 1}, {}}},
    {"radian", {1, 0, {0, 0, 0, 0, 0, 0, 1}, {}}},
    {"bit", {1, 0, {0, 0, 0, 0, 0, 0, 0, 1}, {}}},
    {"one", {1, 0, {0, 0, 0, 0, 0, 0, 0, 0, 1}, {}}},
    {"bel", {10, 0, {0, 0, 0, 0, 0, 0, 0, 0, 0, 1}, {}}},
    {"mole", {1, 0, {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1}, {}}},
    {"steradian", {1, 0, {}, {}}},
    // OM gives their zeros by scales.
    {"degreeCelsius", {1, 273.15, {0, 0, 0, 0, 1}, {}}},
    {"degreeFahrenheit", {5.0 / 9, 459.67 * 5 / 9, {0, 0, 0, 0, 1}, {}}},
};

/// Coherent units of the SI with names of their own, for ontologies that do not define them.
constexpr KnownUnit om_named[] = {
    {"hertz", {1, 0, {0, 0, -1}, {}}},
    {"newton", {1, 0, {1, 1, -2}, {}}},
    {"pascal", {1, 0, {-1, 1, -2}, {}}},
    {"joule", {1, 0, {2, 1, -2}, {}}},
    {"watt", {1, 0, {2, 1, -3}, {}}},
    {"coulomb", {1, 0, {0, 0, 1, 1}, {}}},
    {"volt", {1, 0, {2, 1, -3, -1}, {}}},
    {"farad", {1, 0, {-2, -1, 4, 2}, {}}},
    {"ohm", {1, 0, {2, 1, -3, -2}, {}}},
    {"siemens", {1, 0, {-2, -1, 3, 2}, {}}},
    {"weber", {1, 0, {2, 1, -2, -1}, {}}},
    {"tesla", {1, 0, {0, 1, -2, -1}, {}}},
    {"henry", {1, 0, {2, 1, -2, -2}, {}}},
    {"lumen", {1, 0, {0, 0, 0, 0, 0, 1}, {}}},
    {"lux", {1, 0, {-2, 0, 0, 0, 0, 1}, {}}},
    {"becquerel", {1, 0, {0, 0, -1}, {}}},
    {"gray", {1, 0, {2, 0, -2}, {}}},
    {"sievert", {1, 0, {2, 0, -2}, {}}},
    {"katal", {1, 0, {0, 0, -1, 0, 0, 0, 0, 0, 0, 0, 1}, {}}},
};

template <typename Table>
const UnitMeasure* known_unit(const Table& table, std::string_view iri) {
  if (!iri.starts_with(om_namespace)) return nullptr;
  const auto* const found = std::ranges::find(table, iri.substr(om_namespace.size()), &KnownUnit::name);
  return found == std::end(table) ? nullptr : &found->measure;
}

constexpr std::string_view two_things_said = "a unit of which two different things are said";

/// `left` times `right` to the power of `sign`. An offset is none in a product: 5 °C/h is a difference.
UnitReading product_of_units(const UnitMeasure& left, const UnitMeasure& right, int sign) {
  if (!left.alone.empty() || !right.alone.empty()) {
    return std::unexpected("a unit made of one that is a kind of its own");
  }
  UnitMeasure measure;
  measure.factor = sign > 0 ? left.factor * right.factor : left.factor / right.factor;
  for (std::size_t base = 0; base < unit_base_count; ++base) {
    const int exponent = left.dimension.at(base) + sign * right.dimension.at(base);
    if (std::abs(exponent) > max_unit_exponent) return std::unexpected("a unit with an exponent over 16");
    measure.dimension.at(base) = static_cast<std::int8_t>(exponent);
  }
  return sound(measure);
}

/// So many of a unit.
UnitReading multiple_of_unit(const UnitMeasure& unit, double factor) {
  if (unit.offset != 0 && factor != 1) return std::unexpected("a multiple of a unit with an offset");
  UnitMeasure measure = unit;
  measure.factor *= factor;
  return sound(measure);
}

UnitReading power_of_unit(const UnitMeasure& unit, double exponent) {
  if (exponent != std::floor(exponent) || std::abs(exponent) > max_unit_exponent || exponent == 0) {
    return std::unexpected("a unit with an exponent that is no whole number from 1 to 16");
  }
  UnitReading measure = UnitMeasure{};
  for (int left = std::abs(static_cast<int>(exponent)); left > 0 && measure; --left) {
    measure = product_of_units(*measure, unit, exponent > 0 ? 1 : -1);
  }
  return measure;
}

/// Resolves units by those that they are made of, without recursion: how deep that goes is for others to say.
class UnitResolver {
 public:
  UnitResolver(std::span<const UnitSubject> subjects, std::span<std::optional<UnitReading>> readings)
      : subjects_(subjects), readings_(readings), is_open_(subjects.size(), false) {}

  void resolve(std::size_t subject) {
    stack_.assign(1, subject);
    while (!stack_.empty()) {
      const std::size_t top = stack_.back();
      if (readings_[top]) {
        stack_.pop_back();
      } else if (is_open_[top]) {
        readings_[top] = measure(subjects_[top]);
        is_open_[top] = false;
        stack_.pop_back();
      } else {
        is_open_[top] = true;
        push_parts(subjects_[top]);
      }
    }
  }

 private:
  static constexpr UnitWord parts[] = {UnitWord::om_unit,  UnitWord::om_numerator, UnitWord::om_denominator,
                                       UnitWord::om_term1, UnitWord::om_term2,     UnitWord::om_base};

  [[nodiscard]] const UnitSubject* subject(std::string_view iri) const {
    const auto found = std::ranges::lower_bound(subjects_, iri, {}, &UnitSubject::iri);
    return found != subjects_.end() && found->iri == iri ? &*found : nullptr;
  }
  [[nodiscard]] std::size_t place(const UnitSubject& subject) const {
    return static_cast<std::size_t>(&subject - subjects_.data());
  }

  void push_parts(const UnitSubject& of) {
    for (const UnitWord word : parts) {
      for (const UnitFact& fact : of.all(word)) {
        const UnitSubject* part = subject(fact.value);
        if (part != nullptr && is_om_unit(*part) && !readings_[place(*part)] && !is_open_[place(*part)]) {
          stack_.push_back(place(*part));
        }
      }
    }
  }

  /// The only unit that is named under a word.
  [[nodiscard]] UnitReading part(const UnitSubject& of, UnitWord word) const {
    const auto facts = of.all(word);
    if (facts.size() > 1) return std::unexpected(two_things_said);
    if (facts.empty()) return std::unexpected("a unit of which a part is missing");
    const std::string_view iri = facts.front().value;
    if (const UnitMeasure* base = known_unit(om_bases, iri)) return *base;
    const UnitSubject* known = subject(iri);
    if (known == nullptr || (!is_om_unit(*known) && !readings_[place(*known)])) {
      return std::unexpected("a unit made of one that is not declared");
    }
    const auto& reading = readings_[place(*known)];
    if (!reading) return std::unexpected("a unit that is made of itself");
    return *reading ? *reading : std::unexpected("a unit made of one that is left out");
  }

  [[nodiscard]] UnitReading prefixed(const UnitSubject& of) const {
    const auto unit = part(of, UnitWord::om_unit);
    const auto prefixes = of.all(UnitWord::om_prefix);
    if (!unit) return unit;
    if (prefixes.size() > 1) return std::unexpected(two_things_said);
    const UnitSubject* prefix = subject(prefixes.front().value);
    const auto factor =
        prefix == nullptr ? std::optional<double>() : unit_number(*prefix, UnitWord::om_factor).value_or(std::nullopt);
    return factor ? multiple_of_unit(*unit, *factor)
                  : std::unexpected("a unit with a prefix whose factor is not declared");
  }

  [[nodiscard]] UnitReading measure(const UnitSubject& of) const {
    if (const UnitMeasure* base = known_unit(om_bases, of.iri)) return *base;
    if (of.has(UnitWord::om_prefix)) return prefixed(of);
    const bool is_division = of.has(UnitWord::om_numerator) || of.has(UnitWord::om_denominator);
    if (is_division || of.has(UnitWord::om_term1) || of.has(UnitWord::om_term2)) {
      const auto left = part(of, is_division ? UnitWord::om_numerator : UnitWord::om_term1);
      const auto right = part(of, is_division ? UnitWord::om_denominator : UnitWord::om_term2);
      return !left ? left : !right ? right : product_of_units(*left, *right, is_division ? -1 : 1);
    }
    if (of.has(UnitWord::om_base)) {
      const auto base = part(of, UnitWord::om_base);
      const auto exponent = unit_number(of, UnitWord::om_exponent);
      if (!base) return base;
      if (!exponent) return std::unexpected(exponent.error());
      return power_of_unit(*base, exponent->value_or(0));
    }
    if (of.has(UnitWord::om_unit)) {
      const auto unit = part(of, UnitWord::om_unit);
      const auto factor = unit_number(of, UnitWord::om_factor);
      if (!unit) return unit;
      return factor ? multiple_of_unit(*unit, factor->value_or(1)) : std::unexpected(factor.error());
    }
    if (const UnitMeasure* coherent = known_unit(om_named, of.iri)) return *coherent;
    UnitMeasure of_its_own;
    of_its_own.alone = of.iri;
    return of_its_own;
  }

  std::span<const UnitSubject> subjects_;
  std::span<std::optional<UnitReading>> readings_;
  std::vector<bool> is_open_;
  std::vector<std::size_t> stack_;
};

}  // namespace

bool is_om_unit(const UnitSubject& subject) {
  constexpr UnitWord of_units[] = {UnitWord::om_prefix, UnitWord::om_numerator, UnitWord::om_term1, UnitWord::om_base};
  return std::ranges::any_of(of_units, [&](UnitWord word) { return subject.has(word); }) ||
         std::ranges::any_of(subject.all(UnitWord::type),
                             [](const UnitFact& fact) { return fact.value.starts_with(om_namespace); });
}

void measure_om_units(std::span<const UnitSubject> subjects, std::span<std::optional<UnitReading>> readings) {
  UnitResolver resolver(subjects, readings);
  for (std::size_t number = 0; number < subjects.size(); ++number) {
    if (!readings[number] && is_om_unit(subjects[number])) resolver.resolve(number);
  }
}

}  // namespace geminga::owl
