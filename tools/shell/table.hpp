// An aligned table for a reader at a terminal.
#ifndef GEMINGA_SHELL_TABLE_HPP
#define GEMINGA_SHELL_TABLE_HPP

#include <initializer_list>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "shell/terminal.hpp"

namespace geminga::shell {

struct Column {
  std::string title;
  bool is_right_aligned = false;
  /// The least width where the terminal is too narrow: cells run over several lines then. Words are broken only where
  /// no other column can become narrower. 0: cells stay in one line.
  std::size_t narrowest = 0;
  /// Where the terminal is still too narrow, the column with the greatest rank is left out first; 0: never.
  unsigned rank = 0;
};

/// Makes cells printable. A column of empty cells is left out; other empty cells are shown as `-`.
///
/// On a terminal no line is longer than its width, unless even the columns of rank 0 do not fit at their narrowest. No
/// text is cut: long cells go on in the next line, and the columns that are left out are named below the table.
class Table {
 public:
  explicit Table(std::vector<Column> columns) : columns_(std::move(columns)) {}

  /// Adds a row. Requires as many cells as columns.
  void add(std::initializer_list<std::string_view> cells);
  /// Prints the rows under `above` and the titles in bold, with two spaces between columns and none at the end of a
  /// line. Prints nothing where there are no rows.
  void print(std::ostream& out, const Terminal& terminal, std::string_view above = {}) const;

 private:
  /// The width of each column's longest cell; 0 where all cells are empty.
  [[nodiscard]] std::vector<std::size_t> natural_widths() const;
  /// The least width of each column that breaks no word, unless that is too much.
  [[nodiscard]] std::vector<std::size_t> word_widths(const std::vector<std::size_t>& natural) const;
  void print_row(std::ostream& out, const Terminal& terminal, const std::vector<std::size_t>& widths,
                 const std::vector<std::string>& cells) const;

  std::vector<Column> columns_;
  std::vector<std::vector<std::string>> rows_;
};

/// Breaks a printable text into lines of at most `columns`, behind a space or one of `/ , ; | =` where one is in the
/// second half of a line. Returns at least one line. Requires columns > 0.
[[nodiscard]] std::vector<std::string> wrapped(std::string_view text, std::size_t columns);

}  // namespace geminga::shell

#endif
