// A program's man page and completions, from the table of its flags.
#ifndef GEMINGA_MANUAL_DESCRIBE_HPP
#define GEMINGA_MANUAL_DESCRIBE_HPP

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace geminga::manual {

/// The output of a program with these flags for `PROGRAM --describe man|bash|zsh|fish`, which the build calls; nothing
/// for every other command line. `section` is that of the manual: 1 for commands, 8 for daemons.
[[nodiscard]] std::optional<std::string> described(const CLI::App& app, int argc, const char* const* argv,
                                                   int section = 1);

}  // namespace geminga::manual

#endif
