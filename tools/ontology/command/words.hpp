// The words of this program on standard output and standard error: errors in one form, counted nouns. All that is
// printed goes through this file, so that nothing of a file reaches a terminal that the terminal could obey
// (base/harmless.hpp).
#ifndef GEMINGA_ONTOLOGY_COMMAND_WORDS_HPP
#define GEMINGA_ONTOLOGY_COMMAND_WORDS_HPP

#include <boost/json/value.hpp>
#include <cstddef>
#include <string>
#include <string_view>

#include "ontology/command/exit_status.hpp"

namespace geminga::ontology {

/// Writes `geminga-ontology: WORDS` to standard error and returns `exit`. The words say what is wrong and, behind a
/// colon, what to do.
Exit say_error(std::string_view words, Exit exit = Exit::usage);

/// Does the same, and with `as_json` also prints the document {"error": WORDS} for the reader of standard output.
Exit say_failure(std::string_view words, bool as_json, Exit exit = Exit::usage);

/// Writes lines to standard output at once; false where it could not be written (a full disk, a closed pipe).
[[nodiscard]] bool print(std::string_view lines);
/// The same for lines that more lines follow. print("") writes what is left.
[[nodiscard]] bool print_more(std::string_view lines);
/// Writes data in a syntax of its own: to a file or a pipe as it stands, to a terminal as lines.
[[nodiscard]] bool print_data(std::string_view data);
/// A JSON document as text, with escapes for all that a terminal could obey, and without a line end.
[[nodiscard]] std::string json_text(const boost::json::value& document);
/// Prints and returns `exit`, or says that standard output cannot be written.
[[nodiscard]] Exit print_or_say(std::string_view text, Exit exit = Exit::yes);
/// Says that standard output cannot be written.
Exit say_unwritten();

/// "1 class", "2 classes".
[[nodiscard]] std::string counted(std::size_t count, std::string_view one, std::string_view many);

}  // namespace geminga::ontology

#endif
