// The size of numbers in protobuf's wire format.
#ifndef GEMINGA_DISCOVERY_ANNOUNCEMENT_VARINT_HPP
#define GEMINGA_DISCOVERY_ANNOUNCEMENT_VARINT_HPP

#include <cstddef>
#include <cstdint>

namespace geminga::announcement {

/// The octets of a number as a varint, seven bits each (https://protobuf.dev/programming-guides/encoding).
[[nodiscard]] constexpr std::size_t varint_bytes(std::uint64_t value) {
  std::size_t bytes = 1;
  while ((value >>= 7U) != 0) ++bytes;
  return bytes;
}

}  // namespace geminga::announcement

#endif
