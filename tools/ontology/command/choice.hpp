// The command that the command line chose, with what main() must know before it closes the cage.
#ifndef GEMINGA_ONTOLOGY_COMMAND_CHOICE_HPP
#define GEMINGA_ONTOLOGY_COMMAND_CHOICE_HPP

#include <functional>
#include <string>
#include <vector>

#include "ontology/command/exit_status.hpp"
#include "ontology/command/limits.hpp"

namespace geminga::ontology {

/// Filled in by the chosen command when the whole command line has been read.
struct Choice {
  std::function<Exit()> run;
  /// Work that the cage would forbid, e.g. starting another program; Exit::yes: run() follows. Empty: none.
  std::function<Exit()> prepare;
  std::vector<std::string> outputs;   ///< files that it writes
  std::vector<std::string> readable;  ///< files and folders that it reads beside those on the command line
  bool may_talk = false;              ///< it talks to the daemon and to providers or consumers
  bool may_make_folders = false;      ///< beside its outputs
  unsigned memory_limit_mib = 0;      ///< 0: no limit
  WorkLimits limits;
};

}  // namespace geminga::ontology

#endif
