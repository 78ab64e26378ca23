// What this program forbids itself before it reads a file that somebody else wrote.
#ifndef GEMINGA_ONTOLOGY_CONFINEMENT_HPP
#define GEMINGA_ONTOLOGY_CONFINEMENT_HPP

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace geminga::ontology {

/// Closes the cage (src/env/cage): from now on nothing but what the command line names can be read, with the sources
/// that a compiled form names, the ontologies that ship and `readable`, and nothing but the folders of `outputs` can be
/// written to.
/// Where the kernel has neither seccomp nor Landlock nothing is forbidden; Redland is still told to open nothing.
void shut_in(const CLI::App& command, const std::vector<std::string>& outputs,
             const std::vector<std::string>& readable);

}  // namespace geminga::ontology

#endif
