// A command that lists records: once as a table or document, or on and on as changes.
#ifndef GEMINGA_QUERY_LISTING_HPP
#define GEMINGA_QUERY_LISTING_HPP

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "geminga/client.hpp"
#include "query/command.hpp"
#include "query/filter.hpp"
#include "shell/table.hpp"

namespace geminga::query {

struct Listing {
  std::string kind;
  std::vector<std::pair<std::string, std::string>> parameters;
  /// Which records of the answer are shown.
  Filter filter;
  /// The field that names a record for as long as it is there.
  std::string key;
  std::function<shell::Table(const std::vector<Record>&)> table;
  /// One record as one line, for --watch.
  std::function<std::string(const Record&)> line;
  /// What to say where there is nothing, and what to do.
  std::string nothing;
  /// The same as the daemon knows it; empty where it does not.
  std::function<std::string(Client&)> reason{};
};

/// The records of the listing as they are now.
[[nodiscard]] std::expected<std::vector<Record>, ClientError> ask(Client& client, const Listing& listing);

/// Prints the listing, or with --watch its changes until the end.
[[nodiscard]] shell::ExitStatus show(const Context& context, Client& client, const Listing& listing);

/// Prints what is there and every change until a signal (found) or the daemon's end (no_daemon).
[[nodiscard]] shell::ExitStatus watch(const Context& context, Client& client, const Listing& listing);

/// Refuses --watch for a command that answers once.
[[nodiscard]] bool refuses_watch(const Context& context, std::string_view command);

}  // namespace geminga::query

#endif
