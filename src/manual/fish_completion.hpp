// A program's completion for fish.
#ifndef GEMINGA_MANUAL_FISH_COMPLETION_HPP
#define GEMINGA_MANUAL_FISH_COMPLETION_HPP

#include <string>

#include "manual/outline.hpp"

namespace geminga::manual {

/// A file for share/fish/vendor_completions.d: commands, flags and their values, with what each of them means.
[[nodiscard]] std::string fish_completion(const Outline& program);

}  // namespace geminga::manual

#endif
