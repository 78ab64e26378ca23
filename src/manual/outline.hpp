// What the command line of a program says of itself: the words of its --help, as a value.
#ifndef GEMINGA_MANUAL_OUTLINE_HPP
#define GEMINGA_MANUAL_OUTLINE_HPP

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace geminga::manual {

/// A flag, or a word that stands by itself.
struct Flag {
  std::vector<std::string> names;  ///< `-h`, `--help`; of a word its one name, e.g. `FILES`
  std::string value;               ///< what follows it, as --help has it, e.g. `SECONDS`; empty: nothing
  std::string meaning;
  std::string group;                 ///< the heading above it; empty: the usual one
  std::vector<std::string> choices;  ///< what its value can be, where that is one of a few words
  bool is_file = false;              ///< its value can be a file or a folder
  bool is_repeated = false;
  bool is_required = false;
};

/// A program, or one of its commands.
struct Outline {
  std::string name;
  std::string about;  ///< what --help says above the flags
  std::string more;   ///< and below them: examples, exit statuses
  std::string version;
  std::vector<Flag> words;
  std::vector<Flag> flags;
  std::vector<Outline> commands;
  bool has_flags_everywhere = false;  ///< the flags of the program may stand behind the command, too
};

/// What is hidden from --help is not in it.
[[nodiscard]] Outline outline_of(const CLI::App& app);

}  // namespace geminga::manual

#endif
