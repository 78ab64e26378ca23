#include "manual/bash_completion.hpp"

#include <algorithm>
#include <string_view>

#include "manual/shell_word.hpp"

namespace geminga::manual {
namespace {

/// The name of the function, of characters that a shell allows.
std::string function_of(std::string_view program) {
  std::string name = "_";
  for (const char c : program) name += c == '-' ? '_' : c;
  return name;
}

std::string joined(const std::vector<std::string>& words, std::string_view separator = " ") {
  std::string text;
  for (const std::string& word : words) {
    if (!text.empty()) text += separator;
    text += word;
  }
  return text;
}

std::vector<std::string> names_of(const std::vector<Flag>& flags) {
  std::vector<std::string> names;
  for (const Flag& flag : flags) names.insert(names.end(), flag.names.begin(), flag.names.end());
  return names;
}

std::vector<std::string> names_of(const std::vector<Outline>& commands) {
  std::vector<std::string> names;
  for (const Outline& command : commands) names.push_back(command.name);
  return names;
}

/// Completes the values of flags, as arms of `case "$command $previous"`.
std::string arms(const Outline& outline, const std::string& command) {
  std::string text;
  for (const Flag& flag : outline.flags) {
    if (flag.value.empty()) continue;
    std::vector<std::string> patterns;
    for (const std::string& name : flag.names) {
      patterns.push_back(command);
      patterns.back() += shell_word(' ' + name);
    }
    text += "    ";
    text += joined(patterns, " | ");
    text += ") ";
    if (!flag.choices.empty()) {
      text += "_geminga_words " + shell_word(joined(flag.choices));
    } else if (flag.is_file) {
      text += "_geminga_files";
    } else {
      text += ":";
    }
    text += "; return ;;\n";
  }
  return text;
}

/// Completes flags, commands and files, as an arm of `case $command`.
std::string offer(const Outline& outline, const std::vector<Flag>& flags_of_all, const std::string& command) {
  std::vector<std::string> flags = names_of(outline.flags);
  for (const std::string& name : names_of(flags_of_all)) {
    if (std::ranges::find(flags, name) == flags.end()) flags.push_back(name);
  }
  const bool takes_files = std::ranges::any_of(outline.words, &Flag::is_file);
  std::string text = "    " + shell_word(command) + ") flags=" + shell_word(joined(flags));
  if (!outline.commands.empty()) text += " words=" + shell_word(joined(names_of(outline.commands)));
  if (takes_files) text += " has_files=yes";
  return text + " ;;\n";
}

/// Finds the command among the words typed so far, and skips the values of flags.
std::string search(const Outline& program) {
  std::vector<std::string> with_value;
  for (const Flag& flag : program.flags) {
    if (!flag.value.empty()) with_value.insert(with_value.end(), flag.names.begin(), flag.names.end());
  }
  std::string text = "  for ((i = 1; i < COMP_CWORD; i++)); do\n    case ${COMP_WORDS[i]} in\n";
  if (!with_value.empty()) {
    text += "      " + joined(with_value, " | ") + ") ((i++)); [[ ${COMP_WORDS[i]-} != = ]] || ((i++)) ;;\n";
  }
  text += "      " + joined(names_of(program.commands), " | ") + ") command=${COMP_WORDS[i]}; break ;;\n";
  return text + "    esac\n  done\n";
}

/// Helpers that each of these files defines in the same words, so that the order of reading them does not matter.
constexpr std::string_view shared =
    R"(_geminga_words() {
  local IFS=$' \t\n'
  COMPREPLY=($(compgen -W "$1" -- "$current"))
}
_geminga_files() {
  compopt -o filenames 2>/dev/null || :
  mapfile -t COMPREPLY < <(compgen -f -- "$current")
}
)";

/// Joins `--flag=value`, which bash splits into three words.
constexpr std::string_view beginning =
    R"(  local current=${COMP_WORDS[COMP_CWORD]} previous='' command='' flags='' words='' has_files='' i
  COMPREPLY=()
  ((COMP_CWORD == 0)) || previous=${COMP_WORDS[COMP_CWORD - 1]}
  if [[ $current == = ]]; then
    current=''
  elif [[ $previous == = ]] && ((COMP_CWORD > 1)); then
    previous=${COMP_WORDS[COMP_CWORD - 2]}
  fi
)";

constexpr std::string_view ending =
    R"(  if [[ $current == -* || -z $words$has_files ]]; then
    _geminga_words "$flags"
  elif [[ -n $has_files ]]; then
    _geminga_files
  else
    _geminga_words "$words"
  fi
}
)";

}  // namespace

std::string bash_completion(const Outline& program) {
  const std::string function = function_of(program.name);
  std::string text = "# Completion of " + program.name + " for bash, made from its table of flags.\n";
  text += std::string(shared) + function + "() {\n" + std::string(beginning);
  if (!program.commands.empty()) text += search(program);
  text += "  case \"$command $previous\" in\n";
  for (const Outline& command : program.commands) text += arms(command, command.name);
  text += arms(program, program.has_flags_everywhere ? "*" : "") + "  esac\n";
  text += "  case $command in\n" + offer(program, {}, "");
  for (const Outline& command : program.commands) {
    text += offer(command, program.has_flags_everywhere ? program.flags : std::vector<Flag>{}, command.name);
  }
  text += "  esac\n" + std::string(ending);
  return text + "complete -F " + function + ' ' + program.name + '\n';
}

}  // namespace geminga::manual
