// The best one-to-one assignment of offered parameters to required ones.
#ifndef GEMINGA_REASONING_SIGNATURE_ASSIGNMENT_HPP
#define GEMINGA_REASONING_SIGNATURE_ASSIGNMENT_HPP

#include <cstddef>
#include <optional>
#include <vector>

namespace geminga::signature {

/// How much each column is worth to each row, in [0, 1].
class Worth {
 public:
  Worth(std::size_t rows, std::size_t columns) : rows_(rows), columns_(columns), values_(rows * columns) {}
  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] std::size_t columns() const { return columns_; }
  [[nodiscard]] double& at(std::size_t row, std::size_t column) { return values_[row * columns_ + column]; }
  [[nodiscard]] double at(std::size_t row, std::size_t column) const { return values_[row * columns_ + column]; }

 private:
  std::size_t rows_;
  std::size_t columns_;
  std::vector<double> values_;
};

/// The column of each row such that the sum of their worth is as large as possible. If there are fewer columns than
/// rows, some rows get none. Kuhn's and Munkres' method with potentials: O(n^3).
[[nodiscard]] std::vector<std::optional<std::size_t>> best_assignment(const Worth& worth);

}  // namespace geminga::signature

#endif
