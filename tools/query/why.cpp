// geminga-query why: why a subscription and a publication match or do not.
#include <boost/json/object.hpp>
#include <iostream>
#include <memory>

#include "query/command.hpp"
#include "query/listing.hpp"
#include "shell/json.hpp"
#include "shell/report.hpp"
#include "shell/table.hpp"

namespace geminga::query {
namespace {

struct Pair {
  std::string subscription;
  std::string service;
};

/// A pair that fits, whose consumer has better ones.
bool is_outranked(const Answer& answer) { return answer.end["outranked"] == "1"; }

void print_json(const Pair& pair, const Answer& answer, bool is_match) {
  boost::json::object object{{"subscription", pair.subscription},
                             {"service", pair.service},
                             {"matches", is_match},
                             {"outranked", is_outranked(answer)}};
  for (const auto& member : shell::to_json(answer.end)) {
    if (member.key() == "degree" || member.key() == "distance") object[member.key()] = member.value();
  }
  object["checks"] = shell::to_json(answer.records);
  shell::print(std::cout, object);
}

void print_words(const Context& context, const Answer& answer, bool is_match) {
  std::cout << (is_match
                    ? coloured(context.terminal, shell::Colour::green, "yes") + ": they match"
                    : coloured(context.terminal, shell::Colour::red, "no") +
                          (is_outranked(answer) ? ": they would match, and others are better" : ": they do not match"));
  if (!answer.end["degree"].empty()) {
    std::cout << ", degree " << shell::printable(answer.end["degree"]) << ", distance "
              << shell::printable(answer.end["distance"]);
  }
  std::cout << '\n';
  shell::Table table({{"CHECK"}, {"OK"}, {"WHY", false, 20}});
  for (const auto& record : answer.records) {
    table.add({std::string(record["check"]), record["ok"] == "1" ? "yes" : "no", std::string(record["text"])});
  }
  if (!table.is_empty()) table.print(std::cout, context.terminal);
}

}  // namespace

void add_why(CLI::App& app, Run& selected) {
  CLI::App* command = app.add_subcommand("why", "Why a request and a service match or do not");
  const auto pair = std::make_shared<Pair>();
  command->add_option("SUBSCRIPTION", pair->subscription, "The word in the column REQUEST of geminga-query requests")
      ->required();
  command->add_option("SERVICE", pair->service, "The word in the column SERVICE of geminga-query services")->required();
  command->footer(
      "Example: geminga-query why 5e6f7a8b/2/1 1a2b3c4d/1/42\n"
      "Exit status 0: they match; 1: they do not, better ones take the places that the limit leaves, or one is not "
      "known.");
  command->callback([pair, &selected] {
    selected = [pair](const Context& context, Client& client) {
      if (refuses_watch(context, "why")) return shell::ExitStatus::wrong_use;
      const auto answer = client.query("why", {{"subscription", pair->subscription}, {"service", pair->service}});
      if (!answer) return shell::report(program, answer.error());
      const bool is_match = answer->end["matches"] == "1";
      if (context.common.is_json) {
        print_json(*pair, *answer, is_match);
      } else {
        print_words(context, *answer, is_match);
      }
      return is_match ? shell::ExitStatus::found : shell::ExitStatus::nothing;
    };
  });
}

}  // namespace geminga::query
