#include "query/listing.hpp"

#include <iostream>

#include "shell/json.hpp"
#include "shell/report.hpp"

namespace geminga::query {

std::expected<std::vector<Record>, ClientError> ask(Client& client, const Listing& listing) {
  auto answer = client.query(listing.kind, listing.parameters);
  if (!answer) return std::unexpected(answer.error());
  if (listing.keeps) std::erase_if(answer->records, [&](const Record& record) { return !listing.keeps(record); });
  return std::move(answer->records);
}

shell::ExitStatus show(const Context& context, Client& client, const Listing& listing) {
  if (context.is_watching) return watch(context, client, listing);
  const auto records = ask(client, listing);
  if (!records) return shell::report(program, records.error());
  if (context.common.is_json) {
    shell::print(std::cout, shell::to_json(*records));
  } else if (records->empty()) {
    shell::complain(program, listing.nothing);
  } else {
    listing.table(*records).print(std::cout, context.terminal);
  }
  return records->empty() ? shell::ExitStatus::nothing : shell::ExitStatus::found;
}

bool refuses_watch(const Context& context, std::string_view command) {
  if (!context.is_watching) return false;
  shell::complain(program, "--watch does not go with " + std::string(command) +
                               ": it goes with participants, services, requests and match");
  return true;
}

}  // namespace geminga::query
