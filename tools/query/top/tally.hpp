// Rates and durations, counted from one round of answers to the next.
#ifndef GEMINGA_QUERY_TOP_TALLY_HPP
#define GEMINGA_QUERY_TOP_TALLY_HPP

#include <chrono>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "geminga/client.hpp"

namespace geminga::query::top {

/// One round of answers.
struct Round {
  Record status;
  std::vector<Record> participants;
  std::vector<Record> unmatched;  ///< requests that nobody serves, with the likely reason of each
};

/// A participant that is not there any more, as it was last seen.
struct Gone {
  Record record;
  double seconds = 0;  ///< since then
};

/// The time for which a participant that is gone is shown.
inline constexpr std::chrono::minutes shown_when_gone{1};

/// All that the table shows of the team.
struct Seen {
  Round round;
  std::vector<Gone> gone;  ///< by their identifiers
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
  /// Forgets the former counters and participants: another daemon answers.
  void begin_anew() {
    before_ = {};
    there_ = {};
  }
  [[nodiscard]] const Seen& seen() const { return seen_; }

 private:
  void count(const Record& status, Time now);
  void note_participants(const std::vector<Record>& participants, Time now);
  void note_unmatched(const std::vector<Record>& unmatched, Time now);

  Seen seen_;
  std::map<std::string, double, std::less<>> before_;
  Time taken_{};
  /// The participants of the last minute, and when each was last there.
  std::map<std::string, std::pair<Record, Time>, std::less<>> there_;
  std::map<std::string, Time, std::less<>> since_;  ///< when each request was first seen without a provider
};

/// The number of a field, or 0.
[[nodiscard]] double number_of(const Record& record, std::string_view key);

}  // namespace geminga::query::top

#endif
