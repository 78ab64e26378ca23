// A mistake on the command line in words, with the flag or command that may have been meant.
#ifndef GEMINGA_MANUAL_MISTAKE_HPP
#define GEMINGA_MANUAL_MISTAKE_HPP

#include <optional>
#include <string>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace geminga::manual {

/// One line for the error with which `app` refused its command line: what is wrong, the flag or the command that is
/// similar to an unknown one or else the commands that there are, and `see PROGRAM --help`.
[[nodiscard]] std::string mistake(const CLI::App& app, const CLI::ParseError& error);

/// One line about the first flag or word of a command line that is an empty text, as a shell makes it of a variable
/// that is not set; nothing where there is none. `app` has read the command line.
[[nodiscard]] std::optional<std::string> empty_text(const CLI::App& app);

}  // namespace geminga::manual

#endif
