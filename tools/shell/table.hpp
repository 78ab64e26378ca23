// An aligned table for a reader at a terminal.
#ifndef GEMINGA_SHELL_TABLE_HPP
#define GEMINGA_SHELL_TABLE_HPP

#include <initializer_list>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "shell/terminal.hpp"
#include "shell/wrapping.hpp"

namespace geminga::shell {

struct Column {
  std::string title;
  bool is_right_aligned = false;
  /// The least width where the terminal is too narrow: cells run over several lines then. 0: cells stay in one line.
  std::size_t narrowest = 0;
  /// Where the terminal is still too narrow, the column with the greatest rank is left out first; 0: never.
  unsigned rank = 0;
  /// Whether its text heads the rows that have the same one, in lines of its own, where the terminal is too narrow for
  /// a column. For sentences; at most one column of a table.
  bool is_heading = false;
};

/// Makes cells printable. A column of empty cells is left out; other empty cells are shown as `-`.
///
/// On a terminal no line is longer than its width. No text is cut: long cells go on in the next line, a cell with a
/// word that is wider than its column moves what follows to the right or into the next line, and the columns that are
/// left out are named below the table. Where the titles, or most of the rows, would not stay side by side, each row is
/// a block of lines instead: a title and a cell in each, all columns, and none for an empty cell. Where sentences
/// become headings, rows without one come first, and rows with the same one stand together, in the order of the first
/// of each.
class Table {
 public:
  explicit Table(std::vector<Column> columns) : columns_(std::move(columns)) {}

  /// Adds a row. Requires as many cells as columns.
  void add(std::initializer_list<std::string_view> cells);
  /// Prints the rows under `above` and the titles in bold, with two spaces between columns and none at the end of a
  /// line. Prints nothing where there are no rows.
  void print(std::ostream& out, const Terminal& terminal, std::string_view above = {}) const;

 private:
  using Row = std::vector<std::string>;
  /// A cell, or the lines of one, at its place in a row.
  struct Placed {
    std::size_t begin = 0;
    std::size_t width = 0;
    bool is_right_aligned = false;
    std::vector<std::string> lines;
  };
  /// The widths of the columns on one terminal; a width of 0 is a column that is not shown.
  struct Layout {
    std::vector<std::size_t> widths;
    std::vector<std::string> left_out;
    std::size_t heading;     ///< the column whose text heads rows; no column: the number of columns
    std::size_t indent = 0;  ///< of titles and rows
  };

  [[nodiscard]] Layout layout_for(const Terminal& terminal) const;
  /// The cells of a row, in groups that fit side by side; one group where the whole row does.
  [[nodiscard]] std::vector<std::vector<Placed>> placed(const Terminal& terminal, const Layout& layout,
                                                        const Row& cells) const;
  static void print_cells(std::ostream& out, const Terminal& terminal, const std::vector<Placed>& cells);
  /// The width of each column's longest cell; 0 where all cells are empty.
  [[nodiscard]] std::vector<std::size_t> natural_widths() const;
  /// The least width of each column that breaks no word, unless that is too much.
  [[nodiscard]] std::vector<std::size_t> word_widths(const std::vector<std::size_t>& natural) const;
  /// Whether the titles, or most of the rows, do not stay side by side.
  [[nodiscard]] bool is_torn(const Terminal& terminal, const Layout& layout) const;
  /// The groups of rows, each below its heading, by a function that prints one row. `between` separates rows and
  /// groups.
  template <typename PrintRow>
  void print_groups(std::ostream& out, const Terminal& terminal, const Layout& layout, std::string_view between,
                    PrintRow print) const;
  void print_blocks(std::ostream& out, const Terminal& terminal, const Layout& layout) const;

  std::vector<Column> columns_;
  std::vector<Row> rows_;
};

}  // namespace geminga::shell

#endif
