// The system calls that are left, by seccomp.
#ifndef GEMINGA_ENV_CAGE_SYSTEM_CALLS_HPP
#define GEMINGA_ENV_CAGE_SYSTEM_CALLS_HPP

#include "env/cage/cage.hpp"

namespace geminga::cage {

/// False: this kernel has no seccomp.
bool restrict_system_calls(const Freedom& freedom);

}  // namespace geminga::cage

#endif
