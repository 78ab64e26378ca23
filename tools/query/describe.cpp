// geminga-query describe: says what this host's participant is.
#include "shell/describe.hpp"

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "answers/ontology.hpp"
#include "query/command.hpp"
#include "query/listing.hpp"
#include "query/ontology_program.hpp"
#include "reasoning/syntax/folders.hpp"
#include "shell/report.hpp"

namespace geminga::query {
namespace {

/// Octets of the one line in which geminga-ontology says what facts become; it says less.
constexpr std::size_t max_answer_bytes = 4096;

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

/// The files of the daemon's ontology, by which the properties of facts are known.
std::vector<std::string> files_of(const Answer& ontology) {
  std::vector<std::string> files;
  for (const Record& one : answers::ontology_of(ontology).files) files.emplace_back(one["file"]);
  return files;
}

}  // namespace

void add_describe(CLI::App& app, Run& selected) {
  CLI::App* command =
      app.add_subcommand("describe", "Describe this host's participant, so that others find it by what it is");
  const auto said = std::make_shared<Described>();
  command->add_option(
      "EXPRESSION", said->words,
      "A class or a class expression, which replaces the present one; or a file of facts about geminga:self, whose "
      "name ends as ontology files do (.ttl, .owl, .omn ...); then KEY=VALUE for each attribute, such as "
      "battery='80 %'");
  command->add_flag("--none", said->is_end, "Withdraw the description");
  command->footer(
      "The description holds until it is changed or the daemon ends; gemingad --describe sets it from the start. State "
      "what\n"
      "changes often as an attribute. The daemon takes at most four changes a second.\n\n"
      "Examples:\n  geminga-query describe 'Robot and hasPart some Gripper' battery='80 %'\n"
      "  geminga-query describe robot.ttl\n"
      "  geminga-query describe battery='79 %'\n  geminga-query describe --none");
  command->callback([said, &selected] {
    selected = [one = read_description(*said)](const Context& context, Client& client) {
      if (refuses_watch(context, "describe")) return shell::ExitStatus::wrong_use;
      std::optional<std::string> expression = one.first;
      if (expression && syntax::is_ontology_name(*expression)) {
        const auto ontology = client.query("ontology");
        if (!ontology) return shell::report(program, ontology.error());
        expression = ask_ontology_program("describe", *expression, files_of(*ontology), max_answer_bytes);
        if (!expression) return shell::ExitStatus::wrong_use;
        if (expression->ends_with('\n')) expression->pop_back();
      }
      const auto done = client.describe(expression, one.second);
      return done ? shell::ExitStatus::found : shell::report(program, done.error());
    };
  });
}

}  // namespace geminga::query
