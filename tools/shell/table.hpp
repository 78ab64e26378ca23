// An aligned table for a reader at a terminal.
#ifndef GEMINGA_SHELL_TABLE_HPP
#define GEMINGA_SHELL_TABLE_HPP

#include <ostream>
#include <string>
#include <vector>

#include "shell/terminal.hpp"

namespace geminga::shell {

struct Column {
  std::string title;
  bool is_right_aligned = false;
  /// The cells may run over several lines where the terminal is too narrow, down to this width, but words are not
  /// broken as long as another column may go instead; 0: never.
  std::size_t narrowest = 0;
  /// Where the terminal is too narrow all the same the column with the greatest rank is left out first; 0: never.
  unsigned rank = 0;
};

/// Cells are made printable. A column in which every cell is empty is left out; an empty cell is shown as `-`.
///
/// On a terminal no line is longer than it is wide, unless even the columns of rank 0 do not fit at their narrowest. No
/// text is cut: what is too long goes on in the next line, and columns that are left out are named below the table.
class Table {
 public:
  explicit Table(std::vector<Column> columns) : columns_(std::move(columns)) {}

  /// Requires as many cells as columns.
  void add(std::vector<std::string> cells);
  [[nodiscard]] bool is_empty() const { return rows_.empty(); }
  /// Two spaces between columns, no space at the end of a line, the titles in bold.
  void print(std::ostream& out, const Terminal& terminal) const;

 private:
  /// The width of each column as it takes, 0 where it has nothing.
  [[nodiscard]] std::vector<std::size_t> natural_widths() const;
  /// The least width of each column that breaks no word, where that is not too much.
  [[nodiscard]] std::vector<std::size_t> word_widths(const std::vector<std::size_t>& natural) const;
  void print_row(std::ostream& out, const Terminal& terminal, const std::vector<std::size_t>& widths,
                 const std::vector<std::string>& cells) const;

  std::vector<Column> columns_;
  std::vector<std::vector<std::string>> rows_;
};

/// A printable text in lines of at most `columns`, broken behind a space or one of `/ , ; | =` where there is one in
/// the second half of a line. At least one line. Requires columns > 0.
[[nodiscard]] std::vector<std::string> wrapped(std::string_view text, std::size_t columns);

}  // namespace geminga::shell

#endif
