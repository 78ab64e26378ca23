#include "manual/mistake.hpp"

#include <CLI/App.hpp>
#include <algorithm>
#include <cstddef>
#include <string_view>
#include <vector>

#include "base/edit_distance.hpp"
#include "base/text.hpp"

namespace geminga::manual {
namespace {

/// The name that is most similar to a word, of several the first; nothing where none is similar.
std::string nearest(std::string_view word, const std::vector<std::string>& names) {
  std::size_t limit = base::tolerated_slips(word);
  std::string found;
  for (const std::string& name : names) {
    const std::size_t distance = base::edit_distance(word, name, limit);
    if (distance > limit || (!found.empty() && distance == limit)) continue;
    limit = distance;
    found = name;
  }
  return found;
}

/// The long flags that a user may give to this command, with those of the program around it.
std::vector<std::string> flags_of(const CLI::App& app) {
  std::vector<std::string> flags;
  const auto add = [&](const CLI::App& one) {
    for (const CLI::Option* option : one.get_options()) {
      if (!option->get_group().empty())
        flags.insert(flags.end(), option->get_lnames().begin(), option->get_lnames().end());
    }
  };
  for (const CLI::App* command : app.get_subcommands()) add(*command);
  add(app);
  return flags;
}

std::vector<std::string> commands_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  return names;
}

/// Replaces the first `what` in a text by `by`; changes nothing where it is not there.
void replace_first(std::string& text, std::string_view what, std::string_view by) {
  if (const std::size_t begin = text.find(what); begin != std::string::npos) text.replace(begin, what.size(), by);
}

/// The sentence of CLI11 in one line, in plain words: "--format: png not in {dot,svg}" becomes "--format: png is none
/// of dot, svg".
std::string words_of(const CLI::ParseError& error) {
  std::string words = error.what();
  while (!words.empty() && (words.back() == '\n' || words.back() == ' ')) words.pop_back();
  std::ranges::replace(words, '\n', ' ');
  switch (static_cast<CLI::ExitCodes>(error.get_exit_code())) {
    case CLI::ExitCodes::ArgumentMismatch:  // "--interval: 1 required SECONDS missing"
      if (const std::size_t count = words.find(": "), end = words.find(" required ");
          end != std::string::npos && count < end && words.ends_with(" missing")) {
        words.replace(words.size() - std::string_view("missing").size(), std::string::npos, "is missing");
        words.erase(count + 2, end + std::string_view(" required ").size() - count - 2);
      }
      return words;
    case CLI::ExitCodes::ValidationError: {
      replace_first(words, ": File does not exist: ", ": there is no file ");
      if (const std::size_t list = words.find(" not in {"); list != std::string::npos && words.ends_with('}')) {
        words.pop_back();
        words.replace(list, std::string_view(" not in {").size(), " is none of ");
        for (std::size_t comma = words.find(',', list); comma != std::string::npos; comma = words.find(',', comma + 2))
          words.insert(comma + 1, " ");
      }
      if (words.find(" not in range ") != std::string::npos) {
        replace_first(words, ": Value ", ": ");
        replace_first(words, " not in range ", " is not from ");
      }
      // "IDENTITY: is missing" is one sentence.
      if (const std::size_t colon = words.find(": "); words.find(": is ") == colon)
        replace_first(words, ": is ", " is ");
      return words;
    }
    case CLI::ExitCodes::ConversionError:  // "Could not convert: --closure = x": a flag was given a value
      replace_first(words, "Could not convert: ", "");
      replace_first(words, " = ", " takes no value such as ");
      return words;
    default:
      return words;
  }
}

/// The name of the first option of this command that was given an empty text; empty where there is none.
std::string empty_option(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options()) {
    if (std::ranges::find(option->results(), "") != option->results().end()) return option->get_name();
  }
  return {};
}

}  // namespace

std::optional<std::string> empty_text(const CLI::App& app) {
  std::string name = empty_option(app);
  for (const CLI::App* command : app.get_subcommands()) name = name.empty() ? empty_option(*command) : name;
  if (name.empty()) return std::nullopt;
  return name + " is empty: leave it out, or see whether the variable that it comes from is set: see " +
         app.get_name() + " --help";
}

std::string mistake(const CLI::App& app, const CLI::ParseError& error) {
  const std::string see = "see " + app.get_name() + " --help";
  const std::vector<std::string> left = app.remaining(true);
  const auto commands = commands_of(app);
  const auto is_flag = [](const std::string& word) { return word.size() > 1 && word.front() == '-'; };
  const auto flag = std::ranges::find_if(left, is_flag);
  const auto word = std::ranges::find_if_not(left, is_flag);
  if (!commands.empty() && app.get_subcommands().empty() && word != left.end()) {
    const std::string meant = nearest(*word, commands);
    return '\'' + base::printable(*word) + "' is no command: " +
           (meant.empty() ? "the commands are " + base::joined(commands, ", ") + ": "
                          : "did you mean " + meant + "? ") +
           see;
  }
  // An argument may be missing because a flag is misspelt.
  const bool lacks_something = error.get_exit_code() == static_cast<int>(CLI::ExitCodes::RequiredError);
  if (lacks_something && !commands.empty() && app.get_subcommands().empty() && flag == left.end())
    return "a command is missing: the commands are " + base::joined(commands, ", ") + ": " + see;
  const bool has_extras = error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError);
  if (has_extras && flag == left.end() && word != left.end())
    return '\'' + base::printable(*word) + "' is one word too many: " + see;
  if (flag == left.end() || (!has_extras && !lacks_something)) return words_of(error) + ": " + see;
  const std::string name = flag->substr(0, flag->find('='));
  const std::size_t dashes = name.find_first_not_of('-');
  const std::string meant = dashes == 2 ? nearest(name.substr(dashes), flags_of(app)) : std::string();
  return '\'' + base::printable(name) + "' is no flag: " + (meant.empty() ? "" : "did you mean --" + meant + "? ") +
         see;
}

}  // namespace geminga::manual
