// Rates and durations, counted from one round of answers to the next.
#ifndef GEMINGA_QUERY_TOP_TALLY_HPP
#define GEMINGA_QUERY_TOP_TALLY_HPP

#include <chrono>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "geminga/client.hpp"

namespace geminga::query::top {

/// One round of answers.
struct Round {
  Record status;
  std::vector<Record> participants;
  std::vector<Record> unmatched;  ///< requests that nobody serves, with the likely reason of each
};

/// All that the table shows of the team.
struct Seen {
  Round round;
  /// Of the counters of the status, per second: since the round before, or since the daemon's start for the first.
  std::map<std::string, double, std::less<>> rates;
  /// The seconds for which each request has been seen to have no provider.
  std::map<std::string, double, std::less<>> unmatched_for;
};

/// Copies nothing but the round. Times never run backwards.
class Tally {
 public:
  using Time = std::chrono::milliseconds;

  void take(Round round, Time now);
  /// Forgets the former counters: another daemon answers.
  void begin_anew() { before_ = {}; }
  [[nodiscard]] const Seen& seen() const { return seen_; }

 private:
  Seen seen_;
  std::map<std::string, double, std::less<>> before_;
  Time taken_{};
  std::map<std::string, Time, std::less<>> since_;  ///< when each request was first seen without a provider
};

/// The number of a field, or 0.
[[nodiscard]] double number_of(const Record& record, std::string_view key);

}  // namespace geminga::query::top

#endif
