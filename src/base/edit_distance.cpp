// Three rows of the table of distances between beginnings: the row that is filled, and the two above it.
#include "base/edit_distance.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace geminga::base {
namespace {

using Row = std::array<std::uint8_t, max_compared_bytes + 1>;

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool is_same(char a, char b) { return lower(a) == lower(b); }

}  // namespace

std::size_t edit_distance(std::string_view a, std::string_view b, std::size_t limit) {
  if (a.size() > b.size()) std::swap(a, b);
  if (b.size() - a.size() > limit || b.size() > max_compared_bytes) return limit + 1;
  Row rows[3];
  Row* before = &rows[0];
  Row* last = &rows[1];
  Row* row = &rows[2];
  for (std::size_t i = 0; i <= a.size(); ++i) (*last)[i] = static_cast<std::uint8_t>(i);
  for (std::size_t j = 1; j <= b.size(); ++j) {
    (*row)[0] = static_cast<std::uint8_t>(j);
    std::size_t least = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
      const unsigned change = is_same(a[i - 1], b[j - 1]) ? 0 : 1;
      unsigned steps = std::min({(*last)[i] + 1U, (*row)[i - 1] + 1U, (*last)[i - 1] + change});
      const bool is_swapped = i > 1 && j > 1 && is_same(a[i - 1], b[j - 2]) && is_same(a[i - 2], b[j - 1]);
      if (is_swapped) steps = std::min(steps, (*before)[i - 2] + 1U);
      (*row)[i] = static_cast<std::uint8_t>(steps);
      least = std::min<std::size_t>(least, steps);
    }
    if (least > limit) return limit + 1;
    std::swap(before, last);
    std::swap(last, row);
  }
  return std::min<std::size_t>((*last)[a.size()], limit + 1);
}

std::size_t tolerated_slips(std::string_view word) { return std::min<std::size_t>(3, word.size() / 3); }

}  // namespace geminga::base
