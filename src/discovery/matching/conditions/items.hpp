// Lists of items with commas.
#ifndef GEMINGA_DISCOVERY_MATCHING_CONDITIONS_ITEMS_HPP
#define GEMINGA_DISCOVERY_MATCHING_CONDITIONS_ITEMS_HPP

#include <algorithm>
#include <cstddef>
#include <string_view>

#include "base/text.hpp"

namespace geminga::matching {

/// How many octets of an item an error shows.
inline constexpr std::size_t max_shown_item = 60;

/// Takes the first item off a list and gives it without blanks around it.
[[nodiscard]] inline std::string_view take_item(std::string_view& list) {
  const auto comma = std::min(list.find(','), list.size());
  const std::string_view item = base::trimmed(list.substr(0, comma));
  list.remove_prefix(std::min(comma + 1, list.size()));
  return item;
}

}  // namespace geminga::matching

#endif
