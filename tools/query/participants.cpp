// geminga-query participants: every known participant.
#include <CLI/CLI.hpp>
#include <boost/json/array.hpp>
#include <cmath>
#include <iostream>
#include <memory>
#include <string>
#include <utility>

#include "answers/explain.hpp"
#include "query/axioms.hpp"
#include "query/command.hpp"
#include "query/listing.hpp"
#include "query/near.hpp"
#include "shell/describe.hpp"
#include "shell/json.hpp"
#include "shell/report.hpp"

namespace geminga::query {
namespace {

/// A remark on a participant in a few words.
std::string remark_on(const Record& record) {
  if (record["self"] == "1") return "(this host)";
  if (record["hears_us"] == "0") return "(does not hear us)";
  const std::string way = record["path"].empty() ? "" : "through " + std::string(record["path"]);
  const std::string reach = record["reachable"] == "no" ? "not reachable" : "";
  if (way.empty() && reach.empty()) return " ";
  return '(' + way + (way.empty() || reach.empty() ? "" : ", ") + reach + ')';
}

shell::Table table_of_participants(const std::vector<Record>& records) {
  shell::Table shown({{"ID"},
                      {"NAME", false, 8},
                      {"ADDRESSES", false, 15, 1},
                      {"HEARD", true, 0, 2},
                      {"INTERVAL", true, 0, 8},
                      {"LOSS", true, 0, 7},
                      {"PUBS", true, 0, 4},
                      {"SUBS", true, 0, 5},
                      {"ONTOLOGY", false, 0, 6},
                      {"", false, 0, 3}});
  for (const auto& record : records) {
    std::string loss(record["loss"]);
    if (!loss.empty()) {
      const double share = std::strtod(loss.c_str(), nullptr);
      loss = std::to_string(std::lround(share * 100)) + " %";
    }
    shown.add({record["id"], record["name"], record["addresses"], shell::duration_words(record["heard"]),
               shell::duration_words(record["interval"]), loss, record["publications"], record["subscriptions"],
               record["ontology"], remark_on(record)});
  }
  return shown;
}

std::string line(const Record& record) {
  return std::string(record["id"]) + "  " + std::string(record["name"]) + "  " + std::string(record["addresses"]) +
         "  " + std::string(record["publications"]) + " publications, " + std::string(record["subscriptions"]) +
         " subscriptions";
}

/// Participants that an expression describes.
shell::Table table_of_described_participants(const std::vector<Record>& records) {
  shell::Table shown({{"ID"},
                      {"NAME", false, 8},
                      {"ADDRESSES", false, 15, 1},
                      {"HEARD", true, 0, 2},
                      {"DEGREE"},
                      {"DESCRIPTION", false, 16},
                      {"ATTRIBUTES", false, 10, 3}});
  for (const auto& record : records) {
    shown.add({record["id"], record["name"], record["addresses"], shell::duration_words(record["heard"]),
               record["degree"], record["description"], shell::attribute_words(record.attributes)});
  }
  return shown;
}

std::string described_line(const Record& record) {
  const std::string attributes = shell::attribute_words(record.attributes);
  return std::string(record["id"]) + "  " + std::string(record["name"]) + "  " + std::string(record["addresses"]) +
         "  " + std::string(record["description"]) + (attributes.empty() ? "" : "  " + attributes);
}

/// With the axioms by which each is known to be what was asked for.
shell::ExitStatus print_descriptions(const Context& context, Client& client, const Listing& listing,
                                     const std::string& expression) {
  if (refuses_watch(context, "--why")) return shell::ExitStatus::wrong_use;
  const auto records = ask(client, listing);
  if (!records) return shell::report(program, records.error());
  boost::json::array documents;
  for (const Record& record : *records) {
    const answers::Names names{std::string(record["description"]), expression};
    const auto answer = client.query("explain", {{"sub", names.sub}, {"super", names.super}});
    if (!answer) return shell::report(program, answer.error());
    if (context.common.is_json) {
      boost::json::object one = shell::to_json(record);
      one["why"] = answers::explain_document(names, *answer);
      documents.push_back(std::move(one));
    } else {
      std::cout << shell::printable(record["name"]) << "  " << record["id"] << "  "
                << shell::printable(record["description"]) << '\n';
      print_axioms(context, *answer);
    }
  }
  if (context.common.is_json) shell::print(std::cout, documents);
  if (!records->empty()) return shell::ExitStatus::found;
  if (!context.common.is_json) shell::complain(program, listing.nothing);
  return shell::ExitStatus::nothing;
}

struct DescribedFlags {
  std::string expression;
  std::string where;
  Degree degree = Degree::narrower;
  bool has_reasons = false;
  bool is_missing_wanted = false;
};

Listing participants_listing(const DescribedFlags& flags) {
  if (flags.expression.empty()) {
    return {"participants",
            {},
            {},
            "id",
            table_of_participants,
            line,
            "no participant is known: is the daemon still starting?"};
  }
  if (flags.is_missing_wanted) {
    Listing near = near_participants(flags.expression, flags.where);
    if (flags.degree != Degree::narrower) near.parameters.emplace_back("degree", to_string(flags.degree));
    return near;
  }
  Listing listing{
      "participants",
      {{"concept", flags.expression}},
      {},
      "id",
      table_of_described_participants,
      described_line,
      "no participant is known to satisfy that: geminga-query participants --json shows the description of each"};
  if (!flags.where.empty()) listing.parameters.emplace_back("where", flags.where);
  if (flags.degree != Degree::narrower) listing.parameters.emplace_back("degree", to_string(flags.degree));
  return listing;
}

}  // namespace

void add_participants(CLI::App& app, Run& selected) {
  CLI::App* command =
      app.add_subcommand("participants", "List all known participants, or those that an expression describes");
  const auto flags = std::make_shared<DescribedFlags>();
  command->add_option(
      "EXPRESSION", flags->expression,
      "A class or a class expression: only participants whose own description (gemingad --describe) is known to "
      "be below it");
  command->add_option("--where", flags->where, "Only those whose attributes fulfil this condition")
      ->type_name("CONDITION");
  shell::add_degree(*command, flags->degree);
  command->add_flag("--why", flags->has_reasons, "Also the axioms that say so, with file and line")
      ->excludes(
          command->add_flag("--missing", flags->is_missing_wanted,
                            "Also those that come near, with what they are not known to be and what contradicts"));
  command->footer(
      "Examples:\n  geminga-query participants\n  geminga-query participants 'canSee some WarmThing'\n"
      "  geminga-query participants 'hasPart some Gripper' --where 'battery >= 30 %'\n"
      "  geminga-query participants 'canSee some WarmThing' --why\n"
      "  geminga-query participants 'canSee some WarmThing' --missing\n"
      "  geminga-query --watch participants 'canSee some WarmThing'");
  command->callback([flags, &selected] {
    if (flags->expression.empty() &&
        (!flags->where.empty() || flags->has_reasons || flags->is_missing_wanted || flags->degree != Degree::narrower))
      throw CLI::RequiredError("EXPRESSION, of which --where, --degree, --why and --missing are told,");
    selected = [flags](const Context& context, Client& client) {
      const Listing listing = participants_listing(*flags);
      return flags->has_reasons ? print_descriptions(context, client, listing, flags->expression)
                                : show(context, client, listing);
    };
  });
}

}  // namespace geminga::query
