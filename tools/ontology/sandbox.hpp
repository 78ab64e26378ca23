// How much memory and time this program may take.
#ifndef GEMINGA_ONTOLOGY_SANDBOX_HPP
#define GEMINGA_ONTOLOGY_SANDBOX_HPP

namespace geminga::ontology {

/// Limits the address space of this process; 0: not at all.
void limit_memory(unsigned mebibytes);
/// Ends it where it still runs a quarter longer than this (and a second): it says so on standard error and exits with
/// Exit::timed_out. Searches end in time by themselves (limits.hpp) and keep what they have found. 0: not at all.
void limit_time(unsigned seconds);

}  // namespace geminga::ontology

#endif
