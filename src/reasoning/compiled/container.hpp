// The frame around the sections of a compiled ontology: magic, version, sizes and checksums (COMPILED.md).
#ifndef GEMINGA_REASONING_COMPILED_CONTAINER_HPP
#define GEMINGA_REASONING_COMPILED_CONTAINER_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <expected>
#include <span>
#include <string_view>
#include <vector>

#include "reasoning/compiled/compiled_error.hpp"

namespace geminga::compiled {

inline constexpr std::array<char, 8> compiled_magic = {'G', 'E', 'M', 'I', 'N', 'G', 'A', 'O'};
inline constexpr std::uint32_t compiled_version = 2;
/// FlatBuffers address with 31 bits.
inline constexpr std::size_t max_compiled_bytes = (std::size_t{1} << 31) - 1;

/// The parts of a file that are verified by themselves: the first when the file is mapped, each other one when it is
/// first asked for.
enum class Section : std::uint8_t { taxonomy = 0, labels = 1, axioms = 2 };
inline constexpr std::size_t section_count = 3;
inline constexpr std::size_t container_header_bytes = 16 + section_count * 16;
/// Sections are padded to a multiple of it, so that their numbers are aligned in a mapped file.
inline constexpr std::size_t section_alignment = 8;

/// The name of the section in error messages.
[[nodiscard]] std::string_view to_string(Section section);

/// Puts the header in front of the sections, which keep their order.
[[nodiscard]] std::vector<std::byte> wrap(const std::array<std::span<const std::uint8_t>, section_count>& sections);

/// Writes the checksums of the sections into the header of a file whose sizes are right.
void seal(std::span<std::byte> file);

/// A file whose header is right and whose first section is as it was written. It borrows the octets, which must be
/// aligned to 8.
class Container {
 public:
  /// Refuses another magic, version or size, and a damaged header or first section. Cost: a pass over the first
  /// section.
  [[nodiscard]] static std::expected<Container, CompiledError> open(std::span<const std::byte> file);

  [[nodiscard]] std::span<const std::byte> file() const { return file_; }
  /// A section as it stands in the file. Only the first one has been compared with its checksum.
  [[nodiscard]] std::span<const std::byte> section(Section which) const {
    return sections_[static_cast<std::size_t>(which)];
  }
  /// Compares a section with its checksum. Cost: a pass over the section.
  [[nodiscard]] std::expected<void, CompiledError> verify(Section which) const;

 private:
  std::span<const std::byte> file_;
  std::array<std::span<const std::byte>, section_count> sections_;
};

}  // namespace geminga::compiled

#endif
