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

/// Patterns of `case "$command $flag"` for each name of a flag. `command` is a pattern, too.
std::vector<std::string> patterns_of(const Flag& flag, const std::string& command) {
  std::vector<std::string> patterns;
  for (const std::string& name : flag.names) {
    patterns.push_back(command);
    patterns.back() += shell_word(' ' + name);
  }
  return patterns;
}

/// The program as if it were the command without a name.
Outline nameless(Outline program) {
  program.name.clear();
  return program;
}

/// The command that offers what a flag or word may be; empty where nothing is known of it.
std::string offer_of(const Flag& flag) {
  if (!flag.choices.empty()) return "_geminga_words " + shell_word(joined(flag.choices));
  if (flag.is_file) return "_geminga_files";
  return flag.living.empty() ? "" : "_geminga_living " + flag.living;
}

/// Completes the values of flags, as arms of `case "$command $flag"`.
std::string arms(const Outline& outline, const std::string& command) {
  std::string text;
  for (const Flag& flag : outline.flags) {
    if (flag.value.empty()) continue;
    const std::string offer = offer_of(flag);
    text += "    " + joined(patterns_of(flag, command), " | ") + ") " + (offer.empty() ? ":" : offer) + "; return ;;\n";
  }
  return text;
}

/// Completes words, as arms of `case "$command $place"`: a word that may be given many times at every further place.
std::string word_arms(const Outline& outline) {
  std::string text;
  for (std::size_t place = 0; place < outline.words.size(); ++place) {
    const Flag& word = outline.words[place];
    const std::string offer = offer_of(word);
    if (offer.empty()) continue;
    text += "    " + shell_word(outline.name + ' ') + (word.is_repeated ? "*" : std::to_string(place)) + ") " + offer +
            "; return ;;\n";
  }
  return text;
}

/// Completes flags and commands, as an arm of `case $command`.
std::string offer(const Outline& outline, const std::vector<Flag>& flags_of_all, const std::string& command) {
  std::vector<std::string> flags = names_of(outline.flags);
  for (const std::string& name : names_of(flags_of_all)) {
    if (std::ranges::find(flags, name) == flags.end()) flags.push_back(name);
  }
  std::string text = "    " + shell_word(command) + ") flags=" + shell_word(joined(flags));
  if (!outline.commands.empty()) text += " others=" + shell_word(joined(names_of(outline.commands)));
  return text + " ;;\n";
}

/// Looks through the words before the last one: the command, the place of the last one among the words behind it, the
/// flag that it is the value of, and where the daemon listens.
std::string search(const Outline& program) {
  std::vector<std::string> with_value;
  const auto add = [&](const Outline& outline, const std::string& command) {
    for (const Flag& flag : outline.flags) {
      if (flag.value.empty()) continue;
      const auto patterns = patterns_of(flag, command);
      with_value.insert(with_value.end(), patterns.begin(), patterns.end());
    }
  };
  add(program, program.has_flags_everywhere || program.commands.empty() ? "*" : "");
  for (const Outline& command : program.commands) add(command, command.name);
  std::string text = "  for ((i = 1; i < ${#typed[@]} - 1; i++)); do\n    case \"$command ${typed[i]}\" in\n";
  text += "      *' --connect='*) connect=${typed[i]#*=} ;;\n";
  if (!with_value.empty()) {
    text += "      " + joined(with_value, " | ") +
            ")\n        ((++i))\n        [[ ${typed[i - 1]} != --connect ]] || connect=${typed[i]}\n"
            "        ((i < ${#typed[@]} - 1)) || flag=${typed[i - 1]} ;;\n";
  }
  text += "      *' -'*) ;;\n";
  std::vector<std::string> names;
  for (const Outline& command : program.commands) names.push_back(shell_word(' ' + command.name));
  if (!names.empty()) text += "      " + joined(names, " | ") + ") command=${typed[i]} ;;\n";
  return text + "      *) ((++place)) ;;\n    esac\n  done\n";
}

/// Helpers that each of these files defines in the same words, so that the order of reading them does not matter.
/// `typed` are the words up to the cursor, put together again where bash has split them at `=` and `:`; `current` is
/// what is typed of the last one, or of its value in `--flag=value`; `kept` is the part of it that bash leaves as it
/// is. What a daemon says comes from other robots: it is quoted for the shell, and never evaluated.
constexpr std::string_view shared =
    R"(_geminga_typed() {
  local i part='' line=${COMP_LINE:-${COMP_WORDS[*]}}
  line=${line#*"${COMP_WORDS[0]}"}
  typed=("${COMP_WORDS[0]}")
  for ((i = 1; i <= COMP_CWORD; i++)); do
    part=${COMP_WORDS[i]}
    if [[ $line == [[:space:]]* ]]; then
      typed+=("$part")
    else
      typed[${#typed[@]} - 1]+=$part
    fi
    line=${line#"${line%%[![:space:]]*}"}
    line=${line#"$part"}
  done
  current=${typed[${#typed[@]} - 1]}
  [[ -z $part || -n ${part//[=:]/} ]] || part=''
  kept=${current%"$part"}
  if [[ $current == --*=* ]]; then
    flag=${current%%=*}
    current=${current#*=}
    kept=${kept#"$flag="}
  fi
}
_geminga_words() {
  local IFS=$' \t\n'
  COMPREPLY=($(compgen -W "$1" -- "$current"))
}
_geminga_files() {
  compopt -o filenames 2>/dev/null || :
  mapfile -t COMPREPLY < <(compgen -f -- "$current")
}
_geminga_living() {
  local word text quote='' begin=$current most=0 i
  local -a words=() texts=()
  case $begin in [\'\"]*) quote=yes begin=${begin:1} ;; *) begin=${begin//\\/} ;; esac
  while IFS=$'\t' read -r word text; do
    if [[ -z $quote ]]; then
      printf -v word %q "$word"
      [[ $word == "$current"* ]] || continue
      word=${word#"$kept"}
    elif [[ $word == *[\'\"\\\$\!\`]* ]]; then
      continue
    fi
    words+=("$word") texts+=("$text")
    ((${#word} <= most)) || most=${#word}
  done < <(geminga-query ${connect:+--connect "${connect//[\'\"]/}"} --timeout 0.5 complete "$1" ${begin:+"$begin"} 2>/dev/null </dev/null)
  COMPREPLY=("${words[@]}")
  # A list, which inserts nothing, shows what each is.
  [[ ${COMP_TYPE-} == 63 ]] && ((${#words[@]} > 1)) || return 0
  for i in "${!words[@]}"; do
    [[ -z ${texts[i]} ]] || printf -v 'COMPREPLY[i]' '%-*s  (%s)' "$most" "${words[i]}" "${texts[i]}"
  done
}
)";

constexpr std::string_view beginning =
    R"(  local -a typed
  local current kept flag='' command='' connect='' flags='' others='' place=0 i
  COMPREPLY=()
  _geminga_typed
)";

constexpr std::string_view ending =
    R"(  esac
  if [[ $current == -* || -z $others ]]; then
    _geminga_words "$flags"
  else
    _geminga_words "$others"
  fi
}
)";

}  // namespace

std::string bash_completion(const Outline& program) {
  const std::string function = function_of(program.name);
  std::string text = "# Completion of " + program.name + " for bash, made from its table of flags.\n";
  text += std::string(shared) + function + "() {\n" + std::string(beginning) + search(program);
  text += "  case \"$command $flag\" in\n";
  for (const Outline& command : program.commands) text += arms(command, command.name);
  text += arms(program, program.has_flags_everywhere || program.commands.empty() ? "*" : "") + "  esac\n";
  std::string words = program.commands.empty() ? word_arms(nameless(program)) : "";
  for (const Outline& command : program.commands) words += word_arms(command);
  if (!words.empty()) text += "  [[ $current == -* ]] || case \"$command $place\" in\n" + words + "  esac\n";
  text += "  case $command in\n" + offer(program, {}, "");
  for (const Outline& command : program.commands) {
    text += offer(command, program.has_flags_everywhere ? program.flags : std::vector<Flag>{}, command.name);
  }
  return text + std::string(ending) + "complete -F " + function + ' ' + program.name + '\n';
}

}  // namespace geminga::manual
