// geminga-query describe: says what this host's participant is.
#include "shell/describe.hpp"

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "query/command.hpp"
#include "query/listing.hpp"
#include "shell/report.hpp"

namespace geminga::query {
namespace {

struct Described {
  std::vector<std::string> words;
  bool is_end = false;
};

/// The expression among the words, and the attributes. Throws CLI::ValidationError.
std::pair<std::optional<std::string>, Attributes> read_description(const Described& said) {
  std::optional<std::string> expression;
  Attributes attributes;
  for (const std::string& word : said.words) {
    if (const auto pair = shell::key_and_value(word)) {
      attributes[pair->first] = pair->second;
    } else if (expression) {
      throw CLI::ValidationError(word, "is a second expression: write one, in quotes, e.g. 'A and B'");
    } else {
      expression = word;
    }
  }
  if (said.is_end && !said.words.empty())
    throw CLI::ValidationError("--none", "goes with no EXPRESSION and no KEY=VALUE");
  if (said.is_end) expression.emplace();
  if (!expression && attributes.empty()) throw CLI::RequiredError("EXPRESSION, KEY=VALUE or --none");
  return {std::move(expression), std::move(attributes)};
}

}  // namespace

void add_describe(CLI::App& app, Run& selected) {
  CLI::App* command = app.add_subcommand("describe", "Say what this host's participant is, for the team to ask for");
  const auto said = std::make_shared<Described>();
  command->add_option("EXPRESSION", said->words,
                      "A class or a class expression, in place of the present one; KEY=VALUE: an attribute beside it, "
                      "such as battery='80 %'");
  command->add_flag("--none", said->is_end, "Take the description back");
  command->footer(
      "It holds until it is changed or the daemon ends; gemingad --describe has one from the start. What changes often "
      "is\n"
      "an attribute. At most four changes a second.\n\n"
      "Examples:\n  geminga-query describe 'Robot and hasPart some Gripper' battery='80 %'\n"
      "  geminga-query describe battery='79 %'\n  geminga-query describe --none");
  command->callback([said, &selected] {
    selected = [one = read_description(*said)](const Context& context, Client& client) {
      if (refuses_watch(context, "describe")) return shell::ExitStatus::wrong_use;
      const auto done = client.describe(one.first, one.second);
      return done ? shell::ExitStatus::found : shell::report(program, done.error());
    };
  });
}

}  // namespace geminga::query
