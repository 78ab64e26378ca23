// geminga-query ontology: the ontology that the daemon has loaded, and participants with another one.
#include "answers/ontology.hpp"

#include <iostream>
#include <memory>

#include "query/align.hpp"
#include "query/command.hpp"
#include "query/listing.hpp"
#include "shell/describe.hpp"
#include "shell/json.hpp"
#include "shell/report.hpp"
#include "shell/table.hpp"

namespace geminga::query {
namespace {

using answers::Ontology;

/// Prints the text of each record below a heading.
void print_lines(const Context& context, const std::vector<Record>& records, std::string_view key) {
  for (const auto& record : records) {
    shell::print_wrapped(std::cout, context.terminal, shell::printable(record[key]), 2);
  }
}

void print_failures(const Context& context, const Ontology& parts) {
  if (parts.failures.empty()) return;
  std::cout << coloured(context.terminal, shell::Colour::red, "Reading failed") << " "
            << shell::duration_words(parts.failures.front()["age"])
            << " ago; mend the files and send gemingad a SIGHUP:\n";
  print_lines(context, parts.failures, "failed");
  std::cout << '\n';
}

void print_contradiction(const Context& context, const Ontology& parts) {
  if (parts.head["contradiction"] != "1") return;
  std::cout << coloured(context.terminal, shell::Colour::red, "Contradiction:") << '\n';
  shell::print_wrapped(std::cout, context.terminal,
                       "no world can be as these files say, so that no concept can be offered or asked for; "
                       "geminga-ontology check FILES says why; mend them and send gemingad a SIGHUP.",
                       2);
  std::cout << '\n';
}

void print_words(const Context& context, const Ontology& parts) {
  print_failures(context, parts);
  print_contradiction(context, parts);
  if (parts.head["loading"] == "1") std::cout << "Files are being read.\n\n";
  if (parts.head["loaded"] != "1") {
    if (parts.head["loading"] != "1" && parts.failures.empty()) {
      shell::print_wrapped(std::cout, context.terminal,
                           "No ontology is loaded: start gemingad with --ontology FILE-OR-FOLDER");
    }
  } else {
    std::cout << shell::printable(parts.head["classes"]) << " classes, digest "
              << shell::printable(parts.head["digest"]) << "\n\n";
    shell::Table files({{"FILE", false, 20}, {"ONTOLOGY", false, 20, 1}});
    for (const auto& record : parts.files) files.add({record["file"], record["iri"]});
    files.print(std::cout, context.terminal);
  }
  shell::Table left_out({{"LEFT OUT", false, 20}, {"COUNT", true}, {"FIRST", false, 20}});
  for (const auto& record : parts.left_out) {
    left_out.add({record["left_out"], record["count"], record["first"]});
  }
  left_out.print(std::cout, context.terminal, "\nNot used by the reasoner:\n");
  if (!parts.gaps.empty()) std::cout << "\nWhere the search was not finished:\n";
  print_lines(context, parts.gaps, "gap");
  if (parts.head["complete"] == "1") {
    std::cout << '\n';
    shell::print_wrapped(std::cout, context.terminal, "Complete: everything that follows from these files was found.");
  }
  shell::Table others({{"PARTICIPANT"}, {"NAME", false, 8}, {"ONTOLOGY"}});
  for (const auto& record : parts.others) {
    others.add({record["other"], record["name"], record["ontology"]});
  }
  others.print(std::cout, context.terminal, "\nParticipants with another ontology:\n");
}

}  // namespace

void add_ontology(CLI::App& app, Run& selected) {
  CLI::App* command = app.add_subcommand(
      "ontology", "Show the loaded ontology, what of it is not used, and the participants that have another one");
  const auto flags = std::make_shared<AlignFlags>();
  CLI::Option* participant =
      command
          ->add_option(
              "--align", flags->participant,
              "Fetch the ontology that this participant offers by geminga-ontology serve, link it with the one loaded "
              "here, and show what would be understood")
          ->type_name("PARTICIPANT");
  command->add_option("-o,--output", flags->folder, "The folder to make, with their ontology and the links")
      ->type_name("FOLDER")
      ->needs(participant);
  command->add_flag("--open", flags->is_open, "Also where the team has no key")->needs(participant);
  command
      ->add_flag("--conservative", flags->is_conservative,
                 "Leave out links by which something new follows within one ontology")
      ->needs(participant);
  command->add_flag("--subsumptions", flags->has_subsumptions, "Also link what is narrower or broader")
      ->needs(participant);
  command->footer(
      "Links are guesses by names and structure. They are not in force until a person has read them and given the "
      "folder\n"
      "to the daemon; the output says how. Conversions are never guessed.\n"
      "Examples:\n  geminga-query ontology\n  geminga-query ontology --align rescue1 -o rescue/\n"
      "Exit status 0: an ontology is loaded, or there are links; 1: none is loaded, or there are no links.");
  command->callback([&selected, flags] {
    if (!flags->participant.empty() && flags->folder.empty())
      throw CLI::ValidationError("-o", "names the folder for their ontology and the links: give it");
    selected = [flags](const Context& context, Client& client) {
      if (!flags->participant.empty())
        return refuses_watch(context, "ontology") ? shell::ExitStatus::wrong_use : align(context, client, *flags);
      return show_once(context, client, "ontology", {}, [&](const Answer& answer) {
        const Ontology parts = answers::ontology_of(answer);
        if (context.common.is_json) {
          shell::print(std::cout, answers::ontology_document(parts));
        } else {
          print_words(context, parts);
        }
        return parts.head["loaded"] == "1" ? shell::ExitStatus::found : shell::ExitStatus::nothing;
      });
    };
  });
}

}  // namespace geminga::query
