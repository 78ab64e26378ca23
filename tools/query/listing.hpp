// The answers of commands: a listing of records, printed once or as changes with --watch, or a single answer.
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

using Parameters = std::vector<std::pair<std::string, std::string>>;

struct Listing {
  std::string kind;
  Parameters parameters;
  /// Selects the records that are shown.
  Filter filter;
  /// The field that names a record for its whole life.
  std::string key;
  std::function<shell::Table(const std::vector<Record>&)> table;
  /// One record as one line, for --watch.
  std::function<std::string(const Record&)> line;
  /// An error for an empty listing, with advice.
  std::string nothing;
  /// Asks the daemon for a better error; empty where it has none.
  std::function<std::string(Client&)> reason{};
  /// Whether a record is what was asked for; empty: each is. Where none is, nothing was found.
  std::function<bool(const Record&)> is_found{};
};

/// Asks for the records of the listing.
[[nodiscard]] std::expected<std::vector<Record>, ClientError> ask(Client& client, const Listing& listing);

/// Prints the listing, or with --watch its changes until the end.
[[nodiscard]] shell::ExitStatus show(const Context& context, Client& client, const Listing& listing);

/// Prints the records and every change until a signal (found) or the daemon's end (no_daemon).
[[nodiscard]] shell::ExitStatus watch(const Context& context, Client& client, const Listing& listing);

/// Refuses --watch for a command that answers once.
[[nodiscard]] bool refuses_watch(const Context& context, std::string_view command);

/// Asks once and gives the answer to `print`, which returns the exit status. Refuses --watch.
[[nodiscard]] shell::ExitStatus show_once(const Context& context, Client& client, const std::string& kind,
                                          const Parameters& parameters,
                                          const std::function<shell::ExitStatus(const Answer&)>& print);

}  // namespace geminga::query

#endif
