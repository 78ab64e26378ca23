// Decides which lines a recording gets, from what a daemon answers.
#ifndef GEMINGA_RECORDING_RECORDER_HPP
#define GEMINGA_RECORDING_RECORDER_HPP

#include <cstdint>
#include <expected>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "recording/allowance.hpp"
#include "recording/entry.hpp"
#include "recording/state.hpp"

namespace geminga::recording {

/// The limit of octets in an hour where none is told, and the bounds of those that may be told, in MiB.
inline constexpr std::uint64_t usual_limit_mib = 64;
inline constexpr std::uint64_t least_limit_mib = 1;
inline constexpr std::uint64_t most_limit_mib = 65'536;

/// The time between two snapshots. Shorter: a damaged line is mended sooner, and the recording is larger. Longer: the
/// reverse.
inline constexpr At snapshot_interval = std::chrono::minutes(5);
/// The time between two signs of life of all participants.
inline constexpr At heard_interval = std::chrono::seconds(1);
/// The most requests that are asked about in a round of reasons.
inline constexpr std::size_t max_reasons_in_round = 32;

/// One round of answers: the records of participants, services and requests. Requests that nobody serves and services
/// that nobody asks for have `why` and `because`, too.
struct Observation {
  std::vector<Record> participants;
  std::vector<Record> services;
  std::vector<Record> requests;
};

/// Holds what has been written, and gives lines for what differs. Does no input or output. What is over the limit is
/// not written, but counted, and the next thing that is written is a snapshot: the recording becomes coarser, not
/// wrong. Times never run backwards. Not thread-safe.
class Recorder {
 public:
  /// `source` describes the daemon; its `records` mean nothing.
  Recorder(Snapshot source, std::uint64_t octets_an_hour) : source_(std::move(source)), allowance_(octets_an_hour) {}

  /// The lines for a round, perhaps none. The error is a line for the user: the state alone is over the limit.
  [[nodiscard]] std::expected<std::string, std::string> observe(const Observation& seen, At at, Time time);
  /// The line for an answer about the daemon itself, or about a request (`subscription` of `why`); empty where it is
  /// the one that was written last, or over the limit.
  [[nodiscard]] std::string answered(const Answered& answered, At at, Time time);
  /// The requests to ask `why` about: those that are new or changed, or for which services may have changed, at most
  /// max_reasons_in_round of them, each in its turn.
  [[nodiscard]] std::vector<std::string> requests_to_ask();
  /// The line that says that the daemon is gone. The next round is a snapshot, by this daemon.
  [[nodiscard]] std::string lost(const std::string& text, At at, Time time);
  void found_again(Snapshot source) { source_ = std::move(source); }
  /// The line that ends the recording.
  [[nodiscard]] std::string end(const std::string& reason, At at, Time time);

  /// The rounds that were not written because of the limit.
  [[nodiscard]] std::size_t skipped_in_all() const { return skipped_in_all_; }

 private:
  using Known = std::map<std::string, Records, std::less<>>;

  [[nodiscard]] std::string snapshot_of(const Known& now, At at, Time time) const;
  [[nodiscard]] std::string changes_to(const Known& now, At at, Time time) const;
  void mark_to_ask(const Known& now);
  void skip();

  Snapshot source_;
  Allowance allowance_;
  Known known_;
  std::map<std::string, std::string, std::less<>> answers_;  ///< the last one of each kind and subscription
  std::set<std::string, std::less<>> to_ask_;
  std::string last_asked_;
  At last_snapshot_{};
  At last_heard_{};
  std::uint64_t snapshot_octets_ = 0;
  std::size_t skipped_ = 0;  ///< rounds since the last line
  std::size_t skipped_in_all_ = 0;
  bool needs_snapshot_ = true;
};

}  // namespace geminga::recording

#endif
