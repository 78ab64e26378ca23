// geminga-query requests: every known subscription, those without a provider, or publications without a subscription.
#include <memory>

#include "query/command.hpp"
#include "query/services.hpp"
#include "shell/describe.hpp"

namespace geminga::query {
namespace {

struct RequestsFlags {
  std::vector<std::string> words;
  bool unmatched = false;
  bool unused = false;
};

/// With `unmatched` nothing is served, so that no column says so.
shell::Table table_of_requests(const std::vector<Record>& records, bool unmatched) {
  shell::Table shown({{"CONSUMER", false, 12},
                      {"IDENTITY", false, 16},
                      {"MATCH", false, 0, 5},
                      {"MODE", false, 0, 3},
                      {"SERVED"},
                      {"PROVIDERS", false, 10, 4},
                      {"WHERE", false, 10, 2},
                      {"ALSO", false, 10, 2},
                      {"LIMIT", true, 0, 6},
                      {"AGE", true, 0, 7},
                      {"WHY", false, 20, 0, true},
                      {"REQUEST"}});
  const std::vector<std::string> reasons = shell::reasons_of(records);
  for (std::size_t one = 0; one < records.size(); ++one) {
    const Record& record = records[one];
    const auto limit = record["limit"] == "0" ? "" : std::string(record["limit"]);
    shown.add({shell::who(record["consumer"], record["name"], record["participant_name"]),
               shell::identity_words(record), record["match"], record["mode"],
               unmatched                 ? ""
               : record["served"] == "1" ? "yes"
                                         : "no",
               record["provider"], record["where"], request_words(record), limit, shell::duration_words(record["age"]),
               reasons[one], record["subscription"]});
  }
  return shown;
}

Listing listing_of_requests(const RequestsFlags& flags) {
  if (flags.unused) return services_listing(flags.words, true);
  Listing listing{"requests",
                  {},
                  read_filter(flags.words),
                  "subscription",
                  [unmatched = flags.unmatched](const auto& records) { return table_of_requests(records, unmatched); },
                  service_line,
                  flags.unmatched
                      ? "no such request is unmatched: each has a service"
                      : "no such request is known: geminga-query participants lists the hosts that are heard"};
  if (flags.unmatched) listing.parameters.emplace_back("unmatched", "1");
  return listing;
}

}  // namespace

void add_requests(CLI::App& app, Run& selected) {
  CLI::App* command = app.add_subcommand("requests", "List all known subscriptions");
  const auto flags = std::make_shared<RequestsFlags>();
  command->add_option("FILTER", flags->words, filter_meaning);
  CLI::Option* unmatched = command->add_flag("--unmatched", flags->unmatched, "Only those that nobody serves, and why");
  command->add_flag("--unused", flags->unused, "Instead, the publications that nobody asks for, and why")
      ->excludes(unmatched);
  command->footer(
      "Examples:\n  geminga-query requests\n  geminga-query requests --unmatched\n  geminga-query requests --unused "
      "robot2");
  command->callback([flags, &selected] {
    auto listing = listing_of_requests(*flags);  // throws where a word cannot be read
    selected = [listing = std::move(listing)](const Context& context, Client& client) {
      return show(context, client, listing);
    };
  });
}

}  // namespace geminga::query
