// The happenings of the last hour in the team, so that a page that is opened now can look back.
#ifndef GEMINGA_WEB_SITE_HISTORY_HPP
#define GEMINGA_WEB_SITE_HISTORY_HPP

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "answers/differences.hpp"
#include "web/asking/asker.hpp"
#include "web/site/limits.hpp"

namespace geminga::web {

/// Looks at participants, services and requests from time to time, and keeps what has changed for `span`: at most
/// max_happenings in max_history_octets, of which the eldest give way. What they did stays: the state before the first
/// happening is kept, too, so that the state at any moment since begin can be told. Neither copies nor moves.
class History {
 public:
  using Time = std::chrono::system_clock::time_point;

  /// Borrows the asker. With a span of 0 it keeps nothing, and asks for nothing.
  History(Asker& asker, std::chrono::seconds span) : asker_(asker), span_(span) {}
  History(const History&) = delete;
  History& operator=(const History&) = delete;

  /// Takes what is known at an instant: participants, services and requests by their keys.
  void observe(Time at, std::array<answers::Known, 3> now);
  /// Takes that nothing is known from this instant on, and why.
  void miss(Time at, const std::string& reason);
  /// Says that this is the whole of a recording of this name.
  void be_recording(std::string name) { recording_ = std::move(name); }
  /// Whether happenings had to give way to the limits.
  [[nodiscard]] bool is_cut() const { return is_cut_; }
  [[nodiscard]] Time begin() const { return begin_; }

  [[nodiscard]] bool keeps_anything() const { return span_.count() > 0; }
  /// Asks the daemon, and keeps what has changed as of `now`, perhaps after it returns. Does nothing while the last
  /// question waits for its answer. Each sample_every-th look takes a sample of the numbers, too.
  void look(Time now);

  /// `{"begin", "before", "changes", "samples"}` (tools/web/README.md, "The last hour"), in one line.
  [[nodiscard]] std::string document() const;

 private:
  static constexpr std::size_t kinds = 3;

  struct Happening {
    Time at;
    std::size_t kind = 0;  ///< of kind_words; behind them: the daemon
    std::string event;
    std::string key;
    std::string reason;
    std::string record;  ///< as JSON
    [[nodiscard]] std::size_t octets() const;
  };
  struct Sample {
    Time at;
    std::string numbers;  ///< a list in JSON
  };
  /// The answers of one look, of which some are still to come.
  struct Look {
    Time at;
    std::array<Outcome, kinds> outcomes;
    std::size_t missing = kinds;
  };

  void take(const Look& look);
  void compare(Time at, std::array<answers::Known, kinds> now);
  void sample(Time at);
  void take_sample(Time at, const Outcome& status);
  void keep(Happening happening);
  void drop_eldest();
  void drop_old(Time now);

  Asker& asker_;
  std::chrono::seconds span_;
  bool is_looking_ = false;
  bool has_begun_ = false;
  std::size_t looks_ = 0;
  std::array<answers::Known, kinds> known_;
  std::string absence_;    ///< why there is no daemon; empty: there is one
  std::string recording_;  ///< empty: of the present
  bool is_cut_ = false;
  Time end_{};  ///< of the last observation
  // Where the happenings begin.
  Time begin_{};
  std::string absence_before_;
  std::array<std::map<std::string, std::string>, kinds> before_;  ///< records as JSON by their keys
  std::deque<Happening> happenings_;
  std::size_t octets_ = 0;  ///< of the happenings
  std::deque<Sample> samples_;
};

}  // namespace geminga::web

#endif
