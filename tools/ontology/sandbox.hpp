// How much memory and time this program may take.
#ifndef GEMINGA_ONTOLOGY_SANDBOX_HPP
#define GEMINGA_ONTOLOGY_SANDBOX_HPP

namespace geminga::ontology {

/// Limits the address space of this process; 0: not at all.
void limit_memory(unsigned mebibytes);
/// Limits its processor time: then it says so on standard error and exits with Exit::timed_out. 0: not at all.
void limit_time(unsigned seconds);

}  // namespace geminga::ontology

#endif
