#include "reasoning/syntax/rdf/triples/passed.hpp"

#include <algorithm>
#include <array>

#include "base/text.hpp"

namespace geminga::rdf {

std::optional<Passed> passed_over(std::string_view message, bool has_collections, std::uint32_t line) {
  constexpr std::array<std::string_view, 4> begins{
      "Property attributes cannot be used with rdf:parseType=",
      "Literal property element '",
      "Property element '",
      "rdf:bagID is forbidden on a literal property element '",
  };
  constexpr std::array<std::string_view, 3> ends{
      " is forbidden as a property element.",
      " is forbidden as a property attribute.",
      " cannot be used with rdf:parseType='Literal'",
  };
  const auto is_begin = [&](std::string_view begin) { return message.starts_with(begin); };
  const auto is_end = [&](std::string_view end) { return message.ends_with(end); };
  if (is_begin("Using an attribute '") || is_begin("Using property attribute '"))
    return Passed{"an attribute without a namespace, passed over", line, true};
  // Raptor names the element around it.
  if (is_begin("Using an element '")) {
    if (has_collections) return std::nullopt;
    return Passed{"an element without a namespace", line};
  }
  if (std::ranges::none_of(begins, is_begin) && std::ranges::none_of(ends, is_end)) return std::nullopt;
  if (message.ends_with('.')) message.remove_suffix(1);
  return Passed{base::printable(message, 200), line};
}

}  // namespace geminga::rdf
