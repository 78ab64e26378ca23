// The rows that tools/bench puts into its table: `name, size, figure, ratio, target, verdict`, separated by tabs, and
// behind them the baseline where there is one.
#ifndef GEMINGA_TESTS_BENCH_TABLE_HPP
#define GEMINGA_TESTS_BENCH_TABLE_HPP

#include <string>

namespace geminga::bench {

/// The bounds of a figure.
struct Goal {
  double baseline = 0;  ///< of the same run; 0: there is none, and no ratio is shown or judged
  double ratio = 0;     ///< at most as many times the baseline; 0: judged by nobody
  double limit = 0;     ///< at most this, whatever the baseline; 0: judged by nobody
};

/// Prints a row at once.
void row(const std::string& name, const std::string& size, double figure, const std::string& unit,
         const Goal& goal = {});
/// Prints a row without a figure, and the reason.
void row_without(const std::string& name, const std::string& size, const std::string& why);

}  // namespace geminga::bench

#endif
