// geminga-query participants: every known participant.
#include <cmath>

#include "query/command.hpp"
#include "query/listing.hpp"
#include "shell/describe.hpp"

namespace geminga::query {
namespace {

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
    const bool is_self = record["self"] == "1";
    std::string loss(record["loss"]);
    if (!loss.empty()) {
      const double share = std::strtod(loss.c_str(), nullptr);
      loss = std::to_string(std::lround(share * 100)) + " %";
    }
    shown.add({record["id"], record["name"], record["addresses"], shell::duration_words(record["heard"]),
               shell::duration_words(record["interval"]), loss, record["publications"], record["subscriptions"],
               record["ontology"],
               is_self                     ? "(this host)"
               : record["hears_us"] == "0" ? "(does not hear us)"
               : !record["path"].empty()   ? "(through " + std::string(record["path"]) + ")"
                                           : " "});
  }
  return shown;
}

std::string line(const Record& record) {
  return std::string(record["id"]) + "  " + std::string(record["name"]) + "  " + std::string(record["addresses"]) +
         "  " + std::string(record["publications"]) + " publications, " + std::string(record["subscriptions"]) +
         " subscriptions";
}

}  // namespace

void add_participants(CLI::App& app, Run& selected) {
  CLI::App* command = app.add_subcommand("participants", "Every known participant");
  command->footer("Example: geminga-query participants");
  command->callback([&selected] {
    selected = [](const Context& context, Client& client) {
      const Listing listing{"participants",
                            {},
                            {},
                            "id",
                            table_of_participants,
                            line,
                            "no participant is known: is the daemon still starting?"};
      return show(context, client, listing);
    };
  });
}

}  // namespace geminga::query
