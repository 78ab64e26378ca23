#include "discovery/gcnp/life.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <string>

#include "base/text.hpp"

namespace geminga {

std::string to_string(Life life) { return base::to_hex(static_cast<std::uint64_t>(life), 16); }

}  // namespace geminga

namespace geminga::gcnp {

std::optional<Life> read_life(std::string_view text) {
  const auto is_digit = [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); };
  if (text.size() != 16 || !std::ranges::all_of(text, is_digit)) return std::nullopt;
  std::uint64_t bits = 0;
  std::from_chars(text.data(), text.data() + text.size(), bits, 16);
  return bits == 0 ? std::nullopt : std::optional(Life{bits});
}

Life stated_life(const Attributes& attributes) {
  const auto found = attributes.find(channel_attribute);
  return found == attributes.end() ? no_life : read_life(found->second).value_or(no_life);
}

}  // namespace geminga::gcnp
