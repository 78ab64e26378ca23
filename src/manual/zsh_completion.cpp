#include "manual/zsh_completion.hpp"

#include <algorithm>
#include <string_view>

#include "manual/shell_word.hpp"

namespace geminga::manual {
namespace {

/// Puts a backslash before each of these characters.
std::string with_backslashes(std::string_view text, std::string_view special) {
  std::string word;
  for (const char c : text) {
    if (special.contains(c) || c == '\\') word += '\\';
    word += c == '\n' ? ' ' : c;
  }
  return word;
}

/// `:VALUE:(yes no)`, `:FILE:_files`, `:SERVICE: _geminga_living service`; the action of a value that cannot be
/// completed adds nothing. Behind a space _arguments gives a function no arguments of its own.
std::string value_of(const Flag& flag, std::string_view name) {
  std::string text = ':' + with_backslashes(name.empty() ? "VALUE" : name, ":") + ':';
  if (flag.choices.empty() && !flag.living.empty()) return text + " _geminga_living " + flag.living;
  if (flag.choices.empty()) return text + (flag.is_file ? "_files" : " ");
  text += '(';
  for (const std::string& choice : flag.choices) text += (text.ends_with('(') ? "" : " ") + choice;
  return text + ')';
}

/// The arguments of _arguments for a flag, one for each of its names.
std::string argument(const Flag& flag) {
  std::string all;
  for (const std::string& name : flag.names) all += (all.empty() ? "" : " ") + name;
  std::string text;
  for (const std::string& name : flag.names) {
    std::string spec = flag.is_repeated ? "*" : '(' + all + ')';
    spec += name;
    if (!flag.value.empty() && name.starts_with("--")) spec += '=';
    spec += '[' + with_backslashes(flag.meaning, "[]:") + ']';
    if (!flag.value.empty()) spec += value_of(flag, flag.value);
    text += " \\\n    " + shell_word(spec);
  }
  return text;
}

std::string arguments(const std::vector<Flag>& flags) {
  std::string text;
  for (const Flag& flag : flags) text += argument(flag);
  return text;
}

std::string words_of(const Outline& outline) {
  std::string text;
  for (const Flag& word : outline.words) {
    text += " \\\n    " + shell_word((word.is_repeated ? "*" : "") + value_of(word, word.names.front()));
  }
  return text;
}

/// Offers what the daemon knows. _describe quotes each word; what a daemon says is never evaluated.
constexpr std::string_view living =
    R"x(_geminga_living() {
  local -a known
  local line word text
  while IFS= read -r line; do
    word=${line%%$'\t'*} text=${line#*$'\t'}
    word=${word//\\/\\\\}
    known+=("${word//:/\\:}${text:+:$text}")
  done < <(geminga-query ${geminga_connect:+--connect=$geminga_connect} --timeout 0.5 complete $1 ${(Q)PREFIX} 2>/dev/null </dev/null)
  _describe -V $1 known
}
)x";

/// Finds where the daemon listens before _arguments changes the words.
constexpr std::string_view finding =
    R"x(  local geminga_connect=
  local -i geminga_place
  for ((geminga_place = 2; geminga_place < CURRENT; ++geminga_place)); do
    case ${words[geminga_place]} in
    --connect) geminga_connect=${(Q)words[geminga_place + 1]} ;;
    --connect=*) geminga_connect=${(Q)words[geminga_place]#*=} ;;
    esac
  done
)x";

}  // namespace

std::string zsh_completion(const Outline& program) {
  const std::string function = '_' + program.name;
  std::string text = "#compdef " + program.name + "\n# Completion for zsh, made from the table of flags.\n";
  text += std::string(living) + function + "() {\n" + std::string(finding);
  text += "  local curcontext=$curcontext state state_descr line\n  typeset -A opt_args\n";
  if (program.commands.empty()) {
    text += "  _arguments -S" + arguments(program.flags) + words_of(program) + '\n';
  } else {
    text += "  _arguments -C" + arguments(program.flags) + " \\\n    '1:command:->command' \\\n    '*:: :->words'\n";
    text += "  case $state in\n  command)\n    local -a commands=(\n";
    for (const Outline& command : program.commands) {
      text += "      " + shell_word(command.name + ':' + with_backslashes(command.about, "")) + '\n';
    }
    text += "    )\n    _describe command commands ;;\n  words)\n    case $line[1] in\n";
    for (const Outline& command : program.commands) {
      std::vector<Flag> flags = command.flags;
      for (const Flag& flag : program.flags) {
        const bool is_there = std::ranges::find(flags, flag.names, &Flag::names) != flags.end();
        if (program.has_flags_everywhere && !is_there) flags.push_back(flag);
      }
      text += "    " + command.name + ") _arguments -S" + arguments(flags) + words_of(command) + " ;;\n";
    }
    text += "    esac ;;\n  esac\n";
  }
  return text + "}\n" + function + " \"$@\"\n";
}

}  // namespace geminga::manual
