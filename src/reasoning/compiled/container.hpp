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

/// What is verified by itself: the first when a file is mapped, each of the others when it is asked for first.
enum class Section : std::uint8_t { taxonomy = 0, labels = 1, axioms = 2 };
inline constexpr std::size_t section_count = 3;
inline constexpr std::size_t container_header_bytes = 16 + section_count * 16;
/// Sections are filled up to a multiple of it, so that their numbers are aligned in a mapped file.
inline constexpr std::size_t section_alignment = 8;

/// What errors call it.
[[nodiscard]] std::string_view to_string(Section section);

/// Puts the header before sections, in their order.
[[nodiscard]] std::vector<std::byte> wrap(const std::array<std::span<const std::uint8_t>, section_count>& sections);

/// Puts the checksums of its sections into the header of a file that has a header with right sizes.
void seal(std::span<std::byte> file);

/// A file whose header is right and whose first section is as it was written. The bytes are borrowed and must be
/// aligned to 8.
class Container {
 public:
  /// Refuses what has another magic, version or size, or a damaged header or first section. Cost: a pass over that.
  [[nodiscard]] static std::expected<Container, CompiledError> open(std::span<const std::byte> file);

  [[nodiscard]] std::span<const std::byte> file() const { return file_; }
  /// As it stands in the file: only the first has been compared with its checksum.
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
