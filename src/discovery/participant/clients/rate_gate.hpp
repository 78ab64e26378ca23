// A rate gate counts the statements of one client in a second, and says when they are too many.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_RATE_GATE_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_RATE_GATE_HPP

#include <algorithm>
#include <cstddef>

#include "base/time.hpp"

namespace geminga::participant {

/// Windows of one second each, the first of which begins with the first statement in it.
class RateGate {
 public:
  enum class Verdict {
    pass,    ///< within the limit
    refuse,  ///< over the limit: answer 429
    flood,   ///< far over it: close the connection
  };

  /// `limit` statements a second pass; `flood` more are refused; the next one is a flood.
  RateGate(std::size_t limit, std::size_t flood) : limit_(limit), flood_(flood) {}

  Verdict count(base::Instant now) {
    if (now - begin_ >= std::chrono::seconds(1)) {
      begin_ = now;
      seen_ = 0;
    }
    ++seen_;
    if (seen_ <= limit_) return Verdict::pass;
    return seen_ - limit_ <= flood_ ? Verdict::refuse : Verdict::flood;
  }

  /// Counts the work that a statement made, beyond the statement itself, as if it had been so many more. Never makes a
  /// flood by itself: only lines do.
  void charge(std::size_t statements) {
    if (seen_ < limit_) seen_ += std::min(statements, limit_ - seen_);
  }

 private:
  std::size_t limit_;
  std::size_t flood_;
  std::size_t seen_ = 0;
  base::Instant begin_ = base::Instant() - std::chrono::hours(1);
};

}  // namespace geminga::participant

#endif
