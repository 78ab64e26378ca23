#include "reasoning/compiled/units_view.hpp"

#include <compare>

namespace geminga::compiled {
namespace {

/// How a name stands to two pieces together.
std::strong_ordering compare(std::string_view name, std::string_view head, std::string_view tail) {
  const auto by_head = name.substr(0, head.size()) <=> head;
  return by_head != 0 ? by_head : name.substr(head.size()) <=> tail;
}

}  // namespace

std::optional<std::uint32_t> UnitsView::find(std::string_view head, std::string_view tail) const {
  std::size_t begin = 0;
  std::size_t end = name_end.size();
  while (begin < end) {
    const std::size_t middle = begin + (end - begin) / 2;
    const auto order = compare(name(middle), head, tail);
    if (order == 0) return unit_of_name[middle];
    if (order < 0) {
      begin = middle + 1;
    } else {
      end = middle;
    }
  }
  return std::nullopt;
}

}  // namespace geminga::compiled
