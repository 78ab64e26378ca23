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

/// Runs geminga-ontology with these words, with its standard output in the file `output`. Returns its exit status; -1
/// where it could not be started, which is said on standard error, or was killed.
[[nodiscard]] int run_ontology_program(std::vector<std::string> words, const std::string& output);

}  // namespace geminga::query

#endif
