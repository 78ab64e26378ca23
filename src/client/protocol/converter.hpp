// The conversions that a program gave, applied to what a match says (src/discovery/matching/CONVERSIONS.md).
#ifndef GEMINGA_CLIENT_PROTOCOL_CONVERTER_HPP
#define GEMINGA_CLIENT_PROTOCOL_CONVERTER_HPP

#include <cstddef>
#include <expected>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geminga/channel.hpp"

namespace geminga::client {

/// The payload after the chain `A>B>C`: the function for `A>C` where there is one, else those for `A>B` and `B>C`. An
/// empty chain changes nothing. The error says what is missing, and who of `via` would do it, or that a function threw.
[[nodiscard]] std::expected<std::vector<std::byte>, std::string> convert(const Conversions& conversions,
                                                                         std::string_view chain,
                                                                         std::span<const std::byte> payload,
                                                                         std::string_view via = {});

}  // namespace geminga::client

#endif
