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

void Tally::count(const Record& status, Time now) {
  const double uptime = number_of(status, "uptime");
  const bool is_first = before_.empty() || number_of(status, counters[0]) < before_[std::string(counters[0])];
  const double seconds = is_first ? uptime : std::chrono::duration<double>(now - taken_).count();
  for (const std::string_view counter : counters) {
    const double count = number_of(status, counter);
    double& before = before_[std::string(counter)];
    const double grown = is_first ? count : count - before;
    seen_.rates[std::string(counter)] = seconds > 0 ? std::max(grown, 0.0) / seconds : 0;
    before = count;
  }
}

void Tally::note_participants(const std::vector<Record>& participants, Time now) {
  for (const Record& record : participants) there_.insert_or_assign(std::string(record["id"]), std::pair(record, now));
  std::erase_if(there_, [&](const auto& one) { return now - one.second.second > shown_when_gone; });
  seen_.gone.clear();
  for (const auto& [id, last] : there_) {
    if (last.second == now) continue;
    seen_.gone.push_back({last.first, std::chrono::duration<double>(now - last.second).count()});
  }
}

void Tally::note_unmatched(const std::vector<Record>& unmatched, Time now) {
  decltype(since_) since;
  seen_.unmatched_for.clear();
  for (const Record& request : unmatched) {
    const std::string key(request["subscription"]);
    const auto known = since_.find(key);
    const Time first = known == since_.end() ? now : known->second;
    since.emplace(key, first);
    seen_.unmatched_for[key] = std::chrono::duration<double>(now - first).count();
  }
  since_ = std::move(since);
}

void Tally::take(Round round, Time now) {
  count(round.status, now);
  note_participants(round.participants, now);
  note_unmatched(round.unmatched, now);
  taken_ = now;
  seen_.round = std::move(round);
}

}  // namespace geminga::query::top
