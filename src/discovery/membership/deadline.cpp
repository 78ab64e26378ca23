// The arithmetic of deadlines.
#include "discovery/membership/deadline.hpp"

#include <algorithm>
#include <cmath>

namespace geminga::membership {

base::Instant after_intervals(base::Instant seen, base::Duration interval, double intervals) {
  return seen + base::Duration(static_cast<base::Duration::rep>(static_cast<double>(interval.count()) * intervals));
}

base::Duration answer_time(double loss) {
  const double miss_denials = std::pow(loss, denials);
  if (miss_denials <= wrong_successions) return least_answer_time;
  // What is missing is asked for: a question and its answer must both arrive.
  const double miss_round = std::min(1 - (1 - loss) * (1 - loss), 0.9);
  const double rounds = std::ceil(std::log(wrong_successions / miss_denials) / std::log(miss_round));
  return after_intervals(base::Instant{} + least_answer_time, question_time, rounds) - base::Instant{};
}

base::Duration patience(base::Duration interval, const Reception& reception) {
  // With witnesses it takes a loss on all ways at once. The fewer there are, the more our own tries count, so there
  // must be more of them.
  const double alone = 1 - static_cast<double>(std::min(reception.witnesses, enough_witnesses)) / enough_witnesses;
  const double more = std::max(2.5 * (reception.loss - 0.2), 10 * reception.loss * reception.loss * alone);
  const double intervals = std::min(shortest_deadline + std::max(0.0, more), longest_deadline);
  const auto least = after_intervals(base::Instant{}, interval, doubt_after) + least_questions * question_time;
  return std::max(after_intervals(base::Instant{}, interval, intervals), least) - base::Instant{};
}

}  // namespace geminga::membership
