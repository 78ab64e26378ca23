// The table of built-ins, in the order of the enumeration.
#include "reasoning/dl/clauses/built_in.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace geminga::clauses {
namespace {

constexpr std::string_view swrlb = "http://www.w3.org/2003/11/swrlb#";

constexpr std::array<std::pair<std::string_view, BuiltInForm>, 40> built_ins{{
    {"equal", {BuiltIn::equal, 2, 2, true}},
    {"notEqual", {BuiltIn::not_equal, 2, 2, false}},
    {"lessThan", {BuiltIn::less_than, 2, 2, false}},
    {"lessThanOrEqual", {BuiltIn::less_than_or_equal, 2, 2, false}},
    {"greaterThan", {BuiltIn::greater_than, 2, 2, false}},
    {"greaterThanOrEqual", {BuiltIn::greater_than_or_equal, 2, 2, false}},
    {"add", {BuiltIn::add, 3, many_arguments, true}},
    {"subtract", {BuiltIn::subtract, 3, 3, true}},
    {"multiply", {BuiltIn::multiply, 3, many_arguments, true}},
    {"divide", {BuiltIn::divide, 3, 3, true}},
    {"integerDivide", {BuiltIn::integer_divide, 3, 3, true}},
    {"mod", {BuiltIn::mod, 3, 3, true}},
    {"pow", {BuiltIn::pow, 3, 3, true}},
    {"unaryPlus", {BuiltIn::unary_plus, 2, 2, true}},
    {"unaryMinus", {BuiltIn::unary_minus, 2, 2, true}},
    {"abs", {BuiltIn::abs, 2, 2, true}},
    {"ceiling", {BuiltIn::ceiling, 2, 2, true}},
    {"floor", {BuiltIn::floor, 2, 2, true}},
    {"round", {BuiltIn::round, 2, 2, true}},
    {"roundHalfToEven", {BuiltIn::round_half_to_even, 2, 3, true}},
    {"sin", {BuiltIn::sin, 2, 2, true}},
    {"cos", {BuiltIn::cos, 2, 2, true}},
    {"tan", {BuiltIn::tan, 2, 2, true}},
    {"booleanNot", {BuiltIn::boolean_not, 2, 2, true}},
    {"stringEqualIgnoreCase", {BuiltIn::string_equal_ignore_case, 2, 2, false}},
    {"stringConcat", {BuiltIn::string_concat, 2, many_arguments, true}},
    {"substring", {BuiltIn::substring, 3, 4, true}},
    {"stringLength", {BuiltIn::string_length, 2, 2, true}},
    {"normalizeSpace", {BuiltIn::normalize_space, 2, 2, true}},
    {"upperCase", {BuiltIn::upper_case, 2, 2, true}},
    {"lowerCase", {BuiltIn::lower_case, 2, 2, true}},
    {"contains", {BuiltIn::contains, 2, 2, false}},
    {"containsIgnoreCase", {BuiltIn::contains_ignore_case, 2, 2, false}},
    {"startsWith", {BuiltIn::starts_with, 2, 2, false}},
    {"endsWith", {BuiltIn::ends_with, 2, 2, false}},
    {"substringBefore", {BuiltIn::substring_before, 3, 3, true}},
    {"substringAfter", {BuiltIn::substring_after, 3, 3, true}},
    {"matches", {BuiltIn::matches, 2, 2, false}},
    {"translate", {BuiltIn::translate, 4, 4, true}},
    {"replace", {BuiltIn::replace, 4, 4, true}},
}};

static_assert([] {
  for (std::size_t at = 0; at < built_ins.size(); ++at) {
    if (static_cast<std::size_t>(built_ins[at].second.built_in) != at) return false;
  }
  return true;
}());

}  // namespace

std::optional<BuiltInForm> find_built_in(std::string_view iri) {
  if (!iri.starts_with(swrlb)) return std::nullopt;
  const auto* const found =
      std::ranges::find(built_ins, iri.substr(swrlb.size()), &std::pair<std::string_view, BuiltInForm>::first);
  if (found == built_ins.end()) return std::nullopt;
  return found->second;
}

BuiltInForm form_of(BuiltIn built_in) { return built_ins[static_cast<std::size_t>(built_in)].second; }

}  // namespace geminga::clauses
