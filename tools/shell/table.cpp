#include "shell/table.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace geminga::shell {
namespace {

constexpr std::size_t gap = 2;

/// The width of a table with these columns; a width of 0 is a column that is not shown.
std::size_t total(const std::vector<std::size_t>& widths) {
  std::size_t sum = 0;
  for (const std::size_t width : widths) sum += width == 0 ? 0 : width + (sum == 0 ? 0 : gap);
  return sum;
}

/// Leaves out the columns of the greatest ranks until the rest fits with these least widths. Returns their titles.
std::vector<std::string> leave_out(std::vector<std::size_t>& widths, const std::vector<std::size_t>& least,
                                   const std::vector<Column>& columns, std::size_t available) {
  std::vector<std::string> titles;
  while (true) {
    std::vector<std::size_t> narrow = least;
    std::size_t next = columns.size();
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (widths[i] == 0) narrow[i] = 0;
      const bool may_go = widths[i] > 0 && columns[i].rank > 0;
      if (may_go && (next == columns.size() || columns[i].rank > columns[next].rank)) next = i;
    }
    if (total(narrow) <= available || next == columns.size()) return titles;
    widths[next] = 0;
    if (!columns[next].title.empty()) titles.push_back(columns[next].title);
  }
}

/// Narrows the widest column that is above its least width, until the line fits or none can be narrowed.
void narrow(std::vector<std::size_t>& widths, const std::vector<std::size_t>& least, std::size_t available) {
  for (std::size_t sum = total(widths); sum > available; --sum) {
    std::size_t widest = widths.size();
    for (std::size_t i = 0; i < widths.size(); ++i) {
      if (widths[i] <= least[i]) continue;
      if (widest == widths.size() || widths[i] > widths[widest]) widest = i;
    }
    if (widest == widths.size()) return;
    --widths[widest];
  }
}

/// The longest word that is kept whole though a column is left out for it.
constexpr std::size_t longest_whole_word = 32;

std::size_t width_of(const std::vector<std::string>& lines) {
  std::size_t widest = 0;
  for (const std::string& line : lines) widest = std::max(widest, width(line));
  return widest;
}

}  // namespace

void Table::add(std::initializer_list<std::string_view> cells) {
  auto& row = rows_.emplace_back();
  for (const std::string_view cell : cells) row.push_back(printable(cell));
}

std::vector<std::size_t> Table::natural_widths() const {
  std::vector<std::size_t> widths(columns_.size());
  for (const auto& row : rows_) {
    for (std::size_t i = 0; i < columns_.size(); ++i) widths[i] = std::max(widths[i], width(row[i]));
  }
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (widths[i] > 0) widths[i] = std::max(widths[i], width(columns_[i].title));
  }
  return widths;
}

std::vector<std::size_t> Table::word_widths(const std::vector<std::size_t>& natural) const {
  std::vector<std::size_t> widths = natural;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (columns_[i].narrowest == 0) continue;
    std::size_t longest = std::max(columns_[i].narrowest, width(columns_[i].title));
    for (const auto& row : rows_) longest = std::max(longest, std::min(longest_word(row[i]), longest_whole_word));
    widths[i] = std::min(natural[i], longest);
  }
  return widths;
}

Table::Layout Table::layout_for(const Terminal& terminal) const {
  Layout layout{.widths = natural_widths(), .left_out = {}, .heading = columns_.size()};
  auto& widths = layout.widths;
  if (terminal.columns == 0 || total(widths) <= terminal.columns) return layout;
  const auto found = std::ranges::find_if(columns_, &Column::is_heading);
  const auto heading = static_cast<std::size_t>(found - columns_.begin());
  if (found != columns_.end() && widths[heading] > 0) {
    layout.heading = heading;
    layout.indent = gap;
    widths[heading] = 0;
  }
  const std::size_t available = terminal.columns - std::min(terminal.columns, layout.indent);
  const std::vector<std::size_t> words = word_widths(widths);
  std::vector<std::size_t> narrowest = widths;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (columns_[i].narrowest > 0) narrowest[i] = std::min(narrowest[i], columns_[i].narrowest);
  }
  layout.left_out = leave_out(widths, words, columns_, available);
  narrow(widths, words, available);
  narrow(widths, narrowest, available);
  return layout;
}

void Table::print_cells(std::ostream& out, const Terminal& terminal, const std::vector<Placed>& cells) {
  std::size_t height = 0;
  for (const Placed& cell : cells) height = std::max(height, cell.lines.size());
  for (std::size_t row = 0; row < height; ++row) {
    std::string text;
    for (const Placed& cell : cells) {
      if (row >= cell.lines.size()) continue;
      const std::string& part = cell.lines[row];
      const std::size_t padding = cell.is_right_aligned ? cell.width - std::min(cell.width, width(part)) : 0;
      text.append(cell.begin + padding - std::min(cell.begin + padding, width(text)), ' ');
      text += part;
    }
    text.erase(text.find_last_not_of(' ') + 1);
    out << coloured(terminal, Colour::bold, encoded(terminal, text)) << '\n';
  }
}

bool Table::is_torn(const Terminal& terminal, const Layout& layout) const {
  if (terminal.columns == 0) return false;
  Row titles;
  for (const Column& column : columns_) titles.push_back(column.title);
  if (placed(terminal, layout, titles).size() > 1) return true;
  const auto torn =
      std::ranges::count_if(rows_, [&](const Row& row) { return placed(terminal, layout, row).size() > 1; });
  return static_cast<std::size_t>(torn) * 2 > rows_.size();
}

void Table::print(std::ostream& out, const Terminal& terminal, std::string_view above) const {
  if (rows_.empty()) return;
  out << above;
  const Layout layout = layout_for(terminal);
  if (is_torn(terminal, layout)) return print_blocks(out, terminal, layout);
  const auto print_row = [&](const Terminal& colours, const Row& cells) {
    for (const auto& beside : placed(terminal, layout, cells)) print_cells(out, colours, beside);
  };
  Row titles;
  for (const Column& column : columns_) titles.push_back(column.title);
  print_row(terminal, titles);
  Terminal plain = terminal;
  plain.has_colour = false;
  print_groups(out, terminal, layout, "", [&](const Row& row) {
    Row cells = row;
    for (auto& cell : cells) {
      if (cell.empty()) cell.assign(1, '-');
    }
    print_row(plain, cells);
  });
  if (layout.left_out.empty()) return;
  std::string note = "Not shown here:";
  for (const std::string& title : layout.left_out) note += (title == layout.left_out.front() ? " " : ", ") + title;
  note += " (a wider terminal or --json shows all)";
  for (const std::string& line : wrapped(note, terminal.columns)) out << coloured(terminal, Colour::dim, line) << '\n';
}

template <typename PrintRow>
void Table::print_groups(std::ostream& out, const Terminal& terminal, const Layout& layout, std::string_view between,
                         PrintRow print) const {
  const bool has_headings = layout.heading < columns_.size();
  std::vector<std::pair<std::string_view, std::vector<const Row*>>> groups{{"", {}}};
  std::map<std::string_view, std::size_t> places{{"", 0}};
  for (const Row& row : rows_) {
    const std::string_view heading = has_headings ? std::string_view(row[layout.heading]) : "";
    const auto [place, is_new] = places.try_emplace(heading, groups.size());
    if (is_new) groups.emplace_back(heading, std::vector<const Row*>{});
    groups[place->second].second.push_back(&row);
  }
  std::string_view before;
  for (const auto& [heading, rows] : groups) {
    if (!heading.empty()) {
      out << std::exchange(before, "");
      for (const std::string& line : wrapped(heading, terminal.columns)) {
        out << coloured(terminal, Colour::yellow, encoded(terminal, line)) << '\n';
      }
    }
    for (const Row* row : rows) {
      out << std::exchange(before, between);
      print(*row);
    }
  }
}

void Table::print_blocks(std::ostream& out, const Terminal& terminal, const Layout& layout) const {
  std::size_t titles = 0;
  for (const Column& column : columns_) titles = std::max(titles, width(column.title));
  const std::size_t beside = layout.indent + titles + gap;
  // Where titles would take more than half of a line, each has a line of its own.
  const bool has_room = beside <= terminal.columns / 2;
  const std::size_t begin = has_room ? beside : layout.indent;
  print_groups(out, terminal, layout, "\n", [&](const Row& row) {
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const std::size_t first = row[i].find_first_not_of(' ');
      if (first == std::string::npos || row[i] == "-" || i == layout.heading) continue;
      std::string title = std::string(layout.indent, ' ') + columns_[i].title;
      if (has_room) title.append(begin - width(title), ' ');
      const std::vector<std::string> lines =
          wrapped(row[i].substr(first), std::max(terminal.columns, begin + 1) - begin);
      out << coloured(terminal, Colour::bold, encoded(terminal, title));
      if (!has_room) out << '\n' << std::string(begin, ' ');
      out << encoded(terminal, lines.front()) << '\n';
      for (std::size_t line = 1; line < lines.size(); ++line) {
        out << std::string(begin, ' ') << encoded(terminal, lines[line]) << '\n';
      }
    }
  });
}

std::vector<std::vector<Table::Placed>> Table::placed(const Terminal& terminal, const Layout& layout,
                                                      const Row& cells) const {
  const std::size_t limit = terminal.columns == 0 ? std::numeric_limits<std::size_t>::max() : terminal.columns;
  std::vector<std::vector<Placed>> groups(1);
  std::size_t begin = layout.indent;
  std::size_t taken = 0;  // the columns that the cells of the line take, and the gap behind them
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const std::size_t columns = layout.widths[i];
    if (columns == 0) continue;
    auto lines = wrapped(cells[i], std::min(std::max(columns, longest_word(cells[i])), limit));
    const std::size_t needed = std::min(width_of(lines), limit);
    std::size_t at = std::max(begin, taken);
    if (at + needed > limit) {
      if (!groups.back().empty()) groups.emplace_back();
      at = std::min(begin, limit - needed);
    }
    groups.back().push_back({at, columns, columns_[i].is_right_aligned, std::move(lines)});
    taken = at + std::max(needed, columns_[i].is_right_aligned ? columns : 0) + gap;
    begin += columns + gap;
  }
  return groups;
}

}  // namespace geminga::shell
