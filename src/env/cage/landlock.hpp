// The files that may be opened, by Landlock (Linux 5.13 and later).
#ifndef GEMINGA_ENV_CAGE_LANDLOCK_HPP
#define GEMINGA_ENV_CAGE_LANDLOCK_HPP

#include <string>

#include "env/cage/cage.hpp"

namespace geminga::cage {

/// The result of restrict_paths().
struct RestrictedPaths {
  bool hold = false;    ///< false: this kernel has no Landlock, or Landlock refused
  std::string fault{};  ///< as in Held
};

/// Also forbids TCP, abstract Unix sockets and signals to other processes where the kernel can; a server may connect to
/// name servers.
RestrictedPaths restrict_paths(const Freedom& freedom);

}  // namespace geminga::cage

#endif
