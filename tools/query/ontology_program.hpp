// geminga-ontology as a child: it reads files of strangers in its cage, and this program reads none.
#ifndef GEMINGA_QUERY_ONTOLOGY_PROGRAM_HPP
#define GEMINGA_QUERY_ONTOLOGY_PROGRAM_HPP

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace geminga::query {

/// Runs `geminga-ontology COMMAND FILE ONTOLOGIES` with those of the ontology files that are there, and returns what it
/// writes to standard output, at most `most_bytes` of it. It is the program beside this one, else the one on PATH.
/// Nothing after an error, which it or this function has said on standard error.
[[nodiscard]] std::optional<std::string> ask_ontology_program(const std::string& command, const std::string& file,
                                                              const std::vector<std::string>& ontologies,
                                                              std::size_t most_bytes);

}  // namespace geminga::query

#endif
