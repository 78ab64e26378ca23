// geminga-query ontology: what the daemon has loaded, and who on the air has something else.
#include <boost/json/array.hpp>
#include <boost/json/object.hpp>
#include <iostream>

#include "query/command.hpp"
#include "query/listing.hpp"
#include "shell/describe.hpp"
#include "shell/json.hpp"
#include "shell/report.hpp"
#include "shell/table.hpp"

namespace geminga::query {
namespace {

/// The lines of the answer by what they tell (src/discovery/participant/QUERIES.md).
struct Parts {
  Record head;
  std::vector<Record> files;
  std::vector<Record> left_out;
  std::vector<Record> gaps;
  std::vector<Record> others;
  std::vector<Record> failures;  ///< why the last reading failed
};

Parts parts_of(const Answer& answer) {
  Parts parts;
  for (const auto& record : answer.records) {
    if (!record["loaded"].empty()) {
      parts.head = record;
    } else if (!record["file"].empty()) {
      parts.files.push_back(record);
    } else if (!record["other"].empty()) {
      parts.others.push_back(record);
    } else if (!record["left_out"].empty()) {
      parts.left_out.push_back(record);
    } else if (!record["gap"].empty()) {
      parts.gaps.push_back(record);
    } else if (!record["failed"].empty()) {
      parts.failures.push_back(record);
    }
  }
  return parts;
}

void print_json(const Parts& parts) {
  boost::json::object object;
  const auto head = shell::to_json(parts.head);
  for (const auto* key : {"loaded", "digest", "classes"}) {
    if (head.contains(key)) object[key] = head.at(key);
  }
  if (!parts.head["complete"].empty()) object["complete"] = parts.head["complete"] == "1";
  object["contradiction"] = parts.head["contradiction"] == "1";
  boost::json::array left_out;
  for (const auto& record : parts.left_out) {
    auto row = shell::to_json(record);
    row["construct"] = row["left_out"];
    row.erase("left_out");
    left_out.push_back(std::move(row));
  }
  boost::json::array others;
  for (const auto& record : parts.others) {
    auto row = shell::to_json(record);
    row["participant"] = row["other"];
    row.erase("other");
    others.push_back(std::move(row));
  }
  object["files"] = shell::to_json(parts.files);
  object["left_out"] = std::move(left_out);
  boost::json::array gaps;
  for (const auto& record : parts.gaps) gaps.push_back(boost::json::string(record["gap"]));
  object["gaps"] = std::move(gaps);
  object["others"] = std::move(others);
  object["loading"] = parts.head["loading"] == "1";
  boost::json::array failures;
  for (const auto& record : parts.failures) failures.push_back(boost::json::string(record["failed"]));
  object["failed"] = std::move(failures);
  shell::print(std::cout, object);
}

void print_failures(const Context& context, const Parts& parts) {
  if (parts.failures.empty()) return;
  std::cout << coloured(context.terminal, shell::Colour::red, "Reading failed") << " "
            << shell::duration_words(parts.failures.front()["age"])
            << " ago; mend the files and send gemingad a SIGHUP:\n";
  for (const auto& record : parts.failures) std::cout << "  " << shell::printable(record["failed"]) << '\n';
  std::cout << '\n';
}

/// `geminga-ontology check` finds out which axioms it is.
void print_contradiction(const Context& context, const Parts& parts) {
  if (parts.head["contradiction"] != "1") return;
  std::cout << coloured(context.terminal, shell::Colour::red, "Contradiction: ")
            << "no world can be as these files say, so that no concept can be offered or asked for;\n"
               "geminga-ontology check FILES says why; mend them and send gemingad a SIGHUP.\n\n";
}

void print_words(const Context& context, const Parts& parts) {
  print_failures(context, parts);
  print_contradiction(context, parts);
  if (parts.head["loading"] == "1") std::cout << "Files are being read.\n\n";
  if (parts.head["loaded"] != "1") {
    if (parts.head["loading"] != "1" && parts.failures.empty()) {
      std::cout << "No ontology is loaded: start gemingad with --ontology FILE-OR-FOLDER\n";
    }
  } else {
    std::cout << shell::printable(parts.head["classes"]) << " classes, digest "
              << shell::printable(parts.head["digest"]) << "\n\n";
    shell::Table files({{"FILE", false, 20}, {"ONTOLOGY", false, 20, 1}});
    for (const auto& record : parts.files) files.add({std::string(record["file"]), std::string(record["iri"])});
    if (!files.is_empty()) files.print(std::cout, context.terminal);
  }
  shell::Table left_out({{"LEFT OUT", false, 20}, {"COUNT", true}, {"FIRST", false, 20}});
  for (const auto& record : parts.left_out) {
    left_out.add({std::string(record["left_out"]), std::string(record["count"]), std::string(record["first"])});
  }
  if (!left_out.is_empty()) {
    std::cout << "\nNot used by the reasoner:\n";
    left_out.print(std::cout, context.terminal);
  }
  if (!parts.gaps.empty()) std::cout << "\nNot searched to the end:\n";
  for (const auto& record : parts.gaps) std::cout << "  " << shell::printable(record["gap"]) << '\n';
  if (parts.head["complete"] == "1") std::cout << "\nComplete: everything that follows from these files was found.\n";
  shell::Table others({{"PARTICIPANT"}, {"NAME", false, 8}, {"ONTOLOGY"}});
  for (const auto& record : parts.others) {
    others.add({std::string(record["other"]), std::string(record["name"]), std::string(record["ontology"])});
  }
  if (!others.is_empty()) {
    std::cout << "\nParticipants with another ontology:\n";
    others.print(std::cout, context.terminal);
  }
}

}  // namespace

void add_ontology(CLI::App& app, Run& selected) {
  CLI::App* command = app.add_subcommand("ontology", "What is loaded, what of it is not used, who has another one");
  command->footer("Example: geminga-query ontology\nExit status 0: one is loaded; 1: none is.");
  command->callback([&selected] {
    selected = [](const Context& context, Client& client) {
      if (refuses_watch(context, "ontology")) return shell::ExitStatus::wrong_use;
      const auto answer = client.query("ontology");
      if (!answer) return shell::report(program, answer.error());
      const Parts parts = parts_of(*answer);
      if (context.common.is_json) {
        print_json(parts);
      } else {
        print_words(context, parts);
      }
      return parts.head["loaded"] == "1" ? shell::ExitStatus::found : shell::ExitStatus::nothing;
    };
  });
}

}  // namespace geminga::query
