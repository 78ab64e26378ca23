// The exit statuses of geminga-ontology.
#ifndef GEMINGA_ONTOLOGY_COMMAND_EXIT_STATUS_HPP
#define GEMINGA_ONTOLOGY_COMMAND_EXIT_STATUS_HPP

namespace geminga::ontology {

/// The exit statuses of the contract.
enum class Exit : int {
  yes = 0,          ///< done, or found
  no = 1,           ///< the answer is no, or there is a problem
  usage = 2,        ///< wrong usage, or a file that cannot be loaded
  unreachable = 3,  ///< there is no daemon
  timed_out = 4,    ///< a limit was reached
};

}  // namespace geminga::ontology

#endif
