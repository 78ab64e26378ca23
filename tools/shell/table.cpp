#include "shell/table.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace geminga::shell {
namespace {

constexpr std::size_t gap = 2;

/// Takes from the widest column that may be cut, until the line fits or nothing more can be taken.
void fit(std::vector<std::size_t>& widths, const std::vector<Column>& columns, std::size_t available) {
  const auto shown = static_cast<std::size_t>(std::ranges::count_if(widths, [](std::size_t w) { return w > 0; }));
  const std::size_t gaps = shown == 0 ? 0 : (shown - 1) * gap;
  for (std::size_t total = std::accumulate(widths.begin(), widths.end(), gaps); total > available; --total) {
    std::size_t widest = columns.size();
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (columns[i].narrowest == 0 || widths[i] <= columns[i].narrowest) continue;
      if (widest == columns.size() || widths[i] > widths[widest]) widest = i;
    }
    if (widest == columns.size()) return;
    --widths[widest];
  }
}

}  // namespace

void Table::add(std::vector<std::string> cells) {
  for (auto& cell : cells) cell = printable(cell);
  rows_.push_back(std::move(cells));
}

void Table::print(std::ostream& out, const Terminal& terminal) const {
  std::vector<std::size_t> widths(columns_.size());
  for (const auto& row : rows_) {
    for (std::size_t i = 0; i < columns_.size(); ++i) widths[i] = std::max(widths[i], width(row[i]));
  }
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (widths[i] > 0) widths[i] = std::max(widths[i], width(columns_[i].title));
  }
  if (terminal.columns > 0) fit(widths, columns_, terminal.columns);

  const auto line = [&](const auto& cell_of) {
    std::string text;
    std::size_t behind = 0;  // spaces that are owed before the next cell
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      if (widths[i] == 0) continue;
      const std::string cell = shortened(cell_of(i), widths[i]);
      const std::size_t padding = widths[i] - width(cell);
      const bool is_right = columns_[i].is_right_aligned;
      text.append(behind + (is_right ? padding : 0), ' ');
      text += cell;
      behind = gap + (is_right ? 0 : padding);
    }
    text.erase(text.find_last_not_of(' ') + 1);
    return text;
  };
  out << coloured(terminal, Colour::bold, line([&](std::size_t i) { return columns_[i].title; })) << '\n';
  for (const auto& row : rows_) {
    out << line([&](std::size_t i) { return row[i].empty() ? std::string("-") : row[i]; }) << '\n';
  }
}

}  // namespace geminga::shell
