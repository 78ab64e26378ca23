// The FILTER words of the commands services and requests.
#ifndef GEMINGA_QUERY_FILTER_HPP
#define GEMINGA_QUERY_FILTER_HPP

#include <string>
#include <utility>
#include <vector>

#include "geminga/client.hpp"

namespace geminga::query {

/// The meaning of FILTER, for --help.
inline constexpr const char* filter_meaning =
    "Words that must all hold: KEY=VALUE compares a column or attribute (concept=C also finds what C subsumes), "
    "prefix:Name finds what it subsumes and where it occurs, any other text must occur in a name, identity, address or "
    "attribute";

struct Filter {
  /// Parameters for the daemon: concept, representation, id, text, mode, provider.
  std::vector<std::pair<std::string, std::string>> parameters;
  /// Values that columns or attributes must have.
  std::vector<std::pair<std::string, std::string>> values;
  /// Texts that must occur in a column or attribute.
  std::vector<std::string> texts;
  /// Names of concepts. A record is kept where the concept subsumes its own, or where the name occurs.
  std::vector<std::string> names;

  /// Whether a record has the values and texts.
  [[nodiscard]] bool keeps(const Record& record) const;
  /// The first key of `values` that no record has; empty: there is none.
  [[nodiscard]] std::string unknown_key(const std::vector<Record>& records) const;
};

/// Throws CLI::ValidationError for a key of the daemon without a value.
[[nodiscard]] Filter read_filter(const std::vector<std::string>& words);

/// Whether the text occurs in a column or attribute.
[[nodiscard]] bool mentions(const Record& record, const std::string& text);

}  // namespace geminga::query

#endif
