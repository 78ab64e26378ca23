// What this program forbids itself before it reads a file that somebody else wrote.
#ifndef GEMINGA_ONTOLOGY_SANDBOX_HPP
#define GEMINGA_ONTOLOGY_SANDBOX_HPP

namespace geminga::ontology {

/// AddressSanitizer looks for leaks at the end of a process by tracing it, so a build with it may trace.
#ifdef __SANITIZE_ADDRESS__
inline constexpr bool may_trace = true;
#else
inline constexpr bool may_trace = false;
#endif

/// From now on sockets, traces of other processes and, unless `may_execute`, other programs fail with EACCES, in this
/// process and its children. Where the kernel has no seccomp nothing is forbidden; Redland is still told to open
/// nothing.
void forbid_the_world(bool may_execute);

/// Limits the address space of this process; 0: not at all.
void limit_memory(unsigned mebibytes);
/// Limits its processor time: then it says so on standard error and exits with Exit::timed_out. 0: not at all.
void limit_time(unsigned seconds);

}  // namespace geminga::ontology

#endif
