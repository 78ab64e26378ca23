// The FILTER words of services and requests.
#ifndef GEMINGA_QUERY_FILTER_HPP
#define GEMINGA_QUERY_FILTER_HPP

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "geminga/client.hpp"

namespace geminga::query {

/// For --help: what a FILTER is.
inline constexpr const char* filter_meaning =
    "Words that must all hold: KEY=VALUE compares a column or attribute (concept=C also finds what C subsumes), "
    "any other text must occur in a name, identity, address or attribute";

struct Filter {
  /// What the daemon decides: concept, representation, id, text, mode, provider.
  std::vector<std::pair<std::string, std::string>> parameters;
  /// What is decided here.
  std::function<bool(const Record&)> keeps;
};

[[nodiscard]] Filter read_filter(const std::vector<std::string>& words);

}  // namespace geminga::query

#endif
