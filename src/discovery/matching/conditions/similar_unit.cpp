#include "discovery/matching/conditions/similar_unit.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "base/text.hpp"
#include "discovery/matching/conditions/unit.hpp"

namespace geminga::matching {
namespace {

using Written = std::pair<std::string_view, std::string_view>;

constexpr auto written_out = std::to_array<Written>(
    {{"metre", "m"},    {"meter", "m"},  {"gram", "g"},       {"gramme", "g"},  {"second", "s"},   {"sec", "s"},
     {"minute", "min"}, {"hour", "h"},   {"hr", "h"},         {"day", "d"},     {"degree", "deg"}, {"radian", "rad"},
     {"hertz", "Hz"},   {"newton", "N"}, {"joule", "J"},      {"watt", "W"},    {"volt", "V"},     {"ampere", "A"},
     {"amp", "A"},      {"kelvin", "K"}, {"celsius", "degC"}, {"pascal", "Pa"}, {"litre", "l"},    {"liter", "l"},
     {"tonne", "t"},    {"ton", "t"},    {"pound", "lb"},     {"percent", "%"}, {"inch", "in"},    {"inche", "in"},
     {"foot", "ft"},    {"feet", "ft"},  {"mile", "mi"},      {"knot", "kn"},   {"byte", "B"},     {"ohm", "Ohm"},
     {"decibel", "dB"}, {"lumen", "lm"}, {"bit", "bit"}});

constexpr auto written_prefixes = std::to_array<Written>({{"kilo", "k"},
                                                          {"milli", "m"},
                                                          {"centi", "c"},
                                                          {"micro", "u"},
                                                          {"mega", "M"},
                                                          {"giga", "G"},
                                                          {"nano", "n"},
                                                          {"deci", "d"}});

/// The symbol of a name in lower case, in the singular; empty where it is none.
std::string_view symbol_of_written(std::string_view name) {
  const auto* const found = std::ranges::find(written_out, name, &Written::first);
  return found == written_out.end() ? std::string_view() : found->second;
}

std::string of_written_name(std::string_view name) {
  if (name.ends_with('s') && name.size() > 3) name.remove_suffix(1);
  if (const std::string_view symbol = symbol_of_written(name); !symbol.empty()) return std::string(symbol);
  for (const auto& [prefix, sign] : written_prefixes) {
    if (!name.starts_with(prefix)) continue;
    const std::string symbol(symbol_of_written(name.substr(prefix.size())));
    if (!symbol.empty() && unit(std::string(sign) + symbol)) return std::string(sign) + symbol;
  }
  return {};
}

/// The unit that differs in the case of the fewest letters; of several the first.
std::string in_another_case(std::string_view text) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  if (text.size() > max_tried_letters || !std::ranges::all_of(text, is_letter)) return {};
  std::string found;
  std::size_t fewest = text.size() + 1;
  for (unsigned changed = 1; changed < 1U << text.size(); ++changed) {
    std::string tried(text);
    std::size_t count = 0;
    for (std::size_t at = 0; at < tried.size(); ++at) {
      if ((changed >> at & 1U) == 0) continue;
      tried[at] = static_cast<char>(tried[at] ^ 0x20);
      ++count;
    }
    if (count >= fewest || !unit(tried)) continue;
    fewest = count;
    found = tried;
  }
  return found;
}

}  // namespace

std::string similar_unit(std::string_view text) {
  std::string found = of_written_name(base::in_lower_case(text));
  return found.empty() ? in_another_case(text) : found;
}

}  // namespace geminga::matching
