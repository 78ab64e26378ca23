// Texts that are lists with commas.
#ifndef GEMINGA_DISCOVERY_MATCHING_ITEMS_HPP
#define GEMINGA_DISCOVERY_MATCHING_ITEMS_HPP

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace geminga::matching {

/// How many octets of an item an error shows.
inline constexpr std::size_t max_shown_item = 60;

[[nodiscard]] inline std::string_view without_blanks(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text;
}

/// Takes the first item off a list, and gives it without the blanks around it.
[[nodiscard]] inline std::string_view take_item(std::string_view& list) {
  const auto comma = std::min(list.find(','), list.size());
  const std::string_view item = without_blanks(list.substr(0, comma));
  list.remove_prefix(std::min(comma + 1, list.size()));
  return item;
}

}  // namespace geminga::matching

#endif
