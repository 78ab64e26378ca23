#include "discovery/matching/conditions/unit_name.hpp"

#include <algorithm>
#include <utility>

namespace geminga::matching {
namespace {

struct UnitName {
  std::string_view name;
  std::string_view symbol;
  bool has_prefixes = false;
};

constexpr UnitName factor_names[] = {
    {"M", "m", true},     {"GM", "g", true},    {"SEC", "s", true},   {"A", "A", true}, {"K", "K", true},
    {"CD", "cd", true},   {"RAD", "rad", true}, {"HZ", "Hz", true},   {"N", "N", true}, {"J", "J", true},
    {"W", "W", true},     {"PA", "Pa", true},   {"BAR", "bar", true}, {"C", "C", true}, {"V", "V", true},
    {"OHM", "Ohm", true}, {"FARAD", "F", true}, {"H", "H", true},     {"T", "T", true}, {"LM", "lm", true},
    {"LUX", "lx", true},  {"L", "l", true},     {"BIT", "bit"},       {"BYTE", "B"},    {"TONNE", "t"},
    {"LB", "lb"},         {"MIN", "min"},       {"HR", "h"},          {"DAY", "d"},     {"IN", "in"},
    {"FT", "ft"},         {"MI", "mi"},         {"MI_N", "nmi"},      {"KN", "kn"},     {"DEG", "deg"},
    {"DEG_C", "degC"},    {"DEG_F", "degF"},    {"PERCENT", "%"},     {"PPM", "ppm"},   {"DeciB", "dB"},
};

/// Names that have another meaning than the product of their factors.
constexpr UnitName whole_names[] = {{"REV-PER-MIN", "rpm"}, {"FRAME-PER-SEC", "fps"}};

constexpr UnitName prefix_names[] = {{"Pico", "p"}, {"Nano", "n"},  {"Micro", "u"}, {"Milli", "m"}, {"Centi", "c"},
                                     {"Deci", "d"}, {"Hecto", "h"}, {"Kilo", "k"},  {"Mega", "M"},  {"Giga", "G"},
                                     {"Tera", "T"}, {"Kibi", "Ki"}, {"Mebi", "Mi"}, {"Gibi", "Gi"}, {"Tebi", "Ti"}};

template <typename Names>
const UnitName* find_name(const Names& names, std::string_view name) {
  const auto found = std::ranges::find(names, name, &UnitName::name);
  return found == std::end(names) ? nullptr : found;
}

/// Whether a factor takes a prefix. Bits and octets take large ones only, because they have no parts.
bool takes_prefix(const UnitName& prefix, const UnitName& factor) {
  if (prefix.symbol.ends_with('i')) return factor.symbol == "bit" || factor.symbol == "B";
  const bool is_large = prefix.symbol == "k" || prefix.symbol == "M" || prefix.symbol == "G" || prefix.symbol == "T";
  return factor.has_prefixes || (is_large && (factor.symbol == "bit" || factor.symbol == "B"));
}

bool append_factor(std::string_view name, UnitSymbol& symbol) {
  std::string_view exponent;
  if (!name.empty() && name.back() >= '2' && name.back() <= '4') {
    exponent = name.substr(name.size() - 1);
    name.remove_suffix(1);
  }
  const UnitName* factor = find_name(factor_names, name);
  if (factor == nullptr) {
    const auto prefix =
        std::ranges::find_if(prefix_names, [&](const UnitName& one) { return name.starts_with(one.name); });
    if (prefix == std::end(prefix_names)) return false;
    factor = find_name(factor_names, name.substr(prefix->name.size()));
    if (factor == nullptr || !takes_prefix(*prefix, *factor)) return false;
    symbol.append(prefix->symbol);
  }
  symbol.append(factor->symbol);
  symbol.append(exponent);
  return true;
}

}  // namespace

std::optional<std::string_view> qudt_name(std::string_view text) {
  for (const std::string_view space : {"unit:", "http://qudt.org/vocab/unit/", "https://qudt.org/vocab/unit/"}) {
    if (text.starts_with(space)) return text.substr(space.size());
  }
  return std::nullopt;
}

std::optional<UnitSymbol> symbol_of_name(std::string_view name) {
  if (name.empty() || name.size() > max_unit_name_octets) return std::nullopt;
  UnitSymbol symbol;
  if (const UnitName* known = find_name(whole_names, name)) {
    symbol.append(known->symbol);
    return symbol;
  }
  bool is_divisor = false;
  for (bool is_first = true;; is_first = false) {
    std::string_view factor = name.substr(0, name.find('-'));
    if (factor == "PER" && !is_divisor && !is_first) {
      is_divisor = true;
      name.remove_prefix(std::min(name.size(), factor.size() + 1));
      factor = name.substr(0, name.find('-'));
    }
    if (!is_first) symbol.append(is_divisor ? "/" : ".");
    if (!append_factor(factor, symbol)) return std::nullopt;
    if (factor.size() == name.size()) return symbol;
    name.remove_prefix(factor.size() + 1);
  }
}

}  // namespace geminga::matching
