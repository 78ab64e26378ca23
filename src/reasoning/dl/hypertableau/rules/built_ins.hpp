// Evaluates the built-ins of SWRL on values (SWRL, W3C member submission of 21 May 2004, section 8; the functions of
// XQuery 1.0 and XPath 2.0 that it refers to). RULES.md says what each means.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_RULES_BUILT_INS_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_RULES_BUILT_INS_HPP

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "reasoning/dl/clauses/built_in.hpp"
#include "reasoning/dl/hypertableau/values/value.hpp"

namespace geminga::hypertableau {

/// Longer texts are not made and not looked into, and greater exponents are not worked out.
inline constexpr std::size_t max_text_octets = std::size_t{1} << 16;
inline constexpr unsigned max_exponent = 1000;

enum class Holds : std::uint8_t { no, yes, unknown };

/// Whether the built-in holds of these values. Arguments of the wrong kind, and a division by zero, mean that it does
/// not. If an argument that it can bind is missing, it is bound, to nothing where the built-in does not hold.
[[nodiscard]] Holds evaluate(clauses::BuiltIn built_in, std::span<std::optional<Value>> arguments);

}  // namespace geminga::hypertableau

#endif
