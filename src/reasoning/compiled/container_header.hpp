// The header of a compiled ontology, which is read before the rest.
#ifndef GEMINGA_REASONING_COMPILED_CONTAINER_HEADER_HPP
#define GEMINGA_REASONING_COMPILED_CONTAINER_HEADER_HPP

#include <cstddef>
#include <cstdint>
#include <expected>
#include <span>

#include "reasoning/compiled/compiled_error.hpp"

namespace geminga::compiled {

/// Whether a file of `size` octets that begins with `beginning` can be a compiled ontology. `beginning` is the whole
/// header, or all of a shorter file. Refuses another magic, version or size.
[[nodiscard]] std::expected<void, CompiledError> check_header(std::span<const std::byte> beginning, std::uint64_t size);

}  // namespace geminga::compiled

#endif
