// Reads and writes the frame. Numbers are little-endian.
#include "reasoning/compiled/container.hpp"

// The library uses the widest vectors of the processor, which halves the time of a start.
#if defined(__x86_64__)
#include <xxh_x86dispatch.h>
#else
#endif

#include <algorithm>
#include <cstring>
#include <string>

#include "base/hash.hpp"
#include "reasoning/compiled/container_header.hpp"

namespace geminga::compiled {
namespace {

constexpr std::size_t version_at = 8;
constexpr std::size_t count_at = 12;
constexpr std::size_t table_at = 16;  // of each section its size and its checksum

constexpr std::size_t size_at(std::size_t section) { return table_at + section * 16; }
constexpr std::size_t checksum_at(std::size_t section) { return size_at(section) + 8; }

template <typename Number>
void put(std::span<std::byte> bytes, std::size_t at, Number number) {
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

/// The seed of the first section's checksum is the header without that checksum. So the first section's checksum covers
/// the header, and the header holds those of the others.
std::uint64_t checksum(std::span<const std::byte> header, std::size_t section, std::span<const std::byte> content) {
  std::uint64_t seed = content.size();
  if (section == 0) {
    std::array<std::byte, container_header_bytes> rest{};
    std::ranges::copy(header.first(container_header_bytes), rest.begin());
    put(rest, checksum_at(0), std::uint64_t{0});
    seed = base::hash64(base::octets_of(std::span(rest)));
  }
  return base::hash64(base::octets_of(content), seed);
}

std::size_t filled_up(std::size_t size) {
  return (size + section_alignment - 1) / section_alignment * section_alignment;
}

std::unexpected<CompiledError> refused(std::string text) { return std::unexpected(CompiledError{std::move(text)}); }

}  // namespace

std::string_view to_string(Section section) {
  switch (section) {
    case Section::taxonomy:
      return "taxonomy";
    case Section::labels:
      return "labels";
    case Section::axioms:
      return "axioms";
  }
  return "section";
}

std::vector<std::byte> wrap(const std::array<std::span<const std::uint8_t>, section_count>& sections) {
  std::size_t size = container_header_bytes;
  for (const auto& section : sections) size += filled_up(section.size());
  std::vector<std::byte> bytes(size);
  std::memcpy(bytes.data(), compiled_magic.data(), compiled_magic.size());
  put(bytes, version_at, compiled_version);
  put(bytes, count_at, static_cast<std::uint32_t>(section_count));
  std::size_t begin = container_header_bytes;
  for (std::size_t at = 0; at < section_count; ++at) {
    if (!sections[at].empty()) std::memcpy(bytes.data() + begin, sections[at].data(), sections[at].size());
    put(bytes, size_at(at), static_cast<std::uint64_t>(filled_up(sections[at].size())));
    begin += filled_up(sections[at].size());
  }
  seal(bytes);
  return bytes;
}

// The first section comes last, because its checksum covers those of the others.
void seal(std::span<std::byte> file) {
  std::size_t end = file.size();
  for (std::size_t at = section_count; at-- > 0;) {
    const auto size = static_cast<std::size_t>(get<std::uint64_t>(file, size_at(at)));
    end -= size;
    put(file, checksum_at(at), checksum(file, at, file.subspan(end, size)));
  }
}

std::expected<void, CompiledError> check_header(std::span<const std::byte> beginning, std::uint64_t size) {
  if (beginning.size() < compiled_magic.size() + sizeof(std::uint32_t)) {
    return refused("not a compiled ontology: " + std::to_string(size) + " bytes are less than its header");
  }
  if (size > max_compiled_bytes) {
    return refused("the compiled ontology is over the limit of " + std::to_string(max_compiled_bytes) + " bytes");
  }
  if (std::memcmp(beginning.data(), compiled_magic.data(), compiled_magic.size()) != 0) {
    return refused("not a compiled ontology: the magic at offset 0 is wrong");
  }
  const auto version = get<std::uint32_t>(beginning, version_at);
  if (version != compiled_version) {
    return refused("the compiled ontology has version " + std::to_string(version) + ", this program reads " +
                   std::to_string(compiled_version) + ": compile it again");
  }
  if (beginning.size() < container_header_bytes) {
    return refused("the compiled ontology is damaged: " + std::to_string(size) + " bytes are less than its header of " +
                   std::to_string(container_header_bytes));
  }
  if (get<std::uint32_t>(beginning, count_at) != section_count) {
    return refused("the compiled ontology is damaged: the number of sections at offset 12 is wrong");
  }
  std::uint64_t rest = size - container_header_bytes;
  for (std::size_t at = 0; at < section_count; ++at) {
    const auto section = get<std::uint64_t>(beginning, size_at(at));
    if (section > rest || section % section_alignment != 0 || (at + 1 == section_count && section != rest)) {
      return refused("the compiled ontology is damaged: its header at offset " + std::to_string(size_at(at)) +
                     " promises " + std::to_string(section) + " bytes, and there are " + std::to_string(rest));
    }
    rest -= section;
  }
  return {};
}

std::expected<Container, CompiledError> Container::open(std::span<const std::byte> file) {
  if (auto looked = check_header(file.first(std::min(file.size(), container_header_bytes)), file.size()); !looked)
    return std::unexpected(looked.error());
  Container container;
  container.file_ = file;
  std::span<const std::byte> rest = file.subspan(container_header_bytes);
  for (std::size_t at = 0; at < section_count; ++at) {
    const auto size = static_cast<std::size_t>(get<std::uint64_t>(file, size_at(at)));
    container.sections_[at] = rest.first(size);
    rest = rest.subspan(size);
  }
  if (auto whole = container.verify(Section::taxonomy); !whole) return std::unexpected(whole.error());
  return container;
}

std::expected<void, CompiledError> Container::verify(Section which) const {
  const auto at = static_cast<std::size_t>(which);
  if (get<std::uint64_t>(file_, checksum_at(at)) == checksum(file_, at, sections_[at])) return {};
  const auto begin = static_cast<std::size_t>(sections_[at].data() - file_.data());
  return refused("the compiled ontology is damaged: the checksum at offset " + std::to_string(checksum_at(at)) +
                 " is not that of the " + std::string(to_string(which)) + " at offset " + std::to_string(begin) +
                 ": compile it again");
}

}  // namespace geminga::compiled
