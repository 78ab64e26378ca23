#include "bench/reasoner/table.hpp"

#include <cstdio>

namespace geminga::bench {

void row(const std::string& name, const std::string& size, double figure, const std::string& unit, const Goal& goal) {
  const double ratio = goal.baseline > 0 ? figure / goal.baseline : 0;
  const double judged = goal.baseline > 0 ? ratio : figure;
  std::printf("%s\t%s\t%.4g %s\t", name.c_str(), size.c_str(), figure, unit.c_str());
  if (goal.baseline > 0) {
    std::printf("%.2f\t", ratio);
  } else {
    std::printf("-\t");
  }
  if (goal.at_most > 0) {
    std::printf("%g%s\t%s\n", goal.at_most, goal.baseline > 0 ? "" : (" " + unit).c_str(),
                judged <= goal.at_most ? "ok" : "over");
  } else {
    std::printf("-\t-\n");
  }
  std::fflush(stdout);
}

void row_without(const std::string& name, const std::string& size, const std::string& why) {
  std::printf("%s\t%s\t-\t-\t-\t%s\n", name.c_str(), size.c_str(), why.c_str());
  std::fflush(stdout);
}

}  // namespace geminga::bench
