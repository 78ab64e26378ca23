// The program's conversions, applied along the chain of a match (CONVERSIONS.md).
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

/// The payload after the chain `A>B>C`: by the function for `A>C` if there is one, else by those for `A>B` and `B>C`.
/// An empty chain changes nothing. The error names a conversion that has no function, with the service of `via` that
/// does it, or one that threw.
[[nodiscard]] std::expected<std::vector<std::byte>, std::string> convert(const Conversions& conversions,
                                                                         std::string_view chain,
                                                                         std::span<const std::byte> payload,
                                                                         std::string_view via = {});

}  // namespace geminga::client

#endif
