// Rows of different lengths in one flat array: a vector of vectors that costs less memory.
#ifndef GEMINGA_BASE_ROWS_HPP
#define GEMINGA_BASE_ROWS_HPP

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace geminga::base {

/// Immutable rows. Row r is items[begin[r] .. begin[r + 1]).
template <typename Item>
class Rows {
 public:
  Rows() = default;

  /// Sorts pairs of (row, item) into `row_count` rows. The items of a row keep their order. Linear.
  Rows(std::size_t row_count, std::span<const std::pair<std::uint32_t, Item>> pairs)
      : begin_(row_count + 1, 0), items_(pairs.size()) {
    for (const auto& [row, item] : pairs) ++begin_[row + 1];
    for (std::size_t row = 0; row < row_count; ++row) begin_[row + 1] += begin_[row];
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    for (const auto& [row, item] : pairs) items_[next[row]++] = item;
  }

  [[nodiscard]] std::size_t row_count() const { return begin_.empty() ? 0 : begin_.size() - 1; }
  [[nodiscard]] std::size_t item_count() const { return items_.size(); }
  /// The items of a row; none for a row that does not exist.
  [[nodiscard]] std::span<const Item> operator[](std::size_t row) const {
    if (row >= row_count()) return {};
    return std::span(items_).subspan(begin_[row], begin_[row + 1] - begin_[row]);
  }

  [[nodiscard]] std::span<Item> mutable_items() { return items_; }

  /// Sorts each row, and drops repeated items.
  void sort_unique() {
    std::uint32_t out = 0;
    for (std::size_t row = 0; row < row_count(); ++row) {
      const auto first = items_.begin() + begin_[row];
      const auto last = items_.begin() + begin_[row + 1];
      begin_[row] = out;
      std::sort(first, last);
      const auto unique_last = std::unique(first, last);
      for (auto item = first; item != unique_last; ++item) items_[out++] = *item;
    }
    if (!begin_.empty()) begin_.back() = out;
    items_.resize(out);
  }

 private:
  std::vector<std::uint32_t> begin_;
  std::vector<Item> items_;
};

}  // namespace geminga::base

#endif
