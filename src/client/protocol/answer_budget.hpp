// The number of answers to datagrams that a publisher may give now.
#ifndef GEMINGA_CLIENT_PROTOCOL_ANSWER_BUDGET_HPP
#define GEMINGA_CLIENT_PROTOCOL_ANSWER_BUDGET_HPP

#include <algorithm>
#include <cstdint>

#include "base/time.hpp"
#include "client/protocol/limits.hpp"

namespace geminga::client {

/// max_answers at once, and max_answers a second.
class AnswerBudget {
 public:
  /// Whether one more answer may be given; takes it from the budget.
  [[nodiscard]] bool take(base::Instant now) { return take(now, max_answers); }
  /// The same of an answer that renews what is accepted already: only while more than half of the budget is left, so
  /// that many listeners leave answers for newcomers.
  [[nodiscard]] bool take_renewal(base::Instant now) { return take(now, max_answers / 2); }

 private:
  bool take(base::Instant now, std::size_t most) {
    constexpr base::Duration cost = base::Duration(std::chrono::seconds(1)) / max_answers;
    // The instant at which the budget would be whole again.
    const base::Instant whole = std::max(whole_, now);
    if (whole + cost > now + cost * most) return false;
    whole_ = whole + cost;
    return true;
  }

  base::Instant whole_{};
};

}  // namespace geminga::client

#endif
