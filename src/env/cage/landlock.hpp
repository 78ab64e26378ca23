// The files that may be opened, by Landlock (Linux 5.13 and later).
#ifndef GEMINGA_ENV_CAGE_LANDLOCK_HPP
#define GEMINGA_ENV_CAGE_LANDLOCK_HPP

#include "env/cage/cage.hpp"

namespace geminga::cage {

/// Also forbids TCP, abstract Unix sockets and signals to other processes where the kernel can; a server may connect to
/// name servers. False: this kernel has
/// no Landlock.
bool restrict_paths(const Freedom& freedom);

}  // namespace geminga::cage

#endif
