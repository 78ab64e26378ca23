#include "query/listing.hpp"

#include <algorithm>
#include <iostream>
#include <set>

#include "base/edit_distance.hpp"
#include "shell/json.hpp"
#include "shell/report.hpp"

namespace geminga::query {
namespace {

using Records = std::vector<Record>;

std::expected<Records, ClientError> ask_daemon(Client& client, const Listing& listing, const std::string& name = {}) {
  auto parameters = listing.parameters;
  parameters.insert(parameters.end(), listing.filter.parameters.begin(), listing.filter.parameters.end());
  if (!name.empty()) parameters.emplace_back("concept", name);
  auto answer = client.query(listing.kind, parameters);
  if (!answer) return std::unexpected(answer.error());
  return std::move(answer->records);
}

/// Keeps the records that serve the concept of this name or in which the name occurs. An error where none is left and
/// the daemon does not know the name.
std::expected<void, ClientError> keep_named(Client& client, const Listing& listing, const std::string& name,
                                            Records& records) {
  const auto meant = ask_daemon(client, listing, name);
  if (!meant && meant.error().kind != ClientError::Kind::refused) return std::unexpected(meant.error());
  std::set<std::string, std::less<>> keys;
  if (meant) {
    for (const Record& record : *meant) keys.emplace(record[listing.key]);
  }
  std::erase_if(records,
                [&](const Record& record) { return !keys.contains(record[listing.key]) && !mentions(record, name); });
  if (records.empty() && !meant) return std::unexpected(meant.error());
  return {};
}

/// An error where the filter compares a key that no record has; empty where there is no such key.
std::string complaint_about_keys(const Listing& listing, const Records& all) {
  const std::string key = listing.filter.unknown_key(all);
  if (key.empty() || all.empty()) return {};
  std::set<std::string> there;
  for (const Record& record : all) {
    for (const auto& field : record.fields) there.insert(field.first);
    for (const auto& attribute : record.attributes) there.insert(attribute.first);
  }
  std::string text = "nothing that is known has a column or attribute '" + key + '\'';
  const auto near = std::ranges::find_if(there, [&](const std::string& name) {
    return base::edit_distance(name, key, base::tolerated_slips(key)) <= base::tolerated_slips(key);
  });
  if (near != there.end()) text += " (did you mean " + *near + "?)";
  text += ": there are";
  for (const auto& name : there) text += (name == *there.begin() ? " " : ", ") + name;
  return text;
}

/// Says that the daemon has not read its ontology, where that is so: what was stated by concept waits for it, unlisted.
std::string reason_of_ontology(Client& client) {
  const auto status = client.query("status", {});
  if (!status || status->records.empty() || status->records.front()["ontology_loading"].empty()) return {};
  return "the daemon is still reading its ontology, and lists what is stated by concept when it has: ask again";
}

}  // namespace

std::expected<Records, ClientError> ask(Client& client, const Listing& listing) {
  auto records = ask_daemon(client, listing);
  if (!records) return records;
  std::erase_if(*records, [&](const Record& record) { return !listing.filter.keeps(record); });
  for (const std::string& name : listing.filter.names) {
    if (auto kept = keep_named(client, listing, name, *records); !kept) return std::unexpected(kept.error());
  }
  return records;
}

shell::ExitStatus show(const Context& context, Client& client, const Listing& listing) {
  if (context.is_watching) return watch(context, client, listing);
  const auto records = ask(client, listing);
  if (!records) return shell::report(program, records.error());
  if (context.common.is_json) {
    shell::print(std::cout, shell::to_json(*records));
  } else if (!records->empty()) {
    listing.table(*records).print(std::cout, context.terminal);
  }
  if (listing.is_found ? std::ranges::any_of(*records, listing.is_found) : !records->empty()) {
    return shell::ExitStatus::found;
  }
  std::string why;
  if (!listing.filter.values.empty()) {
    if (const auto all = ask_daemon(client, listing)) why = complaint_about_keys(listing, *all);
  }
  if (why.empty()) why = reason_of_ontology(client);
  if (why.empty() && !context.common.is_json && listing.reason) why = listing.reason(client);
  if (!why.empty() || !context.common.is_json) shell::complain(program, why.empty() ? listing.nothing : why);
  return shell::ExitStatus::nothing;
}

bool refuses_watch(const Context& context, std::string_view command) {
  if (!context.is_watching) return false;
  shell::complain(program, "--watch does not go with " + std::string(command) +
                               ": it goes with participants, services, requests and match");
  return true;
}

shell::ExitStatus show_once(const Context& context, Client& client, const std::string& kind,
                            const Parameters& parameters,
                            const std::function<shell::ExitStatus(const Answer&)>& print) {
  if (refuses_watch(context, kind)) return shell::ExitStatus::wrong_use;
  const auto answer = client.query(kind, parameters);
  return answer ? print(*answer) : shell::report(program, answer.error());
}

}  // namespace geminga::query
