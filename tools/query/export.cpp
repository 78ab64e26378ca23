// geminga-query export: the living team as RDF.
#include <array>
#include <iostream>
#include <memory>
#include <string>
#include <utility>

#include "query/command.hpp"
#include "query/listing.hpp"
#include "query/triples/team_graph.hpp"
#include "shell/report.hpp"

namespace geminga::query {
namespace {

shell::ExitStatus print_team(const Context& context, Client& client, TripleSyntax syntax) {
  if (refuses_watch(context, "export")) return shell::ExitStatus::wrong_use;
  if (context.common.is_json) {
    shell::complain(program, "export writes RDF: leave --json out, or ask for participants, services and requests");
    return shell::ExitStatus::wrong_use;
  }
  Team team;
  const Parameters with_iris{{"iris", "1"}};
  auto descriptions = client.query("services", {{"iris", "1"}, {"mode", "participant"}});
  if (!descriptions) return shell::report(program, descriptions.error());
  team.descriptions = std::move(descriptions->records);
  for (const auto& [kind, records] : {std::pair("participants", &team.participants),
                                      std::pair("services", &team.services), std::pair("requests", &team.requests)}) {
    const bool has_names = records != &team.participants;
    auto answer = has_names ? client.query(kind, with_iris) : client.query(kind);
    if (!answer) return shell::report(program, answer.error());
    *records = std::move(answer->records);
  }
  std::cout << team_document(team, syntax);
  return team.participants.empty() ? shell::ExitStatus::nothing : shell::ExitStatus::found;
}

}  // namespace

void add_export(CLI::App& app, Run& selected) {
  CLI::App* command = app.add_subcommand("export", "Print the living team as RDF, for SPARQL with inference");
  auto format = std::make_shared<std::string>("turtle");
  command->add_option("--format", *format, "turtle or ntriples")
      ->type_name("FORMAT")
      ->check(CLI::IsMember({"turtle", "ntriples"}), "", "");
  command->footer(
      "Prints participants, what they offer and what they ask for, in the words of the shipped ontology team.ttl.\n\n"
      "Example:\n"
      "  geminga-query export | geminga-ontology query - /usr/local/share/geminga/ontology \\\n"
      "    'SELECT ?robot ?service WHERE { ?robot geminga:offers ?service . ?service geminga:provides ?it .\n"
      "                                    ?it a geminga:TrackedObject }'");
  command->callback([&selected, format] {
    selected = [format](const Context& context, Client& client) {
      return print_team(context, client, *format == "turtle" ? TripleSyntax::turtle : TripleSyntax::n_triples);
    };
  });
}

}  // namespace geminga::query
