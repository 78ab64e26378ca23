// How this program speaks: errors in one form, exact numbers, escaped texts.
#ifndef GEMINGA_ONTOLOGY_WORDS_HPP
#define GEMINGA_ONTOLOGY_WORDS_HPP

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "command.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace geminga::ontology {

/// `geminga-ontology: WORDS` on standard error. The words say what is wrong and, behind a colon, what to do.
Exit say_error(std::string_view words, Exit exit = Exit::usage);

/// The same; and where a program reads standard output as JSON, one document {"error": WORDS} there, too.
Exit say_failure(std::string_view words, bool as_json, Exit exit = Exit::usage);

/// "1 class", "2 classes".
[[nodiscard]] std::string counted(std::size_t count, std::string_view one, std::string_view many);

/// Adds the positional FILES, required, to a command.
CLI::Option* add_files(CLI::App& command, std::vector<std::string>& files);
/// Adds an option that takes a decimal number between two bounds and nothing else.
CLI::Option* add_number(CLI::App& command, const std::string& flag, unsigned& number, unsigned low, unsigned high,
                        const std::string& description);

/// Writes to standard output at once; false where it could not be written (a full disk, a closed pipe).
[[nodiscard]] bool print(std::string_view text);

}  // namespace geminga::ontology

#endif
