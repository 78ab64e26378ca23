#include "shell/table.hpp"

#include <algorithm>
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

/// The characters behind which a text may be broken, as behind a space.
constexpr std::string_view marks = "/,;|=";

/// The longest word that is kept whole though a column is left out for it.
constexpr std::size_t longest_whole_word = 32;

/// The longest part of a printable text that cannot be broken.
std::size_t longest_word(std::string_view text) {
  std::size_t longest = 0;
  while (!text.empty()) {
    const auto end = std::min(text.find_first_of(std::string(marks) + ' '), text.size());
    const bool is_marked = end < text.size() && text[end] != ' ';
    longest = std::max(longest, width(text.substr(0, end)) + (is_marked ? 1 : 0));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return longest;
}

/// The first `columns` characters of a printable text, and the rest.
std::pair<std::string_view, std::string_view> split(std::string_view text, std::size_t columns) {
  std::size_t at = 0;
  for (std::size_t count = 0; at < text.size() && count < columns; ++count) {
    ++at;
    while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xc0U) == 0x80U) ++at;
  }
  return {text.substr(0, at), text.substr(at)};
}

}  // namespace

std::vector<std::string> wrapped(std::string_view text, std::size_t columns) {
  std::vector<std::string> lines;
  while (width(text) > columns) {
    const auto [line, behind] = split(text, columns);
    // A space may be the first character that does not fit, since it is not printed.
    const auto space = behind.starts_with(' ') ? line.size() : line.rfind(' ');
    const auto mark = line.find_last_of(marks);
    std::size_t end = line.size();
    if (space != std::string_view::npos && space >= line.size() / 2) {
      end = space;
    } else if (mark != std::string_view::npos && mark + 1 >= line.size() / 2) {
      end = mark + 1;
    }
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(end);
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  }
  if (!text.empty() || lines.empty()) lines.emplace_back(text);
  return lines;
}

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

void Table::print(std::ostream& out, const Terminal& terminal, std::string_view above) const {
  if (rows_.empty()) return;
  out << above;
  std::vector<std::size_t> widths = natural_widths();
  std::vector<std::string> left_out;
  if (terminal.columns > 0) {
    const std::vector<std::size_t> words = word_widths(widths);
    std::vector<std::size_t> narrowest = widths;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      if (columns_[i].narrowest > 0) narrowest[i] = std::min(narrowest[i], columns_[i].narrowest);
    }
    left_out = leave_out(widths, words, columns_, terminal.columns);
    narrow(widths, words, terminal.columns);
    narrow(widths, narrowest, terminal.columns);
  }
  std::vector<std::string> titles;
  for (const Column& column : columns_) titles.push_back(column.title);
  print_row(out, terminal, widths, titles);
  Terminal plain = terminal;
  plain.has_colour = false;
  for (const auto& row : rows_) {
    std::vector<std::string> cells = row;
    for (auto& cell : cells) {
      if (cell.empty()) cell.assign(1, '-');
    }
    print_row(out, plain, widths, cells);
  }
  if (left_out.empty()) return;
  std::string note = "Not shown here:";
  for (const std::string& title : left_out) note += (title == left_out.front() ? " " : ", ") + title;
  note += " (a wider terminal or --json shows all)";
  for (const std::string& line : wrapped(note, terminal.columns)) out << coloured(terminal, Colour::dim, line) << '\n';
}

void Table::print_row(std::ostream& out, const Terminal& terminal, const std::vector<std::size_t>& widths,
                      const std::vector<std::string>& cells) const {
  std::vector<std::vector<std::string>> parts(columns_.size());
  std::size_t height = 0;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (widths[i] > 0) parts[i] = wrapped(cells[i], widths[i]);
    height = std::max(height, parts[i].size());
  }
  for (std::size_t row = 0; row < height; ++row) {
    std::string text;
    std::size_t behind = 0;  // spaces to print before the next cell
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      if (widths[i] == 0) continue;
      const std::string cell = row < parts[i].size() ? parts[i][row] : "";
      const std::size_t padding = widths[i] - std::min(widths[i], width(cell));
      const bool is_right = columns_[i].is_right_aligned;
      text.append(behind + (is_right ? padding : 0), ' ');
      text += cell;
      behind = gap + (is_right ? 0 : padding);
    }
    text.erase(text.find_last_not_of(' ') + 1);
    out << coloured(terminal, Colour::bold, encoded(terminal, text)) << '\n';
  }
}

}  // namespace geminga::shell
