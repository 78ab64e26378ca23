// Reading and writing of the frame. Numbers are little-endian.
#include "el/container.hpp"

#include <xxhash.h>

#include <algorithm>
#include <cstring>
#include <string>

namespace geminga::el {
namespace {

constexpr std::size_t version_at = 8;
constexpr std::size_t reserved_at = 12;
constexpr std::size_t size_at = 16;
constexpr std::size_t checksum_at = 24;

template <typename Number>
void put(std::vector<std::byte>& bytes, std::size_t at, Number number) {
  for (std::size_t octet = 0; octet < sizeof number; ++octet) {
    bytes[at + octet] = static_cast<std::byte>(number >> (8 * octet) & 0xff);
  }
}

template <typename Number>
Number get(std::span<const std::byte> bytes, std::size_t at) {
  Number number = 0;
  for (std::size_t octet = 0; octet < sizeof number; ++octet) {
    number |= static_cast<Number>(static_cast<Number>(bytes[at + octet]) << (8 * octet));
  }
  return number;
}

/// Over the payload and its size, so that no header field is without a check.
std::uint64_t checksum(std::span<const std::byte> payload) {
  return XXH3_64bits_withSeed(payload.data(), payload.size(), payload.size());
}

std::unexpected<CompiledError> refused(std::string text) { return std::unexpected(CompiledError{std::move(text)}); }

}  // namespace

std::vector<std::byte> wrap(std::span<const std::uint8_t> payload) {
  std::vector<std::byte> bytes(container_header_bytes + payload.size());
  std::memcpy(bytes.data(), compiled_magic.data(), compiled_magic.size());
  put(bytes, version_at, compiled_version);
  put(bytes, reserved_at, std::uint32_t{0});
  put(bytes, size_at, static_cast<std::uint64_t>(payload.size()));
  if (!payload.empty()) std::memcpy(bytes.data() + container_header_bytes, payload.data(), payload.size());
  put(bytes, checksum_at, checksum(std::span(bytes).subspan(container_header_bytes)));
  return bytes;
}

std::expected<std::span<const std::byte>, CompiledError> unwrap(std::span<const std::byte> file) {
  if (file.size() < container_header_bytes) {
    return refused("not a compiled ontology: " + std::to_string(file.size()) + " bytes are less than its header");
  }
  if (file.size() > max_compiled_bytes) {
    return refused("the compiled ontology is over the limit of " + std::to_string(max_compiled_bytes) + " bytes");
  }
  if (std::memcmp(file.data(), compiled_magic.data(), compiled_magic.size()) != 0) {
    return refused("not a compiled ontology: the magic at offset 0 is wrong");
  }
  const auto version = get<std::uint32_t>(file, version_at);
  if (version != compiled_version) {
    return refused("the compiled ontology has version " + std::to_string(version) + ", this program reads " +
                   std::to_string(compiled_version) + ": compile it again");
  }
  if (get<std::uint32_t>(file, reserved_at) != 0) return refused("the compiled ontology is damaged at offset 12");
  const auto size = get<std::uint64_t>(file, size_at);
  const std::span<const std::byte> payload = file.subspan(container_header_bytes);
  if (size != payload.size()) {
    return refused("the compiled ontology is damaged: its header at offset 16 promises " + std::to_string(size) +
                   " bytes, the file has " + std::to_string(payload.size()));
  }
  if (get<std::uint64_t>(file, checksum_at) != checksum(payload)) {
    return refused("the compiled ontology is damaged: its checksum at offset 24 is wrong");
  }
  return payload;
}

}  // namespace geminga::el
