// The cage of this program, closed before it reads a file that a stranger wrote.
#ifndef GEMINGA_ONTOLOGY_CAGE_HPP
#define GEMINGA_ONTOLOGY_CAGE_HPP

#include <expected>
#include <string>

#include "ontology/command/choice.hpp"

namespace CLI {
class App;
}

namespace geminga::ontology {

/// Closes the cage (src/env/cage). It leaves for reading the files on the command line, the sources that a compiled
/// form names, the ontologies that ship, and those of `choice`; and for writing the folders of the outputs of `choice`.
/// A kernel with neither seccomp nor Landlock forbids nothing; Redland is still told to open nothing. The error, a line
/// for the user: one of these files cannot be opened now, and could not be opened in the cage.
[[nodiscard]] std::expected<void, std::string> close_cage(const CLI::App& command, const Choice& choice);

}  // namespace geminga::ontology

#endif
