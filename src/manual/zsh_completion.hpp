// A program's completion for zsh.
#ifndef GEMINGA_MANUAL_ZSH_COMPLETION_HPP
#define GEMINGA_MANUAL_ZSH_COMPLETION_HPP

#include <string>

#include "manual/outline.hpp"

namespace geminga::manual {

/// A file for share/zsh/site-functions, which completes as the one for bash and shows the meaning of each flag.
[[nodiscard]] std::string zsh_completion(const Outline& program);

}  // namespace geminga::manual

#endif
