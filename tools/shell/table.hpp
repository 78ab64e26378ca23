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
  /// May be cut to `narrowest` columns where the terminal is too narrow; 0: never cut.
  std::size_t narrowest = 0;
};

/// Cells are made printable. A column in which every cell is empty is left out; an empty cell is shown as `-`.
class Table {
 public:
  explicit Table(std::vector<Column> columns) : columns_(std::move(columns)) {}

  /// Requires as many cells as columns.
  void add(std::vector<std::string> cells);
  [[nodiscard]] bool is_empty() const { return rows_.empty(); }
  /// Two spaces between columns, no space at the end of a line, the titles in bold.
  void print(std::ostream& out, const Terminal& terminal) const;

 private:
  std::vector<Column> columns_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace geminga::shell

#endif
