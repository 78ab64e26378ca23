#include "discovery/matching/arbitration/reason.hpp"

#include <array>
#include <utility>

namespace geminga::matching {

std::string_view to_string(Reason reason) {
  constexpr std::array<std::string_view, 7> words{"withdrawn", "expired", "left",       "outranked",
                                                  "changed",   "renamed", "unreachable"};
  static_assert(words.size() == std::to_underlying(Reason::unreachable) + 1U);
  return words.at(std::to_underlying(reason));
}

}  // namespace geminga::matching
