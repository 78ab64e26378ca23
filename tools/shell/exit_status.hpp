// The exit statuses, the same in every program.
#ifndef GEMINGA_SHELL_EXIT_STATUS_HPP
#define GEMINGA_SHELL_EXIT_STATUS_HPP

namespace geminga::shell {

enum class ExitStatus : int {
  found = 0,      ///< done, or found
  nothing = 1,    ///< nothing found, or the answer is no
  wrong_use = 2,  ///< wrong usage: an unknown flag, a name that the ontology does not know
  no_daemon = 3,  ///< the daemon cannot be reached, or went away
  timed_out = 4,
};

}  // namespace geminga::shell

#endif
