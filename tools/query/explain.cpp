// geminga-query explain: whether one concept is subsumed by another, and the axioms that entail it.
#include "answers/explain.hpp"

#include <iostream>
#include <memory>
#include <sstream>

#include "query/axioms.hpp"
#include "query/command.hpp"
#include "query/listing.hpp"
#include "shell/json.hpp"
#include "shell/report.hpp"

namespace geminga::query {
namespace {

using answers::Names;

void print_words(const Context& context, const Names& names, const Answer& answer, bool is_subsumed) {
  // The daemon says the names that it found in short.
  const auto name = [&](std::string_view key, const std::string& asked) {
    const std::string_view found = answer.end[key];
    return shell::printable(found.empty() ? std::string_view(asked) : found);
  };
  const std::string sub = name("sub", names.sub);
  const std::string super = name("super", names.super);
  if (!is_subsumed) {
    std::cout << coloured(context.terminal, shell::Colour::red, "no") << ": " << sub << " is not subsumed by " << super
              << '\n';
    std::istringstream lines{std::string(answer.end["text"])};
    for (std::string line; std::getline(lines, line);) std::cout << shell::printable(line) << '\n';
    return;
  }
  std::cout << coloured(context.terminal, shell::Colour::green, "yes") << ": " << sub << " is subsumed by " << super;
  if (answer.records.empty()) {
    std::cout << ", without any axiom\n";
    return;
  }
  std::cout << ", because\n";
  print_axioms(context, answer);
}

}  // namespace

void add_explain(CLI::App& app, Run& selected) {
  CLI::App* command =
      app.add_subcommand("explain", "Tell whether SUB is subsumed by SUPER, and the axioms that say so");
  const auto names = std::make_shared<Names>();
  command->add_option("SUB", names->sub, "prefix:Name, <IRI>, a label or a class expression")->required();
  command->add_option("SUPER", names->super, "prefix:Name, <IRI>, a label or a class expression")->required();
  command->footer(
      "Example: geminga-query explain soccer:SharedBallInfo soccer:TrackedObject\n"
      "Exit status 0: it is; 1: it is not; 2: a name is unknown.");
  command->callback([names, &selected] {
    selected = [names](const Context& context, Client& client) {
      const Parameters parameters{{"sub", names->sub}, {"super", names->super}};
      return show_once(context, client, "explain", parameters, [&](const Answer& answer) {
        const bool is_subsumed = answers::is_subsumed(answer);
        if (context.common.is_json) {
          shell::print(std::cout, answers::explain_document(*names, answer));
        } else {
          print_words(context, *names, answer, is_subsumed);
        }
        return is_subsumed ? shell::ExitStatus::found : shell::ExitStatus::nothing;
      });
    };
  });
}

}  // namespace geminga::query
