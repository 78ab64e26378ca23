#include "scenarios/moment.hpp"

#include <algorithm>
#include <cstdio>

namespace geminga::scenarios {

std::string moment(base::Duration since_start) {
  const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(since_start).count();
  char text[40];
  std::snprintf(text, sizeof text, "%3lld:%02lld.%03lld", static_cast<long long>(ms / 60'000),
                static_cast<long long>(ms / 1000 % 60), static_cast<long long>(ms % 1000));
  return text;
}

std::string in_words(base::Duration duration) {
  const auto us = std::chrono::duration_cast<std::chrono::microseconds>(duration).count();
  char text[40];
  if (us < 1'000'000) {
    std::snprintf(text, sizeof text, "%.3g ms", static_cast<double>(us) / 1e3);
  } else {
    std::snprintf(text, sizeof text, "%.3g s", static_cast<double>(us) / 1e6);
  }
  return text;
}

base::Duration quantile(std::vector<base::Duration> durations, std::size_t percent) {
  if (durations.empty()) return {};
  const auto at = durations.begin() + static_cast<std::ptrdiff_t>((durations.size() - 1) * percent / 100);
  std::ranges::nth_element(durations, at);
  return *at;
}

}  // namespace geminga::scenarios
