#include "bench/table.hpp"

#include <cstdio>

namespace geminga::bench {

void row(const std::string& name, const std::string& size, double figure, const std::string& unit, const Goal& goal) {
  std::printf("%s\t%s\t%.4g %s\t", name.c_str(), size.c_str(), figure, unit.c_str());
  if (goal.baseline > 0) {
    const double ratio = figure / goal.baseline;
    std::printf("%.2f\t", ratio);
    if (goal.ratio > 0) {
      std::printf("%.2g\t%s\t", goal.ratio, ratio <= goal.ratio ? "ok" : "over");
    } else {
      std::printf("-\t-\t");
    }
    std::printf("%.4g %s\n", goal.baseline, unit.c_str());
  } else if (goal.limit > 0) {
    std::printf("-\t%g %s\t%s\n", goal.limit, unit.c_str(), figure <= goal.limit ? "ok" : "over");
  } else {
    std::printf("-\t-\t-\n");
  }
  std::fflush(stdout);
}

void row_without(const std::string& name, const std::string& size, const std::string& why) {
  std::printf("%s\t%s\t-\t-\t-\t%s\n", name.c_str(), size.c_str(), why.c_str());
  std::fflush(stdout);
}

}  // namespace geminga::bench
