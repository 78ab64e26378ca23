// Lists that are kept in order.
#ifndef GEMINGA_BASE_SORTED_HPP
#define GEMINGA_BASE_SORTED_HPP

#include <algorithm>

namespace geminga::base {

/// Puts the items of a container in ascending order, and drops repeated ones.
void sort_unique(auto& items) {
  std::ranges::sort(items);
  const auto repeated = std::ranges::unique(items);
  items.erase(repeated.begin(), repeated.end());
}

}  // namespace geminga::base

#endif
