// What a process gives up, for good and for all that it becomes, before it reads what somebody else wrote.
#ifndef GEMINGA_ENV_CAGE_CAGE_HPP
#define GEMINGA_ENV_CAGE_CAGE_HPP

#include <string>
#include <vector>

namespace geminga::cage {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
/// A sanitizer maps its shadow, reads /proc and, looking for leaks at the end, stops its threads by tracing them.
inline constexpr bool is_sanitized = true;
#else
inline constexpr bool is_sanitized = false;
#endif

/// What is still allowed. Everything else is forbidden, because no list of dangers would ever be complete.
struct Freedom {
  /// May become another program, which is then in this cage and may only make it narrower.
  bool may_become = false;
  /// What may be opened for reading, folders with all below them; what does not exist is passed over. Landlock.
  std::vector<std::string> readable;
  /// Nothing: reading is not restricted, for a process that does not know yet what its program needs to start.
  bool may_read_all = false;
  /// Folders in which files may be written, renamed and removed. Where Landlock is missing, any file may then.
  std::vector<std::string> writable_folders;
};

/// What holds from now on.
struct Held {
  bool by_system_calls = false;  ///< seccomp: no sockets, processes, signals, traces, and no file opened for writing
  bool by_paths = false;         ///< Landlock: of files, only those that are named
};

/// Closes the cage: no new privileges, no capabilities but to read and write files as before, Landlock, seccomp. What
/// is forbidden fails with EACCES and does nothing. Not with a signal: a C library that is newer than the list of
/// system calls tries one, and takes another when that fails. Before it the process has one thread.
Held close(const Freedom& freedom);

}  // namespace geminga::cage

#endif
