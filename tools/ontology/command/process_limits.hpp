// Limits of the whole process: its memory, and the time after which it ends itself.
#ifndef GEMINGA_ONTOLOGY_COMMAND_PROCESS_LIMITS_HPP
#define GEMINGA_ONTOLOGY_COMMAND_PROCESS_LIMITS_HPP

namespace geminga::ontology {

/// Limits the address space of this process; 0: no limit.
void limit_memory(unsigned mebibytes);
/// Ends this process with Exit::timed_out and a line on standard error when it still runs a quarter longer than this,
/// and a second; 0: never. Searches end in time by themselves (work_limits.hpp) and keep what they have found.
void limit_time(unsigned seconds);

}  // namespace geminga::ontology

#endif
