// The --help of a program, read by its layout.
#ifndef GEMINGA_TESTS_TOOLS_HELP_TEXT_HPP
#define GEMINGA_TESTS_TOOLS_HELP_TEXT_HPP

#include <sstream>
#include <string>
#include <vector>

namespace geminga::tools {

/// The commands that a program's --help lists.
inline std::vector<std::string> commands_of(const std::string& help) {
  std::vector<std::string> commands;
  const auto begin = help.find("Subcommands:\n");
  if (begin == std::string::npos) return commands;
  std::istringstream lines(help.substr(help.find('\n', begin) + 1));
  for (std::string line; std::getline(lines, line) && line.starts_with("  ");) {
    if (line[2] != ' ') commands.push_back(line.substr(2, line.find(' ', 2) - 2));
  }
  return commands;
}

}  // namespace geminga::tools

#endif
