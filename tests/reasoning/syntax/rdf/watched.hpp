// Runs a function in a process of its own, and watches its system calls.
#ifndef GEMINGA_TESTS_REASONING_SYNTAX_RDF_WATCHED_HPP
#define GEMINGA_TESTS_REASONING_SYNTAX_RDF_WATCHED_HPP

#include <functional>
#include <string>
#include <vector>

namespace geminga::rdf {

/// The system calls of a process, and its result.
struct Watched {
  int status = -1;                  ///< as waitpid gives it
  std::string said;                 ///< the result of the function
  std::vector<std::string> opened;  ///< paths of open and openat, tried or done
  bool asked_for_sockets = false;
  bool asked_for_programs = false;
  long peak_kib = 0;
};

/// Forks, and traces every system call of the child. It may use `seconds` of processor time and is killed beyond.
[[nodiscard]] Watched watch(unsigned seconds, const std::function<std::string()>& deed);

}  // namespace geminga::rdf

#endif
