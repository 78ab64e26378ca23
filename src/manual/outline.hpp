// The command line of a program as a value: its words, flags and commands, as --help shows them.
#ifndef GEMINGA_MANUAL_OUTLINE_HPP
#define GEMINGA_MANUAL_OUTLINE_HPP

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace geminga::manual {

/// A flag, or a positional word.
struct Flag {
  std::vector<std::string> names;  ///< `-h`, `--help`; of a word its one name, e.g. `FILES`
  std::string value;               ///< its value as --help calls it, e.g. `SECONDS`; empty: it takes none
  std::string meaning;
  std::string group;                 ///< the heading above it; empty: the usual one
  std::vector<std::string> choices;  ///< the values, where a few words are all of them
  bool is_file = false;              ///< its value can be a file or a folder
  /// The kind of its values that a daemon knows, as `geminga-query complete` calls it; empty: a daemon knows none.
  std::string living;
  bool is_repeated = false;
  bool is_required = false;
};

/// A program, or one of its commands.
struct Outline {
  std::string name;
  std::string about;  ///< the text above the flags
  std::string more;   ///< the text below them: examples, exit statuses
  std::string version;
  std::vector<Flag> words;
  std::vector<Flag> flags;
  std::vector<Outline> commands;
  bool has_flags_everywhere = false;  ///< the flags of the program may stand behind the command, too
};

/// The outline of a program, without the flags that --help hides.
[[nodiscard]] Outline outline_of(const CLI::App& app);

}  // namespace geminga::manual

#endif
