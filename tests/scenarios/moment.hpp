// Times in words, and which of many is the longest but for a share of them.
#ifndef GEMINGA_TESTS_SCENARIOS_MOMENT_HPP
#define GEMINGA_TESTS_SCENARIOS_MOMENT_HPP

#include <string>
#include <vector>

#include "base/time.hpp"

namespace geminga::scenarios {

/// "12:05.250": minutes, seconds and thousandths.
[[nodiscard]] std::string moment(base::Duration since_start);
/// "2.4 ms", "4.48 s".
[[nodiscard]] std::string in_words(base::Duration duration);
/// The least of them that so many per cent do not exceed; 0 of none.
[[nodiscard]] base::Duration quantile(std::vector<base::Duration> durations, std::size_t percent);

}  // namespace geminga::scenarios

#endif
