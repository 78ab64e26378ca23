// geminga-query services: every known publication.
#include "query/services.hpp"

#include <memory>

#include "query/filter.hpp"
#include "shell/describe.hpp"

namespace geminga::query {
namespace {

shell::Table table(const std::vector<Record>& records) {
  shell::Table shown({{"PROVIDER", false, 10},
                      {"IDENTITY", false, 24},
                      {"MODE"},
                      {"ADDRESS"},
                      {"PROTOCOL"},
                      {"PRIO", true},
                      {"AGE", true},
                      {"USED"},
                      {"SERVICE"},
                      {"ATTRIBUTES", false, 10}});
  for (const auto& record : records) {
    const auto protocol = record["protocol"] == "udp" ? "" : std::string(record["protocol"]);
    shown.add({shell::who(record["provider"], record["name"], record["participant_name"]),
               shell::identity_words(record), std::string(record["mode"]),
               shell::place(record["address"], record["port"]), protocol, std::string(record["priority"]),
               shell::duration_words(record["age"]), record["used"] == "1" ? "yes" : "no",
               std::string(record["service"]), shell::attribute_words(record.attributes)});
  }
  return shown;
}

}  // namespace

std::string service_line(const Record& record) {
  const bool is_service = !record["service"].empty();
  std::string line =
      shell::who(record[is_service ? "provider" : "consumer"], record["name"], record["participant_name"]);
  line += "  " + shell::identity_words(record);
  if (!record["degree"].empty()) line += "  " + std::string(record["degree"]) + ' ' + std::string(record["distance"]);
  line += "  " + std::string(record["mode"]);
  const std::string where = shell::place(record["address"], record["port"]);
  if (!where.empty()) line += "  " + where;
  if (!record.attributes.empty()) line += "  " + shell::attribute_words(record.attributes);
  return line + "  " + std::string(record[is_service ? "service" : "subscription"]);
}

Listing services_listing(std::vector<std::pair<std::string, std::string>> parameters,
                         std::function<bool(const Record&)> keeps) {
  return {"services",
          std::move(parameters),
          std::move(keeps),
          "service",
          table,
          service_line,
          "no such service is known: see geminga-query participants for who is heard at all"};
}

void add_services(CLI::App& app, Run& selected) {
  CLI::App* command = app.add_subcommand("services", "Every known publication");
  const auto words = std::make_shared<std::vector<std::string>>();
  command->add_option("FILTER", *words, filter_meaning);
  command->footer(
      "Examples:\n  geminga-query services\n  geminga-query services robot2 mode=otm/stream\n"
      "  geminga-query services concept=soccer:TrackedObject rate=30");
  command->callback([words, &selected] {
    selected = [words](const Context& context, Client& client) {
      Filter filter = read_filter(*words);
      return show(context, client, services_listing(std::move(filter.parameters), std::move(filter.keeps)));
    };
  });
}

}  // namespace geminga::query
