// The names of blank nodes, which mean something in their own file only.
#ifndef GEMINGA_REASONING_OWL_BLANK_PREFIX_HPP
#define GEMINGA_REASONING_OWL_BLANK_PREFIX_HPP

#include <string>
#include <string_view>

namespace geminga::owl {

/// What the names of a file's blank nodes begin with. It is made of the file's content, so that it is the same on every
/// host and no other file has it.
[[nodiscard]] std::string blank_prefix_of(std::string_view octets);

}  // namespace geminga::owl

#endif
