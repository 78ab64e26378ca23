// The cage of a process: rights that it and its successors give up for good before it reads what strangers wrote.
#ifndef GEMINGA_ENV_CAGE_CAGE_HPP
#define GEMINGA_ENV_CAGE_CAGE_HPP

#include <string>
#include <vector>

namespace geminga::cage {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
/// A sanitizer maps its shadow, reads /proc, and stops its threads by tracing them when it looks for leaks at the end.
inline constexpr bool is_sanitized = true;
#else
inline constexpr bool is_sanitized = false;
#endif

/// The freedom that is left. Everything else is forbidden, because no list of dangers would ever be complete.
struct Freedom {
  /// Allows to become another program, which is then in this cage and can only make it narrower.
  bool may_become = false;
  /// The files that may be opened for reading, and folders with all below them. A path that does not exist, or leads
  /// nowhere, is passed over. Landlock.
  std::vector<std::string> readable;
  /// Does not restrict reading: for a process that does not know yet what its program needs to start.
  bool may_read_all = false;
  /// Folders in which files may be written, renamed and removed. Without Landlock any file may be, if there is such a
  /// folder.
  std::vector<std::string> writable_folders;
  /// Folders may also be made, renamed and removed in them.
  bool may_make_folders = false;
  /// Allows sockets of the network and of this host as a server has them, and no processes. Of ports Landlock forbids
  /// none then: a provider may be at any.
  bool may_talk = false;
  /// Allows what a server does: sockets of the network and of this host, and processes, which are in this cage, too.
  /// It may open files for writing, but makes none that has a name and cuts none short, and removes none but in
  /// `removable_folders`. It listens nowhere but where it listens already, and speaks TCP to name servers only
  /// (Landlock).
  bool may_serve = false;
  /// For a server: the files that it may write, and folders in which it may make files without a name. Landlock.
  std::vector<std::string> rewritable;
  /// For a server: folders in which it may remove files. Without Landlock it may remove any, if there is such a folder.
  std::vector<std::string> removable_folders;
};

/// The parts of the cage that hold.
struct Held {
  bool by_system_calls = false;  ///< seccomp: no calls but those that the freedom needs
  bool by_paths = false;         ///< Landlock: of files, only those that are named
  /// The first path that got no right although it may exist, with the reason of the system. What needs that path would
  /// fail with EACCES, which is misleading. Empty: there is none.
  std::string fault{};
};

/// Closes the cage: no new privileges, no capabilities except to read and write files as before (a server: to read
/// them, and to use ports below 1024), Landlock, seccomp. What is forbidden fails with EACCES and does nothing. It does
/// not end in a signal: a C library that is newer than the list of system calls tries a new one and takes another when
/// that fails. Call it while the process has one thread.
Held close(const Freedom& freedom);

}  // namespace geminga::cage

#endif
