// A program's completion for bash.
#ifndef GEMINGA_MANUAL_BASH_COMPLETION_HPP
#define GEMINGA_MANUAL_BASH_COMPLETION_HPP

#include <string>

#include "manual/outline.hpp"

namespace geminga::manual {

/// A file for share/bash-completion/completions, which needs nothing but bash: commands, flags, the values of those
/// that take one of a few words, and files.
[[nodiscard]] std::string bash_completion(const Outline& program);

}  // namespace geminga::manual

#endif
