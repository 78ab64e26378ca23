// The system calls that are left, by seccomp.
#ifndef GEMINGA_ENV_CAGE_SYSTEM_CALLS_HPP
#define GEMINGA_ENV_CAGE_SYSTEM_CALLS_HPP

#include "env/cage/cage.hpp"

namespace geminga::cage {

/// False: this kernel has no seccomp.
bool restrict_system_calls(const Freedom& freedom);

/// The processors of robots and of the machines on which they are programmed.
enum class Processor { x86_64, aarch64 };

/// Writes the filter that restrict_system_calls() loads on such a processor into an open file: instructions of classic
/// BPF, each a `sock_filter` (seccomp(2)). So the filter of a robot is read and tested on another machine, whose
/// emulator has no seccomp. False: the file cannot be written.
bool write_filter(const Freedom& freedom, Processor processor, int file);

}  // namespace geminga::cage

#endif
