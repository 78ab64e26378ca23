// The names of blank nodes, which are valid in their own file only.
#ifndef GEMINGA_REASONING_OWL_BLANK_PREFIX_HPP
#define GEMINGA_REASONING_OWL_BLANK_PREFIX_HPP

#include <cstdint>
#include <string>
#include <string_view>

namespace geminga::owl {

/// The prefix of the names of a file's blank nodes. It is made of the file's content, so that it is the same on every
/// host and differs from that of other files.
[[nodiscard]] std::string blank_prefix_of(std::string_view octets);
/// The same where base::hash64() of the content is known.
[[nodiscard]] std::string blank_prefix_of(std::uint64_t hash);

}  // namespace geminga::owl

#endif
