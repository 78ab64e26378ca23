// Functions of SPARQL that make and compare texts (SPARQL 1.1 Query Language, section 17.4.3).
#ifndef GEMINGA_REASONING_SYNTAX_GRAPH_FORMULAS_TEXT_FUNCTIONS_HPP
#define GEMINGA_REASONING_SYNTAX_GRAPH_FORMULAS_TEXT_FUNCTIONS_HPP

#include <string>
#include <string_view>
#include <vector>

#include "reasoning/syntax/graph/formulas/scalars.hpp"
#include "reasoning/syntax/graph/terms/world.hpp"

namespace geminga::graph {

/// Whether a value is a text, with or without a language.
[[nodiscard]] bool is_string(const Scalar& value);

/// SUBSTR, REGEX, REPLACE and CONCAT, by their arguments; nothing for an error.
[[nodiscard]] Scalar part_of(const std::vector<Scalar>& given);
[[nodiscard]] Scalar matches(const std::vector<Scalar>& given);
[[nodiscard]] Scalar replaced(const std::vector<Scalar>& given);
[[nodiscard]] Scalar joined(const std::vector<Scalar>& given);
/// A text in the other case; nothing where it has a letter whose case is not known here: beyond Latin-1.
[[nodiscard]] Scalar text_in_case(const Scalar& value, bool is_upper);
/// STRSTARTS, STRENDS, CONTAINS, STRBEFORE or STRAFTER.
[[nodiscard]] Scalar compare_texts(rasqal_op op, const Scalar& first, const Scalar& second);
/// A text with % and two digits for each octet that a part of an IRI may not have.
[[nodiscard]] std::string for_uri(std::string_view value);

}  // namespace geminga::graph

#endif
