#include "manual/outline.hpp"

#include <CLI/App.hpp>
#include <algorithm>
#include <array>
#include <string_view>

namespace geminga::manual {
namespace {

constexpr std::string_view usual_group = "Options";

/// Splits a text at the separators.
std::vector<std::string> split(std::string_view text, std::string_view separators) {
  std::vector<std::string> words;
  while (!text.empty()) {
    const auto end = std::min(text.find_first_of(separators), text.size());
    if (end > 0) words.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return words;
}

/// Whether a user types this word as it stands. Words in capitals, e.g. COST, stand for values.
bool is_literal(std::string_view word) {
  return std::ranges::all_of(word, [](char c) { return (c >= 'a' && c <= 'z') || c == '-' || c == '/' || c == '_'; });
}

/// The choices in `yes|no|COST` and `FORMAT:{dot,svg}`.
std::vector<std::string> choices_of(std::string_view value) {
  const auto brace = value.find('{');
  const bool is_list = brace != std::string_view::npos && value.ends_with('}');
  if (!is_list && !value.contains('|')) return {};
  if (is_list) value = value.substr(brace + 1, value.size() - brace - 2);
  auto words = split(value, is_list ? "," : "|");
  std::erase_if(words, [](const std::string& word) { return !is_literal(word); });
  return words;
}

bool names_a_file(std::string_view value) {
  return value == "OUT" || std::ranges::any_of(std::array{"FILE", "FOLDER", "PATH"},
                                               [&](const char* word) { return value.contains(word); });
}

/// The kind of words that a daemon can offer for the values that --help calls so.
std::string living_of(const Flag& flag) {
  struct Living {
    std::string_view value;
    const char* kind;
  };
  constexpr auto all = std::to_array<Living>({{"SUBSCRIPTION", "either"},
                                              {"SERVICE", "service"},
                                              {"WORD", "service"},
                                              {"C", "concept"},
                                              {"R", "representation"},
                                              {"IDENTITY", "concept"},
                                              {"CONCEPT", "concept"},
                                              {"WORDS", "concept"},
                                              {"SUB", "concept"},
                                              {"SUPER", "concept"},
                                              {"FILTER", "filter"}});
  if (flag.names.back() == "--text" || flag.names.back() == "--offer-text") return "text";
  const bool is_word = !flag.names.back().starts_with('-');
  if (!is_word && flag.value.starts_with("PARTICIPANT[/PEER]")) return "provider";
  const auto* const found =
      std::ranges::find(all, std::string_view(is_word ? flag.names.back() : flag.value), &Living::value);
  return found == all.end() ? "" : found->kind;
}

Flag flag_of(const CLI::Option& option) {
  Flag flag;
  for (const auto& name : option.get_snames()) flag.names.push_back('-' + name);
  for (const auto& name : option.get_lnames()) flag.names.push_back("--" + name);
  const bool is_word = !option.nonpositional();
  if (is_word) flag.names.push_back(option.get_name());
  if (option.get_type_size() != 0) flag.value = option.get_type_name();
  flag.meaning = option.get_description();
  if (option.get_group() != usual_group) flag.group = option.get_group();
  flag.choices = choices_of(flag.value);
  flag.is_file = names_a_file(flag.value) || (is_word && names_a_file(flag.names.front()));
  flag.living = living_of(flag);
  flag.is_repeated = option.get_items_expected_max() > 1;
  flag.is_required = option.get_required();
  // CLI11 adds to a list of choices what only readers of code understand.
  if (const auto brace = flag.value.find(":{"); brace != std::string::npos) flag.value.resize(brace);
  return flag;
}

}  // namespace

Outline outline_of(const CLI::App& app) {
  Outline outline{.name = app.get_name(),
                  .about = app.get_description(),
                  .more = app.get_footer(),
                  .version = app.version(),
                  .words = {},
                  .flags = {},
                  .commands = {},
                  .has_flags_everywhere = app.get_fallthrough()};
  for (const CLI::Option* option : app.get_options([](const CLI::Option* one) { return !one->get_group().empty(); })) {
    (option->nonpositional() ? outline.flags : outline.words).push_back(flag_of(*option));
  }
  for (const CLI::App* command : app.get_subcommands([](const CLI::App* one) { return !one->get_group().empty(); })) {
    outline.commands.push_back(outline_of(*command));
  }
  return outline;
}

}  // namespace geminga::manual
