// The built-ins of SWRL that rules may use (SWRL, W3C member submission of 21 May 2004, section 8).
#ifndef GEMINGA_REASONING_DL_CLAUSES_BUILT_IN_HPP
#define GEMINGA_REASONING_DL_CLAUSES_BUILT_IN_HPP

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace geminga::clauses {

enum class BuiltIn : std::uint8_t {
  equal,
  not_equal,
  less_than,
  less_than_or_equal,
  greater_than,
  greater_than_or_equal,
  add,
  subtract,
  multiply,
  divide,
  integer_divide,
  mod,
  pow,
  unary_plus,
  unary_minus,
  abs,
  ceiling,
  floor,
  round,
  round_half_to_even,
  sin,
  cos,
  tan,
  boolean_not,
  string_equal_ignore_case,
  string_concat,
  substring,
  string_length,
  normalize_space,
  upper_case,
  lower_case,
  contains,
  contains_ignore_case,
  starts_with,
  ends_with,
  substring_before,
  substring_after,
  matches,
  translate,
  replace,
};

/// The arguments of a built-in.
struct BuiltInForm {
  BuiltIn built_in{};
  std::uint8_t least = 2;
  std::uint8_t most = 2;     ///< many_arguments: no limit
  bool binds_first = false;  ///< its first argument follows from the others
};
inline constexpr std::uint8_t many_arguments = 255;

/// The built-in with this IRI; nothing where there is none, or where it is not known here.
[[nodiscard]] std::optional<BuiltInForm> find_built_in(std::string_view iri);
[[nodiscard]] BuiltInForm form_of(BuiltIn built_in);

}  // namespace geminga::clauses

#endif
