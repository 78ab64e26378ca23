// Numbers in network byte order.
#ifndef GEMINGA_CLIENT_PROTOCOL_OCTETS_HPP
#define GEMINGA_CLIENT_PROTOCOL_OCTETS_HPP

#include <cstddef>
#include <cstdint>

namespace geminga::client {

/// Writes sizeof(Number) octets.
template <typename Number>
void write_number(std::byte* to, Number number) {
  for (std::size_t i = 0; i < sizeof(Number); ++i) {
    to[i] = static_cast<std::byte>(number >> (8 * (sizeof(Number) - 1 - i)));
  }
}

/// Reads sizeof(Number) octets.
template <typename Number>
[[nodiscard]] Number read_number(const std::byte* from) {
  Number number = 0;
  for (std::size_t i = 0; i < sizeof(Number); ++i) {
    number = static_cast<Number>((std::uint64_t{number} << 8) | std::to_integer<std::uint64_t>(from[i]));
  }
  return number;
}

}  // namespace geminga::client

#endif
