// The FILTER words of services and requests.
#ifndef GEMINGA_QUERY_FILTER_HPP
#define GEMINGA_QUERY_FILTER_HPP

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "geminga/client.hpp"

namespace geminga::query {

/// For --help: what a FILTER is.
inline constexpr const char* filter_meaning =
    "Words that must all hold: KEY=VALUE compares a column or attribute (concept=C also finds what C subsumes), "
    "prefix:Name finds what it subsumes and where it occurs, any other text must occur in a name, identity, address or "
    "attribute";

struct Filter {
  /// What the daemon decides: concept, representation, id, text, mode, provider.
  std::vector<std::pair<std::string, std::string>> parameters;
  /// Columns or attributes and what they must be.
  std::vector<std::pair<std::string, std::string>> values;
  /// What must occur somewhere.
  std::vector<std::string> texts;
  /// Each stands for what the concept subsumes and for where the name occurs.
  std::vector<std::string> names;

  /// Whether values and texts hold.
  [[nodiscard]] bool keeps(const Record& record) const;
  /// The first key of values that none of the records has, or nothing.
  [[nodiscard]] std::string unknown_key(const std::vector<Record>& records) const;
};

[[nodiscard]] Filter read_filter(const std::vector<std::string>& words);

/// Whether the text occurs in a column or attribute.
[[nodiscard]] bool mentions(const Record& record, const std::string& text);

}  // namespace geminga::query

#endif
