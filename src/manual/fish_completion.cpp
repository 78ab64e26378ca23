#include "manual/fish_completion.hpp"

#include <algorithm>
#include <string_view>

namespace geminga::manual {
namespace {

/// A text between single quotes, within which fish knows a backslash before a quote and before another backslash.
std::string fish_word(std::string_view text) {
  std::string word = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') word += '\\';
    word += c == '\n' ? ' ' : c;
  }
  return word + '\'';
}

/// The arguments of `complete` that offer a value: a few words, what the daemon knows, files, or nothing.
std::string values(const Flag& flag) {
  if (!flag.choices.empty()) {
    std::string words;
    for (const std::string& choice : flag.choices) words += (words.empty() ? "" : " ") + choice;
    return " -a " + fish_word(words);
  }
  if (!flag.living.empty()) return " -a " + fish_word("(__geminga_living " + flag.living + ")");
  return flag.is_file ? " -F" : "";
}

/// The lines of some flags and words, which hold where the condition does; an empty one holds everywhere.
std::string lines(const std::string& name, const std::string& condition, const std::vector<Flag>& flags,
                  const std::vector<Flag>& words) {
  const std::string begin = "complete -c " + name + (condition.empty() ? "" : " -n " + fish_word(condition));
  std::string text;
  for (const Flag& flag : flags) {
    text += begin;
    for (const std::string& one : flag.names)
      text += one.starts_with("--") ? " -l " + one.substr(2) : " -s " + one.substr(1);
    if (!flag.value.empty()) text += (flag.is_file && flag.choices.empty() ? " -r" : " -x") + values(flag);
    text += " -d " + fish_word(flag.meaning) + '\n';
  }
  for (const Flag& word : words) {
    if (const std::string offered = values(word); !offered.empty()) text += begin + offered + '\n';
  }
  return text;
}

/// Offers what the daemon knows, which `geminga-query complete` tells as fish wants it: a word, a tab, its meaning.
/// Fish quotes each word; what a daemon says is never evaluated. `--connect` of the command line leads to the daemon.
constexpr std::string_view living_in_fish =
    R"x(function __geminga_living
  set -l connect
  set -l last
  for word in (commandline -opc)
    if test "$last" = --connect
      set connect --connect=$word
    else if string match -q -- '--connect=*' $word
      set connect $word
    end
    set last $word
  end
  set -l begin (commandline -ct | string unescape)
  test -n "$begin"; or set -e begin
  geminga-query $connect --timeout 0.5 complete $argv[1] $begin 2>/dev/null </dev/null
end
)x";

}  // namespace

std::string fish_completion(const Outline& program) {
  std::string text = "# Completion for fish, made from the table of flags of " + program.name + ".\n";
  text += std::string(living_in_fish) + "complete -c " + program.name + " -f\n";
  std::string commands;
  for (const Outline& command : program.commands) commands += ' ' + command.name;
  const std::string before = commands.empty() ? "" : "not __fish_seen_subcommand_from" + commands;
  text += lines(program.name, program.has_flags_everywhere ? "" : before, program.flags, program.words);
  for (const Outline& command : program.commands) {
    text += "complete -c " + program.name + " -n " + fish_word(before) + " -a " + command.name + " -d " +
            fish_word(command.about) + '\n';
  }
  for (const Outline& command : program.commands) {
    std::vector<Flag> flags = command.flags;
    std::erase_if(flags, [&](const Flag& flag) {
      return program.has_flags_everywhere &&
             std::ranges::find(program.flags, flag.names, &Flag::names) != program.flags.end();
    });
    text += lines(program.name, "__fish_seen_subcommand_from " + command.name, flags, command.words);
  }
  return text;
}

}  // namespace geminga::manual
