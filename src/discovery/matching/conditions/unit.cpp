#include "discovery/matching/conditions/unit.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "discovery/matching/conditions/number.hpp"
#include "discovery/matching/conditions/unit_name.hpp"

namespace geminga::matching {
namespace {

using vocabulary::Units;

constexpr int max_exponent = 16;
/// How far a published factor may differ from that of the table and mean the same: OM gives a degree with seven digits.
constexpr double published = 1e-6;
/// How far two quantities in different units may differ and be equal: rounding makes no difference.
constexpr double rounding = 1e-12;

enum class Prefixes : std::uint8_t { none, decimal, binary_too };

struct Row {
  std::string_view symbol;
  Unit unit;
  Prefixes prefixes = Prefixes::none;
};

namespace kind {
// m, kg, s, A, K, cd, rad, bit, share, dB
constexpr Dimension length = {1};
constexpr Dimension mass = {0, 1};
constexpr Dimension time = {0, 0, 1};
constexpr Dimension current = {0, 0, 0, 1};
constexpr Dimension temperature = {0, 0, 0, 0, 1};
constexpr Dimension luminous = {0, 0, 0, 0, 0, 1};
constexpr Dimension angle = {0, 0, 0, 0, 0, 0, 1};
constexpr Dimension information = {0, 0, 0, 0, 0, 0, 0, 1};
constexpr Dimension share = {0, 0, 0, 0, 0, 0, 0, 0, 1};
constexpr Dimension level = {0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
constexpr Dimension frequency = {0, 0, -1};
constexpr Dimension speed = {1, 0, -1};
constexpr Dimension turning = {0, 0, -1, 0, 0, 0, 1};
constexpr Dimension force = {1, 1, -2};
constexpr Dimension energy = {2, 1, -2};
constexpr Dimension power = {2, 1, -3};
constexpr Dimension pressure = {-1, 1, -2};
constexpr Dimension charge = {0, 0, 1, 1};
constexpr Dimension voltage = {2, 1, -3, -1};
constexpr Dimension resistance = {2, 1, -3, -2};
constexpr Dimension capacitance = {-2, -1, 4, 2};
constexpr Dimension inductance = {2, 1, -2, -2};
constexpr Dimension flux_density = {0, 1, -2, -1};
constexpr Dimension illuminance = {-2, 0, 0, 0, 0, 1};
constexpr Dimension volume = {3};
}  // namespace kind

constexpr double turn = 2 * std::numbers::pi;

constexpr Row rows[] = {
    {"m", {1, 0, kind::length}, Prefixes::decimal},
    {"g", {1e-3, 0, kind::mass}, Prefixes::decimal},
    {"s", {1, 0, kind::time}, Prefixes::decimal},
    {"A", {1, 0, kind::current}, Prefixes::decimal},
    {"K", {1, 0, kind::temperature}, Prefixes::decimal},
    {"cd", {1, 0, kind::luminous}, Prefixes::decimal},
    {"rad", {1, 0, kind::angle}, Prefixes::decimal},
    {"bit", {1, 0, kind::information}, Prefixes::binary_too},
    {"B", {8, 0, kind::information}, Prefixes::binary_too},
    {"Hz", {1, 0, kind::frequency}, Prefixes::decimal},
    {"N", {1, 0, kind::force}, Prefixes::decimal},
    {"J", {1, 0, kind::energy}, Prefixes::decimal},
    {"W", {1, 0, kind::power}, Prefixes::decimal},
    {"Wh", {3600, 0, kind::energy}, Prefixes::decimal},
    {"Pa", {1, 0, kind::pressure}, Prefixes::decimal},
    {"bar", {1e5, 0, kind::pressure}, Prefixes::decimal},
    {"C", {1, 0, kind::charge}, Prefixes::decimal},
    {"Ah", {3600, 0, kind::charge}, Prefixes::decimal},
    {"V", {1, 0, kind::voltage}, Prefixes::decimal},
    {"Ohm", {1, 0, kind::resistance}, Prefixes::decimal},
    {"\u03a9", {1, 0, kind::resistance}, Prefixes::decimal},
    {"F", {1, 0, kind::capacitance}, Prefixes::decimal},
    {"H", {1, 0, kind::inductance}, Prefixes::decimal},
    {"T", {1, 0, kind::flux_density}, Prefixes::decimal},
    {"lm", {1, 0, kind::luminous}, Prefixes::decimal},
    {"lx", {1, 0, kind::illuminance}, Prefixes::decimal},
    {"l", {1e-3, 0, kind::volume}, Prefixes::decimal},
    {"L", {1e-3, 0, kind::volume}, Prefixes::decimal},
    {"t", {1e3, 0, kind::mass}},
    {"lb", {0.45359237, 0, kind::mass}},
    {"min", {60, 0, kind::time}},
    {"h", {3600, 0, kind::time}},
    {"d", {86400, 0, kind::time}},
    {"in", {0.0254, 0, kind::length}},
    {"ft", {0.3048, 0, kind::length}},
    {"mi", {1609.344, 0, kind::length}},
    {"nmi", {1852, 0, kind::length}},
    {"mph", {0.44704, 0, kind::speed}},
    {"kn", {1852.0 / 3600, 0, kind::speed}},
    {"deg", {turn / 360, 0, kind::angle}},
    {"\u00b0", {turn / 360, 0, kind::angle}},
    {"rpm", {turn / 60, 0, kind::turning}},
    {"\u00b0C", {1, 273.15, kind::temperature}},
    {"degC", {1, 273.15, kind::temperature}},
    {"\u00b0F", {5.0 / 9, 459.67 * 5 / 9, kind::temperature}},
    {"degF", {5.0 / 9, 459.67 * 5 / 9, kind::temperature}},
    {"bps", {1, 0, {0, 0, -1, 0, 0, 0, 0, 1}}, Prefixes::decimal},
    {"fps", {1, 0, kind::frequency}},
    {"%", {1e-2, 0, kind::share}},
    {"ppm", {1e-6, 0, kind::share}},
    {"dB", {1, 0, kind::level}},
};

struct Prefix {
  std::string_view symbol;
  double factor;
  bool is_binary = false;
};

constexpr Prefix prefixes[] = {
    {"Ki", 1024, true},
    {"Mi", 1048576, true},
    {"Gi", 1073741824, true},
    {"Ti", 1099511627776, true},
    {"\u00b5", 1e-6},
    {"\u03bc", 1e-6},
    {"p", 1e-12},
    {"n", 1e-9},
    {"u", 1e-6},
    {"m", 1e-3},
    {"c", 1e-2},
    {"d", 1e-1},
    {"h", 1e2},
    {"k", 1e3},
    {"M", 1e6},
    {"G", 1e9},
    {"T", 1e12},
};

const Row* row(std::string_view symbol) {
  const auto found = std::ranges::find(rows, symbol, &Row::symbol);
  return found == std::end(rows) ? nullptr : found;
}

/// The unit of one symbol, perhaps with a prefix. A symbol that is in the table as it is has none: `min` is a minute.
std::optional<Unit> of_symbol(std::string_view symbol) {
  if (const Row* known = row(symbol)) return known->unit;
  for (const Prefix& prefix : prefixes) {
    if (!symbol.starts_with(prefix.symbol)) continue;
    const Row* known = row(symbol.substr(prefix.symbol.size()));
    if (known == nullptr || known->prefixes == Prefixes::none) continue;
    if (prefix.is_binary && known->prefixes != Prefixes::binary_too) continue;
    return Unit{known->unit.factor * prefix.factor, 0, known->unit.dimension};
  }
  return std::nullopt;
}

/// A unit as an ontology declares it.
std::optional<Unit> of_declared(const std::optional<vocabulary::FoundUnit>& found) {
  if (!found) return std::nullopt;
  Unit unit{found->factor, found->offset, {}};
  std::ranges::copy(found->dimension, unit.dimension.exponents.begin());
  unit.dimension.alone = found->alone;
  return unit;
}

/// Takes `²`, `³`, `^2`, `^-1` or `2` off the end of a symbol; 1 where there is none.
int take_exponent(std::string_view& symbol) {
  for (const auto& [sign, power] : {std::pair<std::string_view, int>{"\u00b2", 2}, {"\u00b3", 3}}) {
    if (symbol.size() > sign.size() && symbol.ends_with(sign)) {
      symbol.remove_suffix(sign.size());
      return power;
    }
  }
  if (symbol.empty() || symbol.back() < '1' || symbol.back() > '4') return 1;
  int power = symbol.back() - '0';
  symbol.remove_suffix(1);
  if (symbol.ends_with('-')) {
    power = -power;
    symbol.remove_suffix(1);
  }
  if (symbol.ends_with('^')) symbol.remove_suffix(1);
  return power;
}

/// The product, or the quotient, of `before` and one factor such as `s^2`; nothing where that is no factor.
std::optional<Unit> times(const Unit& before, std::string_view symbol, bool is_divisor, const Units& declared) {
  const int power = take_exponent(symbol);
  auto factor = of_symbol(symbol);
  if (!factor) factor = of_declared(declared.by_symbol(symbol));
  if (!factor || factor->offset != 0 || before.offset != 0 || factor->dimension.alone != 0) return std::nullopt;
  Unit product = before;
  const bool is_inverse = is_divisor != (power < 0);
  for (int i = 0; i < std::abs(power); ++i) {
    product.factor = is_inverse ? product.factor / factor->factor : product.factor * factor->factor;
    for (std::size_t base = 0; base < vocabulary::unit_base_count; ++base) {
      std::int8_t& one = product.dimension.exponents[base];
      const int exponent = one + (is_inverse ? -1 : 1) * factor->dimension.exponents[base];
      if (std::abs(exponent) > max_exponent) return std::nullopt;
      one = static_cast<std::int8_t>(exponent);
    }
  }
  return std::isnormal(product.factor) ? std::optional(product) : std::nullopt;
}

/// The unit of a product of symbols with exponents.
std::optional<Unit> of_symbols(std::string_view text, const Units& declared) {
  if (text.empty()) return std::nullopt;
  if (const auto alone = of_symbol(text)) return alone;
  std::optional<Unit> product = Unit{};
  bool is_divisor = false;
  while (product) {
    const std::size_t end = std::min(text.find_first_of("/.*"), text.size());
    product = times(*product, text.substr(0, end), is_divisor, declared);
    if (end == text.size()) break;
    is_divisor = text[end] == '/';
    text.remove_prefix(end + 1);
  }
  return product;
}

const Units none;

/// A unit that an ontology declares under a name. Where its symbol is in the table and means the same there, it is the
/// unit of the table.
std::optional<Unit> of_named(const std::optional<vocabulary::FoundUnit>& found) {
  const auto unit = of_declared(found);
  const auto known = unit ? of_symbols(found->symbol, none) : std::nullopt;
  const bool is_known = known && known->dimension == unit->dimension &&
                        std::abs(known->factor - unit->factor) <= published * known->factor;
  return is_known ? known : unit;
}

/// The unit of a name: `unit:CentiM`, an IRI with or without angle brackets, or `prefix:Name`.
std::optional<Unit> of_name(std::string_view text, const Units& declared) {
  if (text.starts_with('<') && text.ends_with('>')) text = text.substr(1, text.size() - 2);
  if (const auto name = qudt_name(text)) {
    const auto symbol = symbol_of_name(*name);
    if (const auto known = symbol ? of_symbols(symbol->text(), none) : std::nullopt) return known;
    const bool is_iri = text.contains("://");
    return of_named(is_iri ? declared.by_iri("http://qudt.org/vocab/unit/", *name) : declared.by_name(text));
  }
  if (declared.is_empty() || text.size() > max_unit_name) return std::nullopt;
  return of_named(text.contains("://") ? declared.by_iri("", text) : declared.by_name(text));
}

}  // namespace

std::optional<Unit> unit(std::string_view text, const Units& declared) {
  if (text.contains(':')) return of_name(text, declared);
  if (text.size() > max_unit_octets) return std::nullopt;
  if (const auto known = of_symbols(text, none)) return known;
  if (declared.is_empty()) return std::nullopt;
  const auto whole = of_declared(declared.by_symbol(text));
  return whole ? whole : of_symbols(text, declared);
}

namespace {

std::optional<Quantity> read(std::string_view text, bool is_difference, const Units& declared) {
  const std::size_t digits = number_length(text);
  const auto value = number(text.substr(0, digits));
  if (!value) return std::nullopt;
  text.remove_prefix(digits);
  while (text.starts_with(' ')) text.remove_prefix(1);
  const auto in = unit(text, declared);
  if (!in) return std::nullopt;
  const double base = *value * in->factor + (is_difference ? 0 : in->offset);
  return std::isfinite(base) ? std::optional(Quantity{base, in->dimension}) : std::nullopt;
}

}  // namespace

std::optional<Quantity> quantity(std::string_view text, const Units& declared) { return read(text, false, declared); }

std::optional<Quantity> difference(std::string_view text, const Units& declared) { return read(text, true, declared); }

std::partial_ordering compare(const Quantity& a, const Quantity& b) {
  if (a.dimension != b.dimension) return std::partial_ordering::unordered;
  if (std::abs(a.value - b.value) <= rounding * std::max(std::abs(a.value), std::abs(b.value))) {
    return std::partial_ordering::equivalent;
  }
  return a.value <=> b.value;
}

}  // namespace geminga::matching
