// The frame around the FlatBuffer of a compiled ontology: magic, version, size and checksum (COMPILED.md).
#ifndef GEMINGA_EL_CONTAINER_HPP
#define GEMINGA_EL_CONTAINER_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <expected>
#include <span>
#include <vector>

#include "el/ontology.hpp"

namespace geminga::el {

inline constexpr std::array<char, 8> compiled_magic = {'G', 'E', 'M', 'I', 'N', 'G', 'A', 'O'};
inline constexpr std::uint32_t compiled_version = 1;
/// FlatBuffers address with 31 bits.
inline constexpr std::size_t max_compiled_bytes = (std::size_t{1} << 31) - 1;
inline constexpr std::size_t container_header_bytes = 32;

/// Puts the header before a payload.
[[nodiscard]] std::vector<std::byte> wrap(std::span<const std::uint8_t> payload);

/// The payload, when magic, version, size and checksum are right.
[[nodiscard]] std::expected<std::span<const std::byte>, CompiledError> unwrap(std::span<const std::byte> file);

}  // namespace geminga::el

#endif
