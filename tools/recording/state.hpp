// The state of a team at one moment of a recording.
#ifndef GEMINGA_RECORDING_STATE_HPP
#define GEMINGA_RECORDING_STATE_HPP

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "recording/entry.hpp"

namespace geminga::recording {

/// The records of one kind by their keys.
using Records = std::map<std::string, Record, std::less<>>;

/// Each entry is applied once, in the order of the recording. Copies.
class State {
 public:
  void apply(const Entry& entry);
  /// Sets the moment for which ages are told. Requires one that is not before the last entry.
  void stand_at(At now) { now_ = now; }

  /// The records of participants, services or requests; empty for another kind.
  [[nodiscard]] const Records& of(std::string_view kind) const;
  /// A record of of(kind) with `heard` and `age` as they are at this moment: RECORDING.md, "Ages".
  [[nodiscard]] Record aged(const Record& record) const;
  /// The answer to a query about the daemon itself, or null.
  [[nodiscard]] const Answer* answer(std::string_view kind) const;
  /// The answer to `why` about this request, or null.
  [[nodiscard]] const Answer* why(std::string_view subscription) const;
  /// The answer to `match` for the concept of this request, or null.
  [[nodiscard]] const Answer* matches(std::string_view subscription) const;

  [[nodiscard]] const Snapshot& source() const { return source_; }
  /// The reason why the daemon could not be asked at this moment; empty: it could.
  [[nodiscard]] const std::string& lost() const { return lost_; }
  /// The clock of the recording host at this moment.
  [[nodiscard]] Time time() const { return last_time_ + (now_ - last_); }

 private:
  /// A sign of life: what was heard, and when that was told.
  struct Sign {
    std::string heard;
    std::string loss;
    std::string loss_least;
    At at{};
  };

  [[nodiscard]] Sign sign_of(const Record& record) const;

  void take(const Snapshot& snapshot);
  void take(const Present& present);
  void take(const Gone& gone);
  void take(const Heard& heard);
  void take(const Answered& answered);
  void take(const Lost& lost) { lost_ = lost.text; }
  void take(const Skipped&) {}
  void take(const End&) {}
  void take(const Unknown&) {}
  /// Drops all records that a whole snapshot did not name.
  void finish_snapshot();
  [[nodiscard]] std::optional<std::string> heard(std::string_view participant) const;

  Snapshot source_;
  std::map<std::string, Records, std::less<>> records_;
  std::map<std::string, Sign, std::less<>> signs_;
  std::map<std::string, Answer, std::less<>> answers_;
  std::map<std::string, Answer, std::less<>> whys_;
  std::map<std::string, Answer, std::less<>> matches_;  ///< by request, as whys_
  std::string lost_;
  /// The kinds and keys that the present snapshot has named; nothing: there is none in progress.
  std::optional<std::set<std::pair<std::string, std::string>>> named_;
  At last_{};  ///< of the last entry
  Time last_time_{};
  At now_{};
};

}  // namespace geminga::recording

#endif
