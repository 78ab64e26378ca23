// A count as xsd:nonNegativeInteger writes it: the number of a cardinality in XML and in triples.
#ifndef GEMINGA_REASONING_SYNTAX_COUNT_HPP
#define GEMINGA_REASONING_SYNTAX_COUNT_HPP

#include <cstdint>
#include <expected>
#include <string_view>

namespace geminga::syntax {

enum class CountFault : std::uint8_t {
  not_a_count,
  too_great,  ///< above 4294967295
};

/// Reads a count. Blanks around it, leading zeros, a plus, and a minus before zero are allowed (XML Schema 1.1 part 2,
/// 3.4.20.1, with the white space collapsed).
[[nodiscard]] std::expected<std::uint32_t, CountFault> read_count(std::string_view text);

}  // namespace geminga::syntax

#endif
