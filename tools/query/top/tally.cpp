#include "query/top/tally.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace geminga::query::top {
namespace {

/// The counters whose rates are shown.
constexpr std::array<std::string_view, 4> counters{"datagrams_received", "bytes_received", "datagrams_sent",
                                                   "bytes_sent"};

}  // namespace

double number_of(const Record& record, std::string_view key) {
  const double number = std::strtod(std::string(record[key]).c_str(), nullptr);
  return std::isfinite(number) ? number : 0;
}

void Tally::take(Round round, Time now) {
  const double uptime = number_of(round.status, "uptime");
  const bool is_first = before_.empty() || number_of(round.status, counters[0]) < before_[std::string(counters[0])];
  const double seconds = is_first ? uptime : std::chrono::duration<double>(now - taken_).count();
  for (const std::string_view counter : counters) {
    const double count = number_of(round.status, counter);
    double& before = before_[std::string(counter)];
    const double grown = is_first ? count : count - before;
    seen_.rates[std::string(counter)] = seconds > 0 ? std::max(grown, 0.0) / seconds : 0;
    before = count;
  }
  taken_ = now;
  decltype(since_) since;
  seen_.unmatched_for.clear();
  for (const Record& request : round.unmatched) {
    const std::string key(request["subscription"]);
    const auto known = since_.find(key);
    const Time first = known == since_.end() ? now : known->second;
    since.emplace(key, first);
    seen_.unmatched_for[key] = std::chrono::duration<double>(now - first).count();
  }
  since_ = std::move(since);
  seen_.round = std::move(round);
}

}  // namespace geminga::query::top
