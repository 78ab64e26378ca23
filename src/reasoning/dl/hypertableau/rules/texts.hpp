// Texts of built-ins.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_RULES_TEXTS_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_RULES_TEXTS_HPP

#include <span>

#include "reasoning/dl/clauses/built_in.hpp"
#include "reasoning/dl/hypertableau/rules/arithmetic.hpp"

namespace geminga::hypertableau {

/// The value of a built-in that makes a text, or a length, of these operands.
[[nodiscard]] Computed make_text(clauses::BuiltIn built_in, std::span<const Value> operands);
/// Whether a built-in that looks at two texts holds of them. Case is known of ASCII letters only.
[[nodiscard]] Holds compare_texts(clauses::BuiltIn built_in, const Value& first, const Value& second);
/// A text without its language; empty for other values.
[[nodiscard]] std::string_view text_of(const Value& value);

}  // namespace geminga::hypertableau

#endif
