// Which files may be opened, by Landlock (Linux 5.13 and later).
#ifndef GEMINGA_ENV_CAGE_LANDLOCK_HPP
#define GEMINGA_ENV_CAGE_LANDLOCK_HPP

#include "env/cage/cage.hpp"

namespace geminga::cage {

/// Also forbids TCP, abstract Unix sockets and signals to others where the kernel knows how. False: no Landlock here.
bool restrict_paths(const Freedom& freedom);

}  // namespace geminga::cage

#endif
