// Answers of the agent about identities, frames and lines, as the library reads and writes them.
#ifndef GEMINGA_TESTS_CLIENT_CPP_AGENT_ANSWERS_HPP
#define GEMINGA_TESTS_CLIENT_CPP_AGENT_ANSWERS_HPP

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace geminga::agent {

using Bytes = std::vector<std::byte>;

/// Takes the next word, which may be quoted as in GCNP, and the spaces behind it; without quotes and escapes.
[[nodiscard]] std::string next_word(std::string_view& text);
/// The number that a text is in decimal; 0 where it is none.
[[nodiscard]] std::uint64_t number(std::string_view text);
[[nodiscard]] std::string to_hex(std::span<const std::byte> bytes);
[[nodiscard]] std::optional<Bytes> from_hex(std::string_view text);

[[nodiscard]] std::string identity_answer(std::string_view words);
[[nodiscard]] std::string frame_answer(std::string_view hex);
[[nodiscard]] std::string line_answer(std::string_view line);

}  // namespace geminga::agent

#endif
