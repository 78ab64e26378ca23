// geminga-query services: every known publication.
#include "query/services.hpp"

#include <memory>

#include "shell/describe.hpp"

namespace geminga::query {
namespace {

/// With `unused` nothing is used, so that no column says so.
/// " (through A/B, not reachable)", as far as there is something to say of the way to a host.
std::string way_words(const Record& record) {
  std::string words = record["hops"].empty() ? "" : "through " + std::string(record["path"]);
  if (record["reachable"] == "no") words += words.empty() ? "not reachable" : ", not reachable";
  return words.empty() ? "" : " (" + words + ')';
}

shell::Table table_of_services(const std::vector<Record>& records, bool unused) {
  shell::Table shown({{"PROVIDER", false, 12},
                      {"IDENTITY", false, 16},
                      {"MODE", false, 0, 3},
                      {"ADDRESS", false, 15, 1},
                      {"PROTOCOL", false, 0, 6},
                      {"PRIO", true, 0, 7},
                      {"AGE", true, 0, 8},
                      {"USED", false, 0, 5},
                      {"WHY", false, 20, 0, true},
                      {"SERVICE"},
                      {"ATTRIBUTES", false, 10, 4}});
  const std::vector<std::string> reasons = shell::reasons_of(records);
  for (std::size_t one = 0; one < records.size(); ++one) {
    const Record& record = records[one];
    const auto protocol = record["protocol"] == "udp" ? "" : std::string(record["protocol"]);
    shown.add({shell::who(record["provider"], record["name"], record["participant_name"]),
               shell::identity_words(record), std::string(record["mode"]),
               shell::place(record["address"], record["port"]) + way_words(record), protocol,
               std::string(record["priority"]), shell::duration_words(record["age"]),
               unused                  ? ""
               : record["used"] == "1" ? "yes"
                                       : "no",
               reasons[one], std::string(record["service"]), shell::attribute_words(record.attributes)});
  }
  return shown;
}

}  // namespace

std::string request_words(const Record& record) {
  std::string words;
  for (const char* key : {"convert", "protocol", "scope", "on", "favour", "prefer", "rank", "reach"}) {
    if (record[key].empty()) continue;
    const bool is_of_several = record[key].contains(' ');
    words += std::string(words.empty() ? "" : " ") + key + '=' + (is_of_several ? "\"" : "") +
             std::string(record[key]) + (is_of_several ? "\"" : "");
  }
  return words;
}

std::string service_line(const Record& record) {
  const bool is_service = !record["service"].empty();
  std::string line =
      shell::who(record[is_service ? "provider" : "consumer"], record["name"], record["participant_name"]);
  line += "  " + shell::identity_words(record);
  if (!record["degree"].empty()) line += "  " + std::string(record["degree"]) + ' ' + std::string(record["distance"]);
  line += "  " + std::string(record["mode"]);
  const std::string where = shell::place(record["address"], record["port"]);
  if (!where.empty()) line += "  " + where;
  line += way_words(record);
  if (!record.attributes.empty()) line += "  " + shell::attribute_words(record.attributes);
  if (!is_service && !record["where"].empty()) line += "  where=\"" + std::string(record["where"]) + '"';
  if (const std::string words = request_words(record); !is_service && !words.empty()) line += "  " + words;
  line += "  " + std::string(record[is_service ? "service" : "subscription"]);
  return record["because"].empty() ? line : line + "  " + std::string(record["because"]);
}

Listing services_listing(const std::vector<std::string>& words, bool unused) {
  Listing listing{"services",
                  {},
                  read_filter(words),
                  "service",
                  [unused](const auto& records) { return table_of_services(records, unused); },
                  service_line,
                  unused ? "no such service is unused: each has a request"
                         : "no such service is known: geminga-query participants lists the hosts that are heard"};
  if (unused) listing.parameters.emplace_back("unused", "1");
  return listing;
}

void add_services(CLI::App& app, Run& selected) {
  CLI::App* command = app.add_subcommand("services", "List all known publications");
  struct Flags {
    std::vector<std::string> words;
    bool unused = false;
  };
  const auto flags = std::make_shared<Flags>();
  command->add_option("FILTER", flags->words, filter_meaning);
  command->add_flag("--unused", flags->unused, "Only those that nobody asks for, and why");
  command->footer(
      "Examples:\n  geminga-query services\n  geminga-query services soccer:TrackedObject\n"
      "  geminga-query services robot2 mode=otm/stream\n"
      "  geminga-query services concept=soccer:TrackedObject protocol=udp\n  geminga-query services --unused");
  command->callback([flags, &selected] {
    auto listing = services_listing(flags->words, flags->unused);  // throws where a word cannot be read
    selected = [listing = std::move(listing)](const Context& context, Client& client) {
      return show(context, client, listing);
    };
  });
}

}  // namespace geminga::query
