// Rows are added one after the other, each by the cheapest augmenting path (Jonker and Volgenant 1987). The matrix is
// made square by rows and columns that are worth nothing.
#include "reasoning/signature/assignment.hpp"

#include <algorithm>
#include <limits>

namespace geminga::signature {

std::vector<std::optional<std::size_t>> best_assignment(const Worth& worth) {
  const std::size_t size = std::max(worth.rows(), worth.columns());
  const auto cost = [&](std::size_t row, std::size_t column) {
    return row < worth.rows() && column < worth.columns() ? 1 - worth.at(row, column) : 1.0;
  };
  // Row and column `size` stand for no row and no column.
  std::vector<double> of_row(size + 1, 0);
  std::vector<double> of_column(size + 1, 0);
  std::vector<std::size_t> row_of(size + 1, size);
  std::vector<std::size_t> before(size + 1, size);
  for (std::size_t added = 0; added < size; ++added) {
    std::vector<double> slack(size + 1, std::numeric_limits<double>::infinity());
    std::vector<bool> is_used(size + 1, false);
    std::size_t column = size;
    row_of[size] = added;
    while (row_of[column] != size) {
      is_used[column] = true;
      const std::size_t row = row_of[column];
      std::size_t next = size;
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t other = 0; other < size; ++other) {
        if (is_used[other]) continue;
        const double reduced = cost(row, other) - of_row[row] - of_column[other];
        if (reduced < slack[other]) {
          slack[other] = reduced;
          before[other] = column;
        }
        if (slack[other] < least) {
          least = slack[other];
          next = other;
        }
      }
      for (std::size_t other = 0; other <= size; ++other) {
        if (is_used[other]) {
          of_row[row_of[other]] += least;
          of_column[other] -= least;
        } else {
          slack[other] -= least;
        }
      }
      column = next;
    }
    while (column != size) {
      row_of[column] = row_of[before[column]];
      column = before[column];
    }
    row_of[size] = size;
  }
  std::vector<std::optional<std::size_t>> column_of(worth.rows());
  for (std::size_t column = 0; column < worth.columns(); ++column) {
    if (row_of[column] < worth.rows()) column_of[row_of[column]] = column;
  }
  return column_of;
}

}  // namespace geminga::signature
