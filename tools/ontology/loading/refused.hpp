// Files of folders that cannot be read, and were left out: their consequences for answers and exit statuses. load()
// names each of them on standard error.
#ifndef GEMINGA_ONTOLOGY_LOADING_REFUSED_HPP
#define GEMINGA_ONTOLOGY_LOADING_REFUSED_HPP

#include <optional>
#include <string>

#include "ontology/command/exit_status.hpp"
#include "reasoning/syntax/rdf/load.hpp"

namespace geminga::ontology {

/// Why an answer may be missing, in one line; nothing where every file was read.
[[nodiscard]] std::optional<std::string> describe_refused(const rdf::Loaded& loaded);
/// The exit status of a list of what follows from files. A file that cannot be read is a problem: done becomes 1.
[[nodiscard]] Exit exit_of_list(const rdf::Loaded& loaded, Exit exit);
/// The exit status of an answer. Yes holds, whatever the files say that were left out; no cannot be decided, and is
/// said so.
[[nodiscard]] Exit exit_of_answer(const rdf::Loaded& loaded, Exit exit);

/// Parts of a help text that say so.
inline constexpr const char* refused_of_list =
    "A file of a folder that cannot be read is left out and named, and the exit status is 1.\n";
inline constexpr const char* refused_of_answer =
    "A file of a folder that cannot be read is left out and named. What is found without it holds; where nothing is,\n"
    "that cannot be decided, and the exit status is 2.\n";

}  // namespace geminga::ontology

#endif
